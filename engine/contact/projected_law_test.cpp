// The projected law against its potential, written here from displacements at points and stresses alone, and against
// what it promises of whole meshes.
#include "engine/contact/projected_law.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <vector>

#include "engine/contact/contact_models.h"
#include "engine/contact/contact_set.h"
#include "engine/contact/make_contacts.h"
#include "engine/terms/potential_check.h"

namespace dda {
namespace {

using Vec12 = Eigen::Matrix<double, 12, 1>;
using Mat12 = Eigen::Matrix<double, 12, 12>;

Vec2 motion(const Vec6& q, const Vec2& offset) {
  return {q(0) - q(2) * offset.y() + q(3) * offset.x() + q(5) / 2 * offset.y(),
          q(1) + q(2) * offset.x() + q(4) * offset.y() + q(5) / 2 * offset.x()};
}

// Two unlike blocks that share a part of their edges, turned by `angle`.
Model unlike_pair(double angle, double joint_stiffness = 0) {
  const Polygon left{{{0, 0}, {2, 0}, {2, 1.5}, {0.3, 1.2}}, {}};
  const Polygon right{{{2, 0.4}, {3, 0.2}, {3.2, 2}, {2, 2.1}}, {}};
  Model model = model_of({left, right}, {"left", 2600, 3.0, 0.2, PlaneState::stress});
  model.materials.push_back({"right", 2000, 7.0, 0.3, PlaneState::strain});
  model.blocks[1].material = 1;
  model.joints = {
      {.name = "joint", .law = InterfaceLaw::projected, .shear_to_normal = 0.5, .normal_stiffness = joint_stiffness}};
  model.stages = {Stage{}};
  model.stages[0].kinematics = Kinematics::small;
  model.stages[0].dt = model.stages[0].duration = 1;
  model.stages[0].integrator = static_integrator();
  place(model, angle, Vec2(-1, 4));
  return model;
}

Vec2 stress_vector(const Model& model, std::size_t block, const Vec3& strain, const Vec2& n) {
  const Vec3 stress = elasticity_matrix(model.materials[block]) * strain;
  return {stress(0) * n.x() + stress(2) * n.y(), stress(2) * n.x() + stress(1) * n.y()};
}

// max over the traction T of T . g - |T - t_a|^2/(4 gamma_a) - |T - t_b|^2/(4 gamma_b) - T^2/(2 k) at one point, found
// by its own condition; the penalty and the widths as the definition has them, penalties found by hand from them.
double potential_at(const std::array<double, 2>& gammas, const Vec2& own_compliance, const Vec2& gap, const Vec2& of_a,
                    const Vec2& of_b) {
  double value = 0;
  for (const int row : {0, 1}) {
    const double weight = 1 / (2 * gammas[0]) + 1 / (2 * gammas[1]) + own_compliance(row);
    const double traction = (gap(row) + of_a(row) / (2 * gammas[0]) + of_b(row) / (2 * gammas[1])) / weight;
    value += traction * gap(row) - std::pow(traction - of_a(row), 2) / (4 * gammas[0]) -
             std::pow(traction - of_b(row), 2) / (4 * gammas[1]) - own_compliance(row) * traction * traction / 2;
  }
  return value;
}

double potential(const Model& model, const Vec12& q, double joint_stiffness) {
  const Interface interface = find_interfaces(model).at(0);
  const Vec2& n = interface.normal;
  const Vec2 along(-n.y(), n.x());
  std::array<double, 2> gammas{};
  double bed = 0;  // compliance
  for (const std::size_t block : {std::size_t{0}, std::size_t{1}}) {
    const Mat3 d = elasticity_matrix(model.materials[block]);
    const double width = extent_along(model.blocks[block].shape.outer, n);
    gammas[block] = projected_penalty(model, static_cast<int>(block)) * d(0, 0) / width;
    bed += width / 2 / (d(0, 0) - d(0, 1) * d(0, 1) / d(1, 1));
  }
  Vec2 own = Vec2::Zero();
  if (joint_stiffness > 0) own = {1 / joint_stiffness, 2 / joint_stiffness};
  const double lever = std::sqrt((1 / (2 * gammas[0]) + 1 / (2 * gammas[1]) + own(0)) / (bed + own(0)) / 3);
  const auto local = [&](const Vec2& v) { return Vec2(n.dot(v), along.dot(v)); };
  const Vec2 of_a = local(stress_vector(model, 0, q.segment<3>(3), n));
  const Vec2 of_b = local(stress_vector(model, 1, q.segment<3>(9), n));
  double energy = 0;
  for (const double place : {-lever, lever}) {
    const Vec2 point = (interface.from + interface.to) / 2 + place * (interface.to - interface.from) / 2;
    const Vec2 gap = motion(q.tail<6>(), point - model.blocks[1].moments.centroid) -
                     motion(q.head<6>(), point - model.blocks[0].moments.centroid);
    energy += interface.length / 2 * potential_at(gammas, own, local(gap), of_a, of_b);
  }
  return energy;
}

Mat12 stiffness_matrix(const Model& model, const ContactSet& contacts) {
  const InterfaceMatrices k = stiffness_of(contacts.elements[0], Vec4::Ones());
  Mat12 matrix;
  matrix << k.aa, k.ba.transpose(), k.ba, k.bb;
  for (const std::size_t block : {std::size_t{0}, std::size_t{1}}) {
    const auto strains = static_cast<Eigen::Index>(6 * block + 3);
    matrix.block<3, 3>(strains, strains) -=
        outline_stiffness(contacts, block, elasticity_matrix(model.materials[block]));
  }
  return matrix;
}

Vec12 force(const Model& model, const ContactSet& contacts, const Vec12& q) {
  const Vec4 gap = gap_increment(contacts.elements[0], q);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(12);
  add_interface_force(contacts.elements[0], elastic_force(contacts.elements[0], gap, {}, {}), gap, sum);
  for (const std::size_t block : {std::size_t{0}, std::size_t{1}}) {
    const auto strains = static_cast<Eigen::Index>(6 * block + 3);
    const Mat3 d = elasticity_matrix(model.materials[block]);
    sum.segment<3>(strains) -= outline_force(contacts, block, d, d * q.segment<3>(strains));
  }
  return sum;
}

TEST(ProjectedLaw, StiffnessAndForcesFollowFromThePotential) {
  for (const double angle : {0.0, 0.4, 1.9, -2.6}) {
    for (const double joint_stiffness : {0.0, 4.0}) {
      const Model model = unlike_pair(angle, joint_stiffness);
      const ContactSet contacts = make_contacts(model);
      ASSERT_EQ(contacts.elements.size(), 1U);
      ASSERT_EQ(contacts.elements[0].law, InterfaceLaw::projected);
      const auto energy = [&](const VecN<12>& q) { return potential(model, q, joint_stiffness); };
      const Mat12 expected = hessian<12>(energy, 1.0);
      // A few hundred products; differences of second order lose two digits of the largest entry.
      EXPECT_LT(relative_difference(stiffness_matrix(model, contacts), expected), 1e-11);
      Vec12 q;
      for (int i = 0; i < 12; ++i) q(i) = std::sin(5.3 * i * i + i + angle);
      EXPECT_LT(relative_difference(force(model, contacts, q), gradient<12>(energy, q, 1.0)), 1e-11);
    }
  }
}

double share_of(const Ring& ring, double poisson, PlaneState plane) {
  return largest_traction_share(model_of({{ring, {}}}, {"rock", 2600, 3.0, poisson, plane}), 0);
}

// In rectangles the largest eigenvalue belongs to uniform shear, or to pressure from all sides, and is known by hand.
TEST(ProjectedLaw, ShareOfTheOutlineInABlocksStiffness) {
  EXPECT_NEAR(share_of(box_ring(0, 0, 1, 1), 0.25, PlaneState::stress), 1.25, 1e-12);
  EXPECT_NEAR(share_of(box_ring(0, 0, 1, 3), 0.25, PlaneState::stress), 1.25, 1e-12);
  // Plane strain: (1 + nu')(E', nu') with E' = E/(1 - nu^2), nu' = nu/(1 - nu).
  EXPECT_NEAR(share_of(box_ring(0, 0, 1, 1), 0.45, PlaneState::strain), 1 + 0.45 / 0.55, 1e-12);
  const double triangle = share_of({{0, 0}, {1, 0}, {0.2, 0.7}}, 0.3, PlaneState::stress);
  EXPECT_GT(triangle, 1.5);
  EXPECT_LE(triangle, 3);
}

TEST(ProjectedLaw, PenaltyIsThreeForRectanglesAndTwiceTheShareElsewhere) {
  EXPECT_EQ(projected_penalty(model_of({{box_ring(0, 0, 1, 2), {}}}, {"rock", 2600, 3.0, 0.2, PlaneState::stress}), 0),
            3);
  const Model triangle = model_of({{{{0, 0}, {1, 0}, {0.2, 0.7}}, {}}}, {"rock", 2600, 3.0, 0.3, PlaneState::stress});
  EXPECT_DOUBLE_EQ(projected_penalty(triangle, 0), 2 * largest_traction_share(triangle, 0));
  EXPECT_GT(projected_penalty(triangle, 0), 3);
}

// A small block lies on a large one, 4 m by 2 m.
Model small_on_large(double length, double height = 0.5, double joint_stiffness = 0) {
  const Polygon large{{{0, 0}, {4, 0}, {4, 2}, {0, 2}}, {}};
  const Polygon small{{{0, 2}, {length, 2}, {length, 2 + height}, {0, 2 + height}}, {}};
  Model model = model_of({large, small}, {"rock", 2600, 3.0, 0.2, PlaneState::stress});
  model.joints = {{.name = "joint", .law = InterfaceLaw::projected, .normal_stiffness = joint_stiffness}};
  model.stages = {Stage{}};
  return model;
}

// Beyond three times the size (the root of the area, here of 8 m2 and of half of the length) joints give way by less in
// proportion, down to a thirtieth.
double share_by_sizes(double length) { return std::max(3 * std::sqrt(0.5 * length / 8), 1.0 / 30); }

// Rock under a strip gives way by about the strip's length and not by its own height, so the stiffness of a joint does
// not fall with its length for ever; where half a side of the large block is loaded it is the law's own.
TEST(ProjectedLaw, ShortStretchesGiveWayByTheirOwnLength) {
  const auto softness_under = [](double length) {
    const Model model = small_on_large(length);
    return projected_softness(model, find_interfaces(model).at(0));
  };
  const Vec2 of_half = softness_under(2);
  EXPECT_EQ(softness_under(1.8)(0), of_half(0));
  EXPECT_NEAR(softness_under(0.01)(0) / of_half(0), 0.01 * share_by_sizes(0.01), 1e-12);
  EXPECT_NEAR(softness_under(0.001)(0) / of_half(0), 0.001 * share_by_sizes(0.001), 1e-12);
}

// A quarter of a side of either block in the stretch: all of a stretch that is shorter. By hand: columns of half of
// each height, that of the large one less in proportion below a length of 1 m, over E = 3.
TEST(ProjectedLaw, SpreadsWhatPressesLessThanAQuarterOfTheSides) {
  const auto spread_under = [](double length, double height, double joint_stiffness) {
    const Model model = small_on_large(length, height, joint_stiffness);
    return projected_spread(model, find_interfaces(model).at(0));
  };
  EXPECT_NEAR(spread_under(4, 0.5, 0), 0.25, 1e-15);
  EXPECT_NEAR(spread_under(2, 0.5, 0), (2 * 0.5 + 0.5 * 0.25) / 2.5, 1e-15);
  EXPECT_NEAR(spread_under(0.5, 0.001, 0), 1, 1e-3);
  EXPECT_NEAR(spread_under(4, 0.5, 3), 0.25 * 1.25 / (1.25 + 1), 1e-15);
}

}  // namespace
}  // namespace dda
