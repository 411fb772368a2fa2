#include "engine/waves/mesh_correction.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/contact/contact_models.h"
#include "engine/contact/contact_set.h"
#include "engine/contact/cubic_law.h"
#include "engine/contact/make_contacts.h"
#include "engine/linear/dense_modes.h"
#include "engine/model/held_flags.h"
#include "engine/terms/inertia.h"

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

double energy(const InterfaceMatrices& stiffness, const Vec6& a, const Vec6& b) {
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
    const InterfaceMatrices stiffness = jump_stiffness(model, interface);
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
  EXPECT_TRUE(is_in_mesh(held_flags(model), make_contacts(model).elements[0]));
  model.joints[0].law = InterfaceLaw::classical;
  EXPECT_FALSE(is_in_mesh(held_flags(model), make_contacts(model).elements[0]));
  model.joints[0].law = InterfaceLaw::consistent;
  model.held_blocks.emplace_back().block = 1;
  finish_model(model);
  EXPECT_FALSE(is_in_mesh(held_flags(model), make_contacts(model).elements[0]));
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
  for (const auto& [particles, modulus] :
       {std::pair(direction, elasticity(0, 0)), std::pair(Vec2(-0.8, 0.6), elasticity(2, 2))}) {
    double sum = 0;
    for (const Interface& interface : find_interfaces(model)) {
      if (interface.block_a != 4 && interface.block_b != 4) continue;
      const auto motion = [&](int block) {
        Vec6 q = Vec6::Zero();
        q.head<2>() = direction.dot(model.blocks[static_cast<std::size_t>(block)].moments.centroid) * particles;
        return q;
      };
      const InterfaceMatrices inertia = mesh_inertia(model, interface, error, dt);
      const Vec6 a = motion(interface.block_a);
      const Vec6 b = motion(interface.block_b);
      sum += energy(inertia, a, b) / 2;
    }
    const Vec6 q = strained(direction.x() * particles.x(), direction.y() * particles.y(),
                            direction.x() * particles.y() + direction.y() * particles.x());
    sum -= q.dot(dilatation_reduction(model, 4, 1, error, dt) * q) / 2;
    const double expected = -error * dt * dt * modulus * side * side / 2;
    EXPECT_NEAR(sum, expected, 1e-12 * std::abs(expected));
  }
}

// A bar whose sides are free: e_tt = -nu e_nn.
TEST(MeshCorrection, ChainsAreCorrectedAsBars) {
  constexpr double error = 1.0 / 6;
  constexpr double height = 0.1;
  Model model = two_blocks(box_ring(0, 0, 1, height), box_ring(1, 0, 2, height));
  place(model, 0.4);
  finish_model(model);
  const Interface interface = find_interfaces(model).front();
  const double modulus = side_free_modulus(model.materials[0]);
  const double dt = 0.6 * std::sqrt(model.materials[0].density / modulus);
  const Vec2& n = interface.normal;
  const Vec2 t(-n.y(), n.x());
  const double nu = model.materials[0].poisson;
  const Vec6 strain = strained(n.x() * n.x() - nu * t.x() * t.x(), n.y() * n.y() - nu * t.y() * t.y(),
                               2 * (n.x() * n.y() - nu * t.x() * t.y()));
  const Vec6 moved = (Vec6() << n, 0, 0, 0, 0).finished();
  const InterfaceMatrices between = mesh_inertia(model, interface, error, dt);
  const double sum = moved.dot(between.bb * moved) - strain.dot(axial_reduction(model, 0, n, 1, error, dt) * strain);
  EXPECT_NEAR(sum, -error * dt * dt * modulus * height, 1e-12 * error * dt * dt * modulus);
}

// Quadrilaterals that meet anywhere in a rectangle of 1 by 5 m, convex or not, or the triangles they are made of.
Model random_mesh(std::mt19937& random, bool triangles) {
  std::uniform_real_distribution<double> place_of(0.15, 0.85);
  const Vec2 middle(place_of(random), 5 * place_of(random));
  const Vec2 below(place_of(random), 0);
  const Vec2 above(place_of(random), 5);
  const Vec2 left(0, 5 * place_of(random));
  const Vec2 right(1, 5 * place_of(random));
  std::vector<Polygon> shapes;
  for (const auto& [from, corner, to] : {std::tuple(left, Vec2(0, 0), below), std::tuple(below, Vec2(1, 0), right),
                                         std::tuple(right, Vec2(1, 5), above), std::tuple(above, Vec2(0, 5), left)}) {
    if (triangles) {
      shapes.push_back({{from, corner, middle}, {}});
      shapes.push_back({{corner, to, middle}, {}});
    } else {
      shapes.push_back({{from, corner, to, middle}, {}});
    }
  }
  Model model = model_of(shapes);
  model.joints = {bond()};
  model.joints[0].stabilisation = JointMaterial{}.stabilisation;
  return model;
}

Ring regular_polygon(double radius) {
  constexpr int corners = 16;
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    ring.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return ring;
}

// What fills an opening, the ring around it and the rock around that: blocks with holes.
Model lined_opening(std::mt19937& random) {
  std::uniform_real_distribution<double> inner_of(0.3, 0.9);
  const Ring inner = regular_polygon(inner_of(random));
  const Ring outer = regular_polygon(1);
  Model model = model_of({{inner, {}}, {outer, {inner}}, {box_ring(-2, -2, 2, 2), {outer}}});
  model.joints = {bond()};
  return model;
}

