#include "dda/contact/mesh_correction.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "dda/contact/contact_models.h"
#include "dda/contact/contact_set.h"
#include "dda/terms/inertia.h"

namespace dda {
namespace {

constexpr double side = 0.8;  // m, of squares
constexpr double stabilisation = 0.25;

JointMaterial bond() {
  JointMaterial joint;
  joint.bonded = true;
  joint.law = InterfaceLaw::consistent;
  joint.stabilisation = stabilisation;
  return joint;
}

// Squares, 3 x 3, the middle one number 4; turned as a whole.
Model squares(double angle = 0) {
  std::vector<Polygon> shapes;
  for (int i = 0; i < 9; ++i) {
    const double left = side * (i % 3);
    const double bottom = side * (i / 3);
    shapes.push_back({box_ring(left, bottom, left + side, bottom + side), {}});
  }
  Model model = model_of(shapes);
  model.joints = {bond()};
  if (angle != 0) place(model, angle);
  return model;
}

Model two_blocks(const Ring& a, const Ring& b) {
  Model model = model_of({{a, {}}, {b, {}}});
  model.joints = {bond()};
  finish_model(model);
  return model;
}

double energy(const InterfaceStiffness& stiffness, const Vec6& a, const Vec6& b) {
  return (a.dot(stiffness.aa * a) + b.dot(stiffness.bb * b)) / 2 + b.dot(stiffness.ba * a);
}

Vec6 strained(double xx, double yy, double xy) { return (Vec6() << 0, 0, 0, xx, yy, xy).finished(); }

// The energy of the middle block's share (half) of its four interfaces when the strains of a field with constant second
// derivatives jump from block to block: of a wave that runs along `direction` with particles moving along `particles`.
double jump_energy(const Vec2& direction, const Vec2& particles) {
  Model model = squares();
  finish_model(model);
  double sum = 0;
  for (const Interface& interface : find_interfaces(model)) {
    if (interface.block_a != 4 && interface.block_b != 4) continue;
    const auto strain_at = [&](int block) {
      const double slope = direction.dot(model.blocks[static_cast<std::size_t>(block)].moments.centroid);
      return Vec6(slope * strained(direction.x() * particles.x(), direction.y() * particles.y(),
                                   direction.x() * particles.y() + direction.y() * particles.x()));
    };
    sum += energy(jump_stiffness(model, interface), strain_at(interface.block_a), strain_at(interface.block_b)) / 2;
  }
  return sum;
}

// What the header says long waves in squares are too fast by, P and S, in any direction: that is taken away.
TEST(MeshCorrection, JumpsOfStrainsTakeAwayWhatWavesAreTooFastBy) {
  const Mat3 elasticity = elasticity_matrix(rock());
  const double p = elasticity(0, 0);
  const double g = elasticity(2, 2);
  for (const double degrees : {0.0, 10.0, 22.5, 45.0, 60.0, 100.0}) {
    const double theta = degrees * std::numbers::pi / 180;
    const Vec2 direction(std::cos(theta), std::sin(theta));
    const Vec2 across(-direction.y(), direction.x());
    const double along_sides = std::pow(std::cos(2 * theta), 2) / 12;
    const double diagonal = stabilisation * p * std::pow(std::sin(2 * theta), 2) / 8;
    const double unit = -side * side * side * side / 2;  // area, side^2 of (k L)^2
    EXPECT_NEAR(jump_energy(direction, direction), unit * (p * along_sides + diagonal), 1e-12 * p) << degrees;
    EXPECT_NEAR(jump_energy(direction, across), unit * (g * along_sides + diagonal), 1e-12 * p) << degrees;
  }
}

TEST(MeshCorrection, TurnsWithTheMesh) {
  constexpr double angle = 0.7;
  Model level = squares();
  Model turned = squares(angle);
  finish_model(level);
  finish_model(turned);
  const std::vector<Interface> before = find_interfaces(level);
  const std::vector<Interface> after = find_interfaces(turned);
  ASSERT_EQ(before.size(), after.size());
  Mat2 turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  const auto turned_strain = [&](const Vec6& q) {
    const Mat2 strain = (Mat2() << q(3), q(5) / 2, q(5) / 2, q(4)).finished();
    const Mat2 result = turn * strain * turn.transpose();
    return strained(result(0, 0), result(1, 1), 2 * result(0, 1));
  };
  const Vec6 a = strained(1e-3, -2e-3, 5e-4);
  const Vec6 b = strained(-3e-4, 1e-3, 2e-3);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double expected = energy(jump_stiffness(level, before[i]), a, b);
    EXPECT_NEAR(energy(jump_stiffness(turned, after[i]), turned_strain(a), turned_strain(b)), expected,
                1e-10 * std::abs(expected));
  }
}

TEST(MeshCorrection, UniformStrainHasNoPartInIt) {
  Model model = squares();
  finish_model(model);
  const Vec6 q = (Vec6() << 1, 2, 3, 1e-3, -2e-3, 3e-3).finished();
  for (const Interface& interface : find_interfaces(model)) {
    const InterfaceStiffness stiffness = jump_stiffness(model, interface);
    EXPECT_EQ(Vec6(stiffness.aa * q + stiffness.ba.transpose() * q), Vec6::Zero());
    EXPECT_EQ(Vec6(stiffness.bb * q + stiffness.ba * q), Vec6::Zero());
  }
}

// Strains do jump where materials change. A notch may lie far from the centroid, which the bounds rely on it does not.
TEST(MeshCorrection, OnlyBetweenConvexBlocksOfOneMaterial) {
  const Ring left = box_ring(0, 0, 1, 1);
  const Ring notched = {{1, 0}, {3, 0}, {3, 1}, {2.5, 1}, {2.5, 0.5}, {1, 0.5}};
  const auto stiffness_between = [](const Model& model) {
    return jump_stiffness(model, find_interfaces(model).front()).aa.norm();
  };
  EXPECT_GT(stiffness_between(two_blocks(left, box_ring(1, 0, 2, 1))), 0);
  EXPECT_EQ(stiffness_between(two_blocks(left, notched)), 0);
  Model unlike = two_blocks(left, box_ring(1, 0, 2, 1));
  unlike.materials.push_back(rock());
  unlike.blocks[1].material = 1;
  EXPECT_EQ(stiffness_between(unlike), 0);
}

TEST(MeshCorrection, IsOfConsistentJointsBetweenFreeBlocks) {
  Model model = two_blocks(box_ring(0, 0, 1, 1), box_ring(1, 0, 2, 1));
  EXPECT_TRUE(is_in_mesh(model, make_contacts(model).elements[0]));
  model.joints[0].law = InterfaceLaw::classical;
  EXPECT_FALSE(is_in_mesh(model, make_contacts(model).elements[0]));
  model.joints[0].law = InterfaceLaw::consistent;
  model.held_blocks.emplace_back().block = 1;
  finish_model(model);
  EXPECT_FALSE(is_in_mesh(model, make_contacts(model).elements[0]));
}

// epsilon dt^2 K of a long wave, as far as the caps let it: all of the S wave's, of the P wave up to C = 0.5.
TEST(MeshCorrection, InertiaIsLoweredByWhatTimeStepsAdd) {
  constexpr double error = 1.0 / 6;
  Model model = squares();
  finish_model(model);
  const Material& material = model.materials[0];
  const Mat3 elasticity = elasticity_matrix(material);
  const double dt = 0.4 * side / p_wave_speed(material);
  const Vec2 direction(0.6, 0.8);
  for (const auto& [particles, modulus] : {std::pair(direction, elasticity(0, 0)),
                                           std::pair(Vec2(-0.8, 0.6), elasticity(2, 2))}) {
    double sum = 0;
    for (const Interface& interface : find_interfaces(model)) {
      if (interface.block_a != 4 && interface.block_b != 4) continue;
      const auto motion = [&](int block) {
        Vec6 q = Vec6::Zero();
        q.head<2>() = direction.dot(model.blocks[static_cast<std::size_t>(block)].moments.centroid) * particles;
        return q;
      };
      const InterfaceInertia inertia = mesh_inertia(model, interface, error, dt);
      const Vec6 a = motion(interface.block_a);
      const Vec6 b = motion(interface.block_b);
      sum += energy({inertia.aa, inertia.bb, inertia.ba}, a, b) / 2;
    }
    const Vec6 q = strained(direction.x() * particles.x(), direction.y() * particles.y(),
                            direction.x() * particles.y() + direction.y() * particles.x());
    sum -= q.dot(dilatation_reduction(model, 4, 1, error, dt) * q) / 2;
    const double expected = -error * dt * dt * modulus * side * side / 2;
    EXPECT_NEAR(sum, expected, 1e-12 * std::abs(expected));
  }
}

double least_eigenvalue(const Eigen::MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues()(0);
}

// Whatever the step: no motion of convex blocks of any shape loses its inertia. What is left is at least a third of
// that of the centroids (least eigenvalue over the least mass: 1 - 8 * 0.08), and a tenth of a dilatation's.
TEST(MeshCorrection, LeavesInertiaAtAnyStep) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place_of(0.15, 0.85);
  for (int run = 0; run < 20; ++run) {
    // Four quadrilaterals that meet anywhere in a unit square stretched to 1:5.
    const Vec2 middle(place_of(random), 5 * place_of(random));
    const double x[2] = {place_of(random), place_of(random)};
    const double y[2] = {5 * place_of(random), 5 * place_of(random)};
    Model model = model_of({{{{0, 0}, {x[0], 0}, middle, {0, y[0]}}, {}},
                            {{{x[0], 0}, {1, 0}, {1, y[1]}, middle}, {}},
                            {{middle, {1, y[1]}, {1, 5}, {x[1], 5}}, {}},
                            {{{0, y[0]}, middle, {x[1], 5}, {0, 5}}, {}}});
    model.joints = {bond()};
    finish_model(model);
    Eigen::MatrixXd inertia = Eigen::MatrixXd::Zero(24, 24);
    Eigen::MatrixXd own = inertia;
    for (int i = 0; i < 4; ++i) {
      const AreaMoments& moments = model.blocks[static_cast<std::size_t>(i)].moments;
      own.block<6, 6>(6 * i, 6 * i) = mass_matrix({model.mass_of(i), mean_squares(moments), 1});
      inertia.block<6, 6>(6 * i, 6 * i) =
          own.block<6, 6>(6 * i, 6 * i) - dilatation_reduction(model, i, 1, 1.0 / 6, 1e3);
    }
    for (const Interface& interface : find_interfaces(model)) {
      if (interface.length == 0) continue;
      const InterfaceInertia between = mesh_inertia(model, interface, 1.0 / 6, 1e3);
      inertia.block<6, 6>(6 * interface.block_a, 6 * interface.block_a) += between.aa;
      inertia.block<6, 6>(6 * interface.block_b, 6 * interface.block_b) += between.bb;
      inertia.block<6, 6>(6 * interface.block_b, 6 * interface.block_a) += between.ba;
      inertia.block<6, 6>(6 * interface.block_a, 6 * interface.block_b) += between.ba.transpose();
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> shares(inertia, own, Eigen::EigenvaluesOnly);
    EXPECT_GT(shares.eigenvalues()(0), 0.099);
    EXPECT_GT(least_eigenvalue(inertia), 0);
  }
}

}  // namespace
}  // namespace dda
