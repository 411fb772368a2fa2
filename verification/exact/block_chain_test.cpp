#include "verification/exact/block_chain.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

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

// By how much strains at faces that nothing holds count.
const double share = (10 - std::sqrt(2)) / 12;

// w = x^3 between the centroids at -1/2 and 1/2, straight lines of slope 3/4 in the outer halves; density 1, h = 3.
TEST(BlockChain, CubicLawHasTheEnergiesOfTheCubic) {
  BlockChain chain = two_blocks(cubic_edge());
  Eigen::VectorXd motion(6);
  motion << -0.125, 0.75, 0, 0.125, 0.75, 0;
  const double outer_strain = share * 0.75 * 0.75 / 2, inner_strain = 9.0 / 160;  // 9 x^4/2 over [-1/2, 1/2]
  const DenseSystem system = dense_chain_system(chain);
  EXPECT_NEAR(motion.dot(system.stiffness * motion) / 2, 3 * (outer_strain + inner_strain), 1e-14);
  // (1/8 + 3/4 s)^2/2 over s in [0, 1/2], twice; x^6/2 over the cell.
  const double outer_kinetic = 1.0 / 128 + 3.0 / 128 + 3.0 / 128, inner_kinetic = 1.0 / 896;
  EXPECT_NEAR(motion.dot(system.mass * motion) / 2, 3 * (outer_kinetic + inner_kinetic), 1e-14);
  // Lowers it by 0.1 rho h L (1/4)^2/2, and at each face by 0.05 of share rho h L/2 (L 3/4)^2/2.
  chain.interface.inertia_reduction = 0.1;
  const double at_faces = 0.05 * share * 3 * 0.75 * 0.75 / 2;
  EXPECT_NEAR(motion.dot((system.mass - dense_chain_system(chain).mass) * motion) / 2, 0.1 * 3 / 32 + at_faces, 1e-15);
  motion << 0, -0.3, 0, 0, 0.5, 0;  // by the jump of 0.8, squared, over 12
  for (const auto& [given, of_jump] : {std::pair{0.03, 0.03}, std::pair{0.1, 0.05}, std::pair{-0.2, -0.2}}) {
    chain.interface.inertia_reduction = given;
    const double lowered = 3 * of_jump * (0.64 / 12 / 2 + share * (0.09 + 0.25) / 4);
    EXPECT_NEAR(motion.dot((system.mass - dense_chain_system(chain).mass) * motion) / 2, lowered, 1e-15) << given;
  }
}

// The same motion with e12 = 0.4, Q = 0.84 and ey = 2 in the right block, which changes only what the blocks store by
// themselves: Q ex is 0.63 in both, and the excess 3 x^2 - 3/4 of the slope integrates to -1/4 over each half.
TEST(BlockChain, CubicLawWorksAgainstTheStressOfABlockWithFreeSides) {
  BlockChain chain = two_blocks(cubic_edge());
  chain.elasticity.e12 = 0.4;
  Eigen::VectorXd motion(6);
  motion << -0.125, 0.75, 0, 0.125, 0.75, 2;
  const double blocks = (0.75 * 0.75 + 4 + 2 * 0.4 * 0.75 * 2 + 0.75 * 0.75) / 2, first = -(0.63 + 0.63) / 4;
  const double at_faces = -(1 - share) * 0.63 * 0.75 / 2;
  const double second = 0.84 / 2 * (9.0 / 80 - 4.5 / 12 + 9.0 / 16);
  EXPECT_NEAR(motion.dot(dense_chain_system(chain).stiffness * motion) / 2, 3 * (blocks + first + second + at_faces),
              1e-14);
}

std::vector<PlaneElasticity> all_elasticities() {
  std::vector<PlaneElasticity> all{plane_stress(1, 0.5)};
  for (const double poisson : {0.0, 0.1, 0.25, 0.3, 0.35, 0.45, 0.49}) {
    all.push_back(plane_stress(1, poisson));
    all.push_back(plane_strain(1, poisson));
  }
  return all;
}

BlockChain cubic_chain(const PlaneElasticity& elasticity) {
  BlockChain chain = two_blocks(cubic_edge());
  chain.blocks = 20;
  chain.elasticity = elasticity;
  return chain;
}

// h L e11 (ey + e12/e11 ex)^2/2 of every block: what strains store that are not those of free sides.
void add_confinement(const BlockChain& chain, Eigen::MatrixXd& stiffness) {
  const PlaneElasticity& elasticity = chain.elasticity;
  const Eigen::Vector2d strain(elasticity.e12 / elasticity.e11, 1);
  for (int block = 0; block < chain.blocks; ++block) {
    stiffness.block<2, 2>(3 * block + 1, 3 * block + 1) +=
        chain.length * chain.height * elasticity.e11 * strain * strain.transpose();
  }
}

TEST(BlockChain, CubicLawIsARodOfTheBarModulusPlusTheConfinementOfTheBlocks) {
  for (const PlaneElasticity& elasticity : all_elasticities()) {
    const BlockChain chain = cubic_chain(elasticity);
    BlockChain rod = cubic_chain({bar_modulus(elasticity), 0});
    Eigen::MatrixXd expected = dense_chain_system(rod).stiffness;
    for (int block = 0; block < rod.blocks; ++block) {  // the rod's own ey
      expected(3 * block + 2, 3 * block + 2) -= rod.length * rod.height * rod.elasticity.e11;
    }
    add_confinement(chain, expected);
    const Eigen::MatrixXd found = dense_chain_system(chain).stiffness;
    // Round-off of some tens of additions.
    EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 1e-14 * found.cwiseAbs().maxCoeff()) << elasticity.e12;
  }
}