// A parallelogram that leans any way, on one side of which another lies: a chain, whose normal is that of the joint.
Model sheared_pair(std::mt19937& random) {
  std::uniform_real_distribution<double> lean_of(-4, 4);
  std::uniform_real_distribution<double> height_of(0.1, 3);
  const double height = height_of(random);
  const Vec2 up(lean_of(random), height);
  const Ring lower{{0, 0}, {1, 0}, Vec2(1, 0) + up, up};
  Ring upper = lower;
  for (Vec2& vertex : upper) vertex += up;
  Model model = two_blocks(lower, upper);
  place(model, lean_of(random));
  finish_model(model);
  return model;
}

void add_pair(const Interface& interface, const Mat6& aa, const Mat6& bb, const Mat6& ba, Eigen::MatrixXd& sum) {
  const int a = 6 * interface.block_a;
  const int b = 6 * interface.block_b;
  sum.block<6, 6>(a, a) += aa;
  sum.block<6, 6>(b, b) += bb;
  sum.block<6, 6>(b, a) += ba;
  sum.block<6, 6>(a, b) += ba.transpose();
}

// Three motions are free; of the others the least stiff one keeps at least half of the stiffness it had (measured:
// 0.64), and with what explicit steps add, at its cap everywhere, 0.4 (measured: 0.49). Rock that is nearly
// incompressible, too: before there was a cap on its P modulus some motions had no stiffness left.
TEST(MeshCorrection, LeavesStiffnessToEveryMotion) {
  std::mt19937 random(4);
  for (int run = 0; run < 200; ++run) {
    Model model = random_mesh(random, run % 2 == 0);
    model.materials[0].plane = PlaneState::strain;
    model.materials[0].poisson = std::array{0.25, 0.47, 0.49, 0.499}[static_cast<std::size_t>(run / 2 % 4)];
    finish_model(model);
    const auto size = static_cast<Eigen::Index>(6 * model.blocks.size());
    Eigen::MatrixXd before = Eigen::MatrixXd::Zero(size, size);
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(6 * i) + 3;
      before.block<3, 3>(at, at) = model.blocks[i].moments.area * elasticity_matrix(model.materials[0]);
    }
    Eigen::MatrixXd jumps = Eigen::MatrixXd::Zero(size, size), jumps_of_long_steps = jumps;
    const ContactSet contacts = make_contacts(model);
    for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
      const InterfaceMatrices own = stiffness_of(contacts.elements[i], Vec4::Ones());
      add_pair(contacts.interfaces[i], own.aa, own.bb, own.ba, before);
      const InterfaceMatrices jump = jump_stiffness(model, contacts.interfaces[i]);
      add_pair(contacts.interfaces[i], jump.aa, jump.bb, jump.ba, jumps);
      const InterfaceMatrices more = jump_stiffness(model, contacts.interfaces[i], {true, 1e6});
      add_pair(contacts.interfaces[i], more.aa, more.bb, more.ba, jumps_of_long_steps);
    }
    const Eigen::VectorXd own = dense_modes(before).squares;
    const Eigen::VectorXd corrected = dense_modes(before + jumps).squares;
    ASSERT_GT(own(3), 0);
    EXPECT_GT(corrected(3), 0.5 * own(3)) << run;
    const Eigen::VectorXd explicit_steps = dense_modes(before + jumps_of_long_steps).squares;
    EXPECT_GT(explicit_steps(3), 0.4 * own(3)) << run;
  }
}

// Whatever the step: no motion loses its inertia. What is left is at least a tenth (a dilatation's).
TEST(MeshCorrection, LeavesInertiaAtAnyStep) {
  std::mt19937 random(3);
  for (int run = 0; run < 80; ++run) {
    Model model = run % 2 == 0 ? lined_opening(random) : random_mesh(random, run % 4 == 1);
    finish_model(model);
    const auto size = static_cast<Eigen::Index>(6 * model.blocks.size());
    Eigen::MatrixXd own = Eigen::MatrixXd::Zero(size, size);
    Eigen::MatrixXd lowered = own;
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(6 * i);
      const int block = static_cast<int>(i);
      own.block<6, 6>(at, at) = mass_matrix({model.mass_of(block), mean_squares(model.blocks[i].moments), 1});
      lowered.block<6, 6>(at, at) = own.block<6, 6>(at, at) - dilatation_reduction(model, block, 1, 1.0 / 6, 1e3);
    }
    for (const Interface& interface : find_interfaces(model)) {
      if (interface.length == 0) continue;
      const InterfaceMatrices between = mesh_inertia(model, interface, 1.0 / 6, 1e3);
      add_pair(interface, between.aa, between.bb, between.ba, lowered);
    }
    const Eigen::VectorXd shares = dense_modes(lowered, own).squares;
    EXPECT_GT(shares(0), 1 - mesh::most_strain_correction - 1e-9);
  }
}

// The same of blocks in a chain, however they lean.
TEST(MeshCorrection, LeavesInertiaToBlocksThatLean) {
  std::mt19937 random(5);
  for (int run = 0; run < 200; ++run) {
    const Model model = sheared_pair(random);
    const Vec2 normal = find_interfaces(model).front().normal;
    const Mat6 own = mass_matrix({model.mass_of(0), mean_squares(model.blocks[0].moments), 1});
    const Mat6 lowered = own - axial_reduction(model, 0, normal, 1, 1.0 / 6, 1e3);
    const Eigen::VectorXd shares = dense_modes(lowered, own).squares;
    EXPECT_NEAR(shares(0), 1 - mesh::most_strain_correction, 1e-6) << run;
  }
}

}  // namespace
}  // namespace dda
