#include "verification/exact/pulsed_row.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "verification/exact/dense_chain.h"

namespace exact {
namespace {

constexpr double young = 20e9;

PulsedRow row_of(const std::vector<double>& density) { return {density, 1.5, young, 4e11, 1e6, 1e-3, 0.5e-3}; }

double push(const PulsedRow& row, double t) {
  if (t <= row.rise) return row.peak * t / row.rise;
  return row.peak * std::max(0.0, 1 - (t - row.rise) / row.fall);
}

// The trapezoidal rule in steps of 1 us is off by (omega dt)^2/12 of what moves: 2e-5 at the row's tenth mode.
TEST(PulsedRow, IsWhatTheDenseChainComesTo) {
  const PulsedRow row = row_of({2600, 2600, 2600, 2600});
  const RowMotion motion(row);
  BlockChain chain;
  chain.blocks = 4;
  chain.length = row.length;
  chain.density = row.density[0];
  chain.elasticity = plane_stress(young, 0);
  chain.interface = corner_springs(row.joint_stiffness / 2, 0.4 * row.joint_stiffness / 2);
  constexpr double dt = 1e-6;
  constexpr int steps = 3000;
  std::vector<double> load;
  for (int i = 0; i <= steps; ++i) load.push_back(push(row, i * dt));
  const ChainHistories dense = dense_chain_response(
      chain, trapezoidal(), dt, load, {{ChainQuantity::displacement, 0}, {ChainQuantity::displacement, 3}});
  const double largest = motion.displacements(steps * dt).maxCoeff();
  for (int i = 0; i <= steps; i += 100) {
    const Eigen::VectorXd exact = motion.displacements(i * dt);
    EXPECT_NEAR(dense[0][static_cast<std::size_t>(i)], exact[0], 2e-5 * largest);
    EXPECT_NEAR(dense[1][static_cast<std::size_t>(i)], exact[3], 2e-5 * largest);
  }
}

// Masses that differ by a factor of a million: what they gain together is the push.
TEST(PulsedRow, ItsCentreOfMassMovesAsOneMass) {
  const PulsedRow row = row_of({2600, 2600e-6, 2600, 2600e-6});
  const RowMotion motion(row);
  const double t = 5e-3;
  const Eigen::VectorXd displacement = motion.displacements(t);
  double moment = 0, mass = 0;
  for (std::size_t i = 0; i < row.density.size(); ++i) {
    mass += row.density[i] * row.length;
    moment += row.density[i] * row.length * displacement[static_cast<Eigen::Index>(i)];
  }
  const double impulse = row.peak * (row.rise + row.fall) / 2;
  const double middle = (row.rise + (row.rise + row.fall)) / 3;  // of the triangle 0, rise, rise + fall
  EXPECT_NEAR(moment / mass, impulse / mass * (t - middle), 1e-8 * impulse / mass * t);
}

}  // namespace
}  // namespace exact