// Only the rigid motion stores nothing. Within strains of free sides the softest motion is the bar's first mode, about
// h L Q (pi/20)^2 (u_j = cos, with ex = u' and ey small beside it); across them e11 resists, which is no softer.
TEST(BlockChain, CubicLawIsPositiveForEveryPoissonRatio) {
  for (const PlaneElasticity& elasticity : all_elasticities()) {
    const BlockChain chain = cubic_chain(elasticity);
    const Eigen::VectorXd energies =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense_chain_system(chain).stiffness).eigenvalues();
    const double first_mode = 3 * bar_modulus(elasticity) * std::pow(std::numbers::pi / chain.blocks, 2);
    EXPECT_NEAR(energies[0], 0, 1e-13 * energies[59]) << elasticity.e12;  // round-off
    EXPECT_GT(energies[1], 0.9 * first_mode) << elasticity.e12;
  }
}

// Equal strains of free sides with all centroids at rest: w'^2 has the mean e^2/5 over a cell, e^2 over the two ends,
// where it counts by its share.
// The softest short wave, and the first to fail if the cubic's strain did work on more than Q e.
TEST(BlockChain, CubicLawStoresAFifthOfStrainsThatMoveNoCentroid) {
  for (const PlaneElasticity& elasticity : all_elasticities()) {
    const BlockChain chain = cubic_chain(elasticity);
    Eigen::VectorXd motion = Eigen::VectorXd::Zero(60);
    for (int block = 0; block < chain.blocks; ++block) {
      motion[3 * block + 1] = 1;
      motion[3 * block + 2] = -elasticity.e12 / elasticity.e11;
    }
    const double expected = 3 * bar_modulus(elasticity) / 2 * (19.0 / 5 + share);
    EXPECT_NEAR(motion.dot(dense_chain_system(chain).stiffness * motion) / 2 / expected, 1, 1e-12) << elasticity.e12;
  }
}

// The lowest frequency of a bar of `blocks` blocks, 1 m and 1 m/s, over pi rad/s, less 1: twice the error of the phase
// that an end makes, over pi, and that of the chain.
double frequency_error(int blocks, int mode) {
  BlockChain chain = cubic_chain({1, 0});
  chain.blocks = blocks;
  chain.length = 1.0 / blocks;
  const DenseSystem system = dense_chain_system(chain);
  Eigen::MatrixXd stiffness(2 * blocks, 2 * blocks), mass = stiffness;  // of u and ex alone
  const auto axial = [](int i) { return 3 * (i / 2) + i % 2; };
  for (int i = 0; i < 2 * blocks; ++i) {
    for (int j = 0; j < 2 * blocks; ++j) {
      stiffness(i, j) = system.stiffness(axial(i), axial(j));
      mass(i, j) = system.mass(axial(i), axial(j));
    }
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(stiffness, mass, Eigen::EigenvaluesOnly);
  return std::sqrt(modes.eigenvalues()[mode]) / (mode * std::numbers::pi) - 1;
}

// With straight lines of full share the ends are right to second order of (k L/2) in their phase, and the order is 3.
TEST(BlockChain, FreeCubicBarsHaveTheirFrequenciesToFifthOrder) {
  for (const int mode : {1, 2}) {
    const double coarse = frequency_error(6 * mode, mode), fine = frequency_error(12 * mode, mode);
    EXPECT_NEAR(std::log2(coarse / fine), 5, 0.1) << mode;
    const double phase = std::numbers::pi / 12;  // k L/2 of the coarse
    EXPECT_NEAR(coarse * mode * std::numbers::pi / 2, -0.038 * std::pow(phase, 5),
                0.005 * std::pow(phase, 5));  // measured
  }
}

TEST(BlockChain, FacesThatAreHeldHaveTheirFullShare) {
  BlockChain chain = two_blocks(cubic_edge());
  EXPECT_EQ(end_share(chain, Face::left), share);
  EXPECT_EQ(end_share(chain, Face::right), share);
  chain.end_impedance = 1;
  EXPECT_EQ(end_share(chain, Face::right), 1);
  EXPECT_EQ(end_share(chain, Face::left), share);
  chain.end_impedance = 0;
  chain.blocks = 1;  // no interface, no cubic
  EXPECT_EQ(end_share(chain, Face::left), 1);
  EXPECT_EQ(end_share(two_blocks(consistent_edge(7, 0)), Face::left), 1);
}

TEST(BlockChain, BadDataAndMissingProbesAreErrors) {
  const BlockChain good = two_blocks(corner_springs(7, 5));
  EXPECT_NO_THROW(check(good, {{ChainQuantity::interface_force, 0}, {ChainQuantity::block_stress, 1}}));
  EXPECT_THROW(check(good, {{ChainQuantity::interface_force, 1}}), std::invalid_argument);
  EXPECT_THROW(check(good, {{ChainQuantity::displacement, 2}}), std::invalid_argument);
  BlockChain bad = good;
  bad.density = NAN;
  EXPECT_THROW(check(bad, {}), std::invalid_argument);
  bad = two_blocks(cubic_edge());
  EXPECT_NO_THROW(check(bad, {}));
  bad.interface.consistent = true;
  EXPECT_THROW(check(bad, {}), std::invalid_argument);
}

}  // namespace
}  // namespace exact
