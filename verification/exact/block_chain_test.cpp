#include "verification/exact/block_chain.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <stdexcept>

#include "verification/exact/dense_chain.h"

namespace exact {
namespace {

BlockChain two_blocks(const InterfaceLaw& law) {
  BlockChain chain;
  chain.blocks = 2;
  chain.height = 3;
  chain.density = 1;
  chain.elasticity = {1, 0};
  chain.interface = law;
  return chain;
}

// Springs counted one by one at the two corners, for a motion that opens them and one that shears them.
TEST(BlockChain, CornerSpringsStoreTheEnergyOfFourSprings) {
  const double normal = 7, shear = 5;
  const BlockChain chain = two_blocks(corner_springs(normal, shear));
  const Eigen::MatrixXd stiffness = dense_chain_system(chain).stiffness;
  Eigen::VectorXd open = Eigen::VectorXd::Zero(6), widen_right = open;
  open[3] = 0.1;
  EXPECT_NEAR(open.dot(stiffness * open) / 2, 2 * (normal * 0.1 * 0.1 / 2), 1e-15);
  widen_right[5] = 0.2;  // each corner moves by 0.2 * h/2; the block itself stores E/2 0.2^2 h L
  const double slip = 0.2 * 1.5;
  EXPECT_NEAR(widen_right.dot(stiffness * widen_right) / 2, 2 * (shear * slip * slip / 2) + 0.04 * 3 / 2, 1e-15);
}

// The potential adds h {sigma} g to k g^2/2; its derivative with respect to the gap is the force.
TEST(BlockChain, ConsistentEdgeAddsTheFluxToThePotential) {
  const BlockChain chain = two_blocks(consistent_edge(7, 0));
  const Eigen::MatrixXd stiffness = dense_chain_system(chain).stiffness;
  Eigen::VectorXd motion = Eigen::VectorXd::Zero(6);
  motion[0] = -0.3;
  motion[4] = 0.2;
  const double gap = 0.3 - 0.2 / 2, mean_stress = 0.2 / 2;
  const double expected = 7 * gap * gap / 2 + 3 * mean_stress * gap + 0.04 * 3 / 2;
  EXPECT_NEAR(motion.dot(stiffness * motion) / 2, expected, 1e-15);
}

// w = x^3 between the centroids at -1/2 and 1/2, straight lines of slope 3/4 in the outer halves; density 1, h = 3.
TEST(BlockChain, CubicLawHasTheEnergiesOfTheCubic) {
  BlockChain chain = two_blocks(cubic_edge());
  Eigen::VectorXd motion(6);
  motion << -0.125, 0.75, 0, 0.125, 0.75, 0;
  const double outer_strain = 0.75 * 0.75 / 2, inner_strain = 9.0 / 160;  // 9 x^4/2 over [-1/2, 1/2]
  const DenseSystem system = dense_chain_system(chain);
  EXPECT_NEAR(motion.dot(system.stiffness * motion) / 2, 3 * (outer_strain + inner_strain), 1e-14);
  // (1/8 + 3/4 s)^2/2 over s in [0, 1/2], twice; x^6/2 over the cell.
  const double outer_kinetic = 1.0 / 128 + 3.0 / 128 + 3.0 / 128, inner_kinetic = 1.0 / 896;
  EXPECT_NEAR(motion.dot(system.mass * motion) / 2, 3 * (outer_kinetic + inner_kinetic), 1e-14);
  chain.interface.inertia_reduction = 0.1;  // lowers it by 0.1 rho h L (1/4)^2/2
  EXPECT_NEAR(motion.dot((system.mass - dense_chain_system(chain).mass) * motion) / 2, 0.1 * 3 / 32, 1e-15);
}

// The same motion with e12 = 0.4, Q = 0.84 and ey = 2 in the right block: its stress is 0.75 + 0.8, that of the left
// 0.75; the excess 3 x^2 - 3/4 of the slope integrates to -1/4 over each half.
TEST(BlockChain, CubicLawWorksAgainstTheBlocksOwnStress) {
  BlockChain chain = two_blocks(cubic_edge());
  chain.elasticity.e12 = 0.4;
  Eigen::VectorXd motion(6);
  motion << -0.125, 0.75, 0, 0.125, 0.75, 2;
  const double blocks = (0.75 * 0.75 + 4 + 2 * 0.4 * 0.75 * 2 + 0.75 * 0.75) / 2, first = -(1.55 + 0.75) / 4;
  const double second = 0.84 / 2 * (9.0 / 80 - 4.5 / 12 + 9.0 / 16);
  EXPECT_NEAR(motion.dot(dense_chain_system(chain).stiffness * motion) / 2, 3 * (blocks + first + second), 1e-14);
}

// Equal strains with all centroids at rest: w'^2 has the mean e^2/5 and w' the mean 0. With ey in equilibrium that
// stores Q/5 - e12^2 (e11 = 1), negative from e12^2 = 1/6 on; the ends of a short chain stiffen it a little.
TEST(BlockChain, CubicLawIsUnstableBeyondAPoissonRatio) {
  BlockChain chain = two_blocks(cubic_edge());
  chain.blocks = 20;
  const auto softest = [&](double e12) {
    chain.elasticity.e12 = e12;
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense_chain_system(chain).stiffness).eigenvalues()[0];
  };
  const double limit = std::sqrt(1.0 / 6), rigid = 1e-12;  // round-off of the rigid motion's 0
  EXPECT_GT(softest(limit - 0.01), -rigid);
  EXPECT_LT(softest(limit + 0.01), -1e-3);
}

TEST(BlockChain, BadDataAndMissingProbesAreErrors) {
  const BlockChain good = two_blocks(corner_springs(7, 5));
  EXPECT_NO_THROW(check(good, {{ChainQuantity::interface_force, 0}, {ChainQuantity::block_stress, 1}}));
  EXPECT_THROW(check(good, {{ChainQuantity::interface_force, 1}}), std::invalid_argument);
  EXPECT_THROW(check(good, {{ChainQuantity::displacement, 2}}), std::invalid_argument);
  BlockChain bad = good;
  bad.density = NAN;
  EXPECT_THROW(check(bad, {}), std::invalid_argument);
}

}  // namespace
}  // namespace exact
