// The half chain against the continuum, against the waves of the chain, and against a long finite chain.
#include "verification/exact/half_chain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "verification/exact/chain_modes.h"
#include "verification/exact/finite_chain.h"

namespace exact {
namespace {

constexpr double young = 50e9, density = 2650, omega = 2 * std::numbers::pi * 100;

BlockChain chain_of(InterfaceLaw interface, double length) {
  BlockChain chain;
  chain.blocks = 2;
  chain.length = length;
  chain.density = density;
  chain.elasticity = plane_stress(young, 0.25);
  chain.interface = interface;
  return chain;
}

std::complex<double> force(const BlockChain& chain, const TimeScheme& scheme, double dt, int interface) {
  return std::complex<double>(half_chain_force(chain, scheme, dt, omega, interface));
}

// The error is of fourth order; a share of the end's strain that is off by a hundredth makes it third at the finest.
TEST(HalfChain, IsTheContinuumInTheLimit) {
  const double speed = std::sqrt(young / density);
  double last = 1;
  for (const double length : {4.0, 2.0, 1.0}) {
    BlockChain chain = chain_of(cubic_edge(), length);
    chain.lateral_inertia = 0;
    const int interface = static_cast<int>(48 / length);
    const double error = std::abs(force(chain, trapezoidal(), 1e-7, interface) - std::polar(1.0, -omega * 48 / speed));
    EXPECT_LT(error, last / 14) << length;
    last = error;
  }
  EXPECT_LT(last, 1e-5);
}

TEST(HalfChain, GoesOnAsTheWaveOfTheChain) {
  const TimeScheme scheme = thesis_scheme();
  const BlockChain chain = chain_of(corner_springs(5e11, 2e11), 2);
  const std::complex<double> step = force(chain, scheme, 1e-4, 41) / force(chain, scheme, 1e-4, 40);
  const ChainWave wave = chain_wave(chain, scheme, 1e-4, omega);
  EXPECT_NEAR(std::abs(step), std::exp(-wave.attenuation * 2), 1e-12);
  EXPECT_NEAR(-std::arg(step), omega * 2 / wave.speed, 1e-12);
}

// Waves that nothing damps run away from the end, too, whatever round-off makes of |lambda| = 1. The little damping
// alone changes the force by 3e-6.
TEST(HalfChain, WithoutDampingItIsTheLimitOfLittleDamping) {
  for (const InterfaceLaw& law : {consistent_edge(4 * young / 5, 0), corner_springs(5e11, 2e11), cubic_edge()})
    for (const double length : {0.5, 1.0, 2.0, 3.0, 5.0, 10.0, 15.0})
      for (const double dt : {1e-6, 1e-5, 3e-5, 1e-4, 3e-4}) {
        const BlockChain chain = chain_of(law, length);
        const int interface = static_cast<int>(50 / length);
        EXPECT_NEAR(std::abs(force(chain, trapezoidal(), dt, interface) - force(chain, hht(1e-6), dt, interface)), 0,
                    1e-5)
            << length << " " << dt;
      }
}

// Force at the interface of a finite chain, as complex amplitude over one late period.
std::complex<double> steady(const BlockChain& chain, const TimeScheme& scheme, double dt, int per_period, int periods) {
  std::vector<double> load(static_cast<std::size_t>(per_period * periods) + 1);
  for (std::size_t i = 0; i < load.size(); ++i) load[i] = std::sin(omega * dt * static_cast<double>(i));
  const std::vector<double> history =
      finite_chain_response(chain, scheme, dt, load, {{ChainQuantity::interface_force, 4}}).front();
  std::complex<double> sum = 0;
  for (std::size_t i = load.size() - static_cast<std::size_t>(per_period); i < load.size(); ++i)
    sum += history[i] * std::polar(2.0 / per_period, -omega * dt * static_cast<double>(i));
  return sum / std::complex<double>(0, -1);  // sin(a) is the real part of -i exp(i a)
}

TEST(HalfChain, IsWhatALongChainSettlesTo) {
  const double dt = 2e-4;
  BlockChain chain = chain_of(consistent_edge(4 * young / 10, 0), 10);
  chain.blocks = 200;
  const std::complex<double> settled = steady(chain, thesis_scheme(), dt, 50, 20);
  // The transient of a damped chain dies out; tension is positive in the history, compression in the transfer.
  EXPECT_NEAR(std::abs(settled + force(chain, thesis_scheme(), dt, 5)), 0, 2e-3);
}

}  // namespace
}  // namespace exact
