#include "verification/exact/finite_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "verification/exact/bar_stress.h"
#include "verification/exact/dense_chain.h"

namespace exact {
namespace {

constexpr double kYoung = 50e9, kDensity = 2650;

// The closed form claims 1e-11; the dense solution adds its round-off, about 1e-16 (k/E11) (steps) of the peak.
constexpr double kAgreement = 1e-10;

BlockChain rock_chain(int blocks, double length, double poisson, const InterfaceLaw& law) {
  BlockChain chain;
  chain.blocks = blocks;
  chain.length = length;
  chain.density = kDensity;
  chain.elasticity = plane_stress(kYoung, poisson);
  chain.interface = law;
  return chain;
}

std::vector<double> pulse_load(double dt, int steps, double frequency = 200) {
  std::vector<double> load;
  for (int i = 0; i <= steps; ++i) load.push_back(pulse_force({1e6, frequency}, i * dt));
  return load;
}

double largest(const std::vector<double>& history) {
  double peak = 0;
  for (const double value : history) peak = std::max(peak, std::abs(value));
  return peak;
}

double relative_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference = std::max(difference, std::abs(a[i] - b[i]));
  return difference / largest(b);
}

std::vector<ChainProbe> all_probes(const BlockChain& chain) {
  const int last = chain.blocks - 1;
  return {{ChainQuantity::block_stress, 0},           {ChainQuantity::block_stress, last / 2},
          {ChainQuantity::block_stress, last},        {ChainQuantity::displacement, 0},
          {ChainQuantity::displacement, last / 2},    {ChainQuantity::displacement, last},
          {ChainQuantity::interface_force, 0},        {ChainQuantity::interface_force, last - 1},
          {ChainQuantity::interface_stress, last / 2}};
}

void expect_agreement(const BlockChain& chain, const TimeScheme& scheme, double dt, const std::vector<double>& load,
                      const std::string& what) {
  const std::vector<ChainProbe> probes = all_probes(chain);
  const ChainHistories closed = finite_chain_response(chain, scheme, dt, load, probes);
  const ChainHistories dense = dense_chain_response(chain, scheme, dt, load, probes);
  for (std::size_t i = 0; i < probes.size(); ++i) {
    ASSERT_GT(largest(dense[i]), 0) << what;
    EXPECT_LT(relative_difference(closed[i], dense[i]), kAgreement) << what << ", probe " << i;
  }
}

std::vector<TimeScheme> all_schemes() { return {thesis_scheme(), trapezoidal(), hht(0.1), generalized_alpha(0.8)}; }

std::vector<InterfaceLaw> all_laws() {
  return {corner_springs(10 * kYoung, 4 * kYoung),
          corner_springs(10 * kYoung, 0),
          consistent_edge(4 * kYoung, 0.4 * kYoung),
          consistent_edge(4 * kYoung, 0),
          cubic_edge(),
          cubic_edge(0.02)};
}

TEST(FiniteChain, AgreesWithTheDenseSolutionForEverySchemeLawAndPoissonRatio) {
  const double dt = 2e-5;
  for (const TimeScheme& scheme : all_schemes()) {
    for (const InterfaceLaw& law : all_laws()) {
      for (const double poisson : {0.0, 0.25}) {
        expect_agreement(rock_chain(12, 1.0, poisson, law), scheme, dt, pulse_load(dt, 500),
                         "beta " + std::to_string(scheme.beta) + " consistent " + std::to_string(law.consistent) +
                             " kt " + std::to_string(law.tangential_half) + " nu " + std::to_string(poisson));
      }
    }
  }
}

TEST(FiniteChain, AgreesForOtherShapesAndEnds) {
  const double dt = 1e-4;
  for (const InterfaceLaw& law : all_laws()) {
    BlockChain chain = rock_chain(17, 2.5, 0.27, law);
    chain.elasticity = plane_strain(kYoung, 0.27);
    chain.height = 0.8;
    chain.inertia_factor = 2;
    chain.end_impedance = 0.9 * kDensity * 4343 * chain.height;
    expect_agreement(chain, trapezoidal(), dt, pulse_load(dt, 400, 100), "dashpot");
    chain.end_stiffness = 0.5 * kYoung;
    expect_agreement(chain, generalized_alpha(0.6), dt, pulse_load(dt, 400, 100), "dashpot and spring");
  }
}

TEST(FiniteChain, AgreesForALoadThatStartsAtOnceAndCarriedVelocities) {
  const double dt = 2e-5;
  TimeScheme damped = generalized_alpha(0.8);
  damped.carried_velocity = 0.98;
  for (const TimeScheme& scheme : {trapezoidal(), hht(0.1), damped}) {
    BlockChain chain = rock_chain(10, 1.0, 0.25, consistent_edge(4 * kYoung, 0.4 * kYoung));
    chain.end_impedance = kDensity * 4343;
    expect_agreement(chain, scheme, dt, std::vector<double>(301, 1e6), "step load");
  }
}

TEST(FiniteChain, AgreesForTheCubicLawWithItsOptions) {
  const double dt = 2e-5;
  BlockChain chain = rock_chain(10, 1.0, 0.25, cubic_edge());
  chain.interface.inertia_reduction = inertia_reduction(chain, period_error(generalized_alpha(0.8)), dt);
  ASSERT_GT(chain.interface.inertia_reduction, 0);
  expect_agreement(chain, generalized_alpha(0.8), dt, std::vector<double>(301, 1e6), "step load");
  chain.interface.normal = 0.3 * kYoung;
  chain.interface.tangential_half = 0.2 * kYoung;
  expect_agreement(chain, hht(0.1), dt, pulse_load(dt, 300), "springs as well");
  chain.lateral_inertia = 0;
  expect_agreement(chain, trapezoidal(), dt, pulse_load(dt, 300), "without lateral inertia");
}

std::vector<PlaneElasticity> cubic_elasticities() {
  return {plane_stress(kYoung, 0), plane_stress(kYoung, 0.25), plane_strain(kYoung, 0), plane_strain(kYoung, 0.25),
          plane_strain(kYoung, 0.45)};
}

TEST(FiniteChain, AgreesForTheCubicLawInEveryCombination) {
  const double dt = 2e-5;
  for (const TimeScheme& scheme : all_schemes()) {
    for (const PlaneElasticity& elasticity : cubic_elasticities()) {
      for (const bool corrected : {false, true}) {
        for (const double lateral : {0.0, 1.0}) {
          BlockChain chain = rock_chain(8, 1.0, 0, cubic_edge());
          chain.elasticity = elasticity;
          chain.lateral_inertia = lateral;
          if (corrected) chain.interface.inertia_reduction = inertia_reduction(chain, period_error(scheme), dt);
          expect_agreement(chain, scheme, dt, pulse_load(dt, 250),
                           "beta " + std::to_string(scheme.beta) + " e12 " + std::to_string(elasticity.e12) +
                               " corrected " + std::to_string(corrected) + " lateral " + std::to_string(lateral));
        }
      }
    }
  }
}

using Response = ChainHistories (*)(const BlockChain&, const TimeScheme&, double, const std::vector<double>&,
                                    const std::vector<ChainProbe>&);

// Elementary bar theory: without inertia the sides follow, and Poisson's ratio shows only in the modulus.
void expect_rod(Response response, const PlaneElasticity& elasticity, double tolerance) {
  BlockChain chain = rock_chain(20, 0.5, 0, cubic_edge(0.01)), rod = chain;
  chain.elasticity = elasticity;
  chain.lateral_inertia = 0;
  rod.elasticity = {bar_modulus(elasticity), 0};
  const double dt = 1e-5;
  const auto found = response(chain, generalized_alpha(0.8), dt, pulse_load(dt, 1000), all_probes(chain));
  const auto expected = response(rod, generalized_alpha(0.8), dt, pulse_load(dt, 1000), all_probes(rod));
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_LT(relative_difference(found[i], expected[i]), tolerance) << elasticity.e12 << ", probe " << i;
  }
}

