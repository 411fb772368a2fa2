#include "verification/exact/joint_waves.h"

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace exact {
namespace {

using Complex = std::complex<double>;
using Transfer = Eigen::Matrix2cd;

// (velocity, stress) behind a joint from those before it: velocity gains i omega stress/stiffness.
Transfer across_joint(double omega, double stiffness) {
  return (Transfer() << 1, Complex(0, omega / stiffness), 0, 1).finished();
}

// The same across `length` of rock. With v = a exp(-ikx) + b exp(ikx), stress = Z (-a exp(-ikx) + b exp(ikx)).
Transfer across_rock(double omega, double impedance, double length, double speed) {
  const double phase = omega * length / speed;
  return (Transfer() << std::cos(phase), Complex(0, std::sin(phase) / impedance),
          Complex(0, impedance * std::sin(phase)), std::cos(phase))
      .finished();
}

}  // namespace

Complex linear_joint_transmission(double omega, double impedance, double stiffness) {
  return 1.0 / Complex(1, omega * impedance / (2 * stiffness));
}

Complex joints_transmission(double omega, double impedance, double stiffness, int joints, double spacing,
                            double speed) {
  Transfer all = across_joint(omega, stiffness);
  for (int i = 1; i < joints; ++i)
    all = across_joint(omega, stiffness) * across_rock(omega, impedance, spacing, speed) * all;
  // Before: v = 1 + r, stress = Z (-1 + r); behind: v = t, stress = -Z t. The inverse of `all` has determinant 1.
  const Complex a = all(0, 0);
  const Complex b = all(0, 1);
  const Complex c = all(1, 0);
  const Complex d = all(1, 1);
  return 2.0 / (a + d + b * impedance + c / impedance);
}

SlipJointEnergies slip_joint(double strength) {
  if (strength >= 1) return {1, 0, 0};
  // Quarter of a period: sin below the strength until `slip`, the strength from there on. Means over sin^2's mean, 1/2.
  const double slip = std::asin(strength);
  const double quarter = std::numbers::pi / 2;
  const double left = quarter - slip;
  const double sine_squared_after = left / 2 + std::sin(2 * slip) / 4;
  const double stuck = slip / 2 - std::sin(2 * slip) / 4;
  const double transmitted = (stuck + strength * strength * left) / (quarter / 2);
  const double reflected =
      (sine_squared_after - 2 * strength * std::cos(slip) + strength * strength * left) / (quarter / 2);
  return {std::sqrt(transmitted), std::sqrt(reflected), std::sqrt(1 - transmitted - reflected)};
}

Complex fourier(std::span<const double> samples, double dt, double omega) {
  Complex sum = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
    sum += samples[i] * std::polar(1.0, -omega * dt * static_cast<double>(i));
  return sum * dt;
}

}  // namespace exact
