#include "verification/exact/block_chain.h"

#include <gtest/gtest.h>

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
