#include "verification/exact/joint_waves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace exact {
namespace {

constexpr double impedance = 7e6;
constexpr double stiffness = 5e9;
constexpr double speed = 2700;

TEST(LinearJoint, StiffPassesSoftReflectsAndHalfPowerLiesBetween) {
  EXPECT_NEAR(std::abs(linear_joint_transmission(1e-3, impedance, stiffness)), 1, 1e-12);
  EXPECT_NEAR(std::abs(linear_joint_transmission(2 * stiffness / impedance, impedance, stiffness)), std::sqrt(0.5),
              1e-12);
  EXPECT_NEAR(std::abs(linear_joint_transmission(1e12, impedance, stiffness)), 0, 1e-5);
}

TEST(ParallelJoints, OneIsTheLinearJoint) {
  for (const double omega : {10.0, 800.0, 5000.0})
    EXPECT_LT(std::abs(joints_transmission(omega, impedance, stiffness, 1, 3, speed) -
                       linear_joint_transmission(omega, impedance, stiffness)),
              1e-12);
}

// Joints at no distance are one joint of their summed compliance; stiff joints are none, with the delay of the way.
TEST(ParallelJoints, LimitsOfDistanceAndStiffness) {
  const double omega = 900;
  EXPECT_LT(std::abs(joints_transmission(omega, impedance, stiffness, 4, 0, speed) -
                     linear_joint_transmission(omega, impedance, stiffness / 4)),
            1e-12);
  const auto delay = std::polar(1.0, -omega * 3 * 2.5 / speed);
  EXPECT_LT(std::abs(joints_transmission(omega, impedance, 1e20, 4, 2.5, speed) - delay), 1e-9);
}

// Numbers of the verification catalogue, to its four digits.
TEST(SlipJoint, IsMillersTable) {
  const double rows[3][4] = {{.2, .2705, .7532, .5996}, {.5, .6253, .4159, .6603}, {.8, .8995, .1315, .4166}};
  for (const auto& [strength, transmitted, reflected, absorbed] : rows) {
    const SlipJointEnergies energies = slip_joint(strength);
    EXPECT_NEAR(energies.transmitted, transmitted, 6e-5);
    EXPECT_NEAR(energies.reflected, reflected, 6e-5);
    EXPECT_NEAR(energies.absorbed, absorbed, 6e-5);
  }
}

// By quadrature of the clipped wave.
TEST(SlipJoint, IsTheClippedWave) {
  constexpr int samples = 100000;
  double passed = 0;
  double sent_back = 0;
  for (int i = 0; i < samples; ++i) {
    const double incident = std::sin(2 * std::numbers::pi * (i + 0.5) / samples);
    const double clipped = std::clamp(incident, -0.35, 0.35);
    passed += 2 * clipped * clipped / samples;
    sent_back += 2 * (incident - clipped) * (incident - clipped) / samples;
  }
  EXPECT_NEAR(slip_joint(0.35).transmitted, std::sqrt(passed), 1e-8);
  EXPECT_NEAR(slip_joint(0.35).reflected, std::sqrt(sent_back), 1e-8);
}

TEST(Fourier, OfAGaussian) {
  const double width = 1e-3;
  std::vector<double> samples;
  for (int i = 0; i < 2000; ++i) samples.push_back(std::exp(-std::pow((i * 1e-5 - 0.01) / width, 2) / 2));
  const double omega = 900;
  const auto expected = width * std::sqrt(2 * std::numbers::pi) * std::exp(-std::pow(omega * width, 2) / 2) *
                        std::polar(1.0, -omega * 0.01);
  EXPECT_LT(std::abs(fourier(samples, 1e-5, omega) - expected), 1e-9);
}

}  // namespace
}  // namespace exact