// The closed form's own round-off is 1.4e-14 of the peak (see the README); the dense solution's about 1e-16 (steps) (c
// dt/L)^-2, 3e-12.
TEST(FiniteChain, CubicLawWithoutLateralInertiaIsTheRodOfTheBarModulus) {
  for (const PlaneElasticity& elasticity : cubic_elasticities()) {
    expect_rod(finite_chain_response, elasticity, 1e-12);
    expect_rod(dense_chain_response, elasticity, 1e-11);
  }
}

TEST(FiniteChain, AgreesForAChainOfTwoBlocks) {
  for (const InterfaceLaw& law : all_laws()) {
    expect_agreement(rock_chain(2, 1.0, 0.25, law), trapezoidal(), 2e-5, pulse_load(2e-5, 300), "two blocks");
  }
}

// Largest difference from the wave equation at mid-length of a 100 m bar, for a smooth push of about 3 ms.
double wave_equation_error(double length) {
  const double dt = 2e-5 * length, speed = std::sqrt(kYoung / kDensity);
  const auto push = [](double t) { return 1e6 * std::exp(-std::pow((t - 0.008) / 0.0015, 2)); };
  std::vector<double> load;
  for (int i = 0; i * dt < 0.03; ++i) load.push_back(push(i * dt));
  const int blocks = static_cast<int>(100 / length);
  const BlockChain chain = rock_chain(blocks, length, 0, consistent_edge(4 * kYoung / length, 0.4 * kYoung / length));
  const auto force =
      finite_chain_response(chain, trapezoidal(), dt, load, {{ChainQuantity::interface_force, blocks / 2 - 1}})[0];
  double difference = 0;
  for (std::size_t i = 0; i < force.size(); ++i) {
    difference = std::max(difference, std::abs(force[i] + push(static_cast<double>(i) * dt - 50 / speed)));
  }
  return difference / 1e6;
}

// What the closed form is for: hundreds of blocks, thousands of steps. To leading order c_num/c = 1 + Omega^2/24 -
// theta^2/12 shifts each frequency by x/c (L^2/(24 c^2) - dt^2/12) omega^2, which adds that times the push's third
// derivative; the next order's share is (L/4.5 m)^2 = 0.012, at L = 1 m four times that.
TEST(FiniteChain, LongChainConvergesToTheWaveEquationWithTheKnownError) {
  const double coarse = wave_equation_error(1.0), fine = wave_equation_error(0.5);
  const double speed = std::sqrt(kYoung / kDensity), third_derivative = 3.9036 / std::pow(0.0015, 3);
  const double shift = 50 / speed * (0.25 / (24 * speed * speed) - 1e-10 / 12);
  EXPECT_NEAR(fine / (shift * third_derivative), 1.0, 0.015);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.05);
}

}  // namespace
}  // namespace exact
