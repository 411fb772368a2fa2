// Stiffness and forces of an interface against its potential, written here from displacements at points alone.
#include "engine/contact/interface_element.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "engine/contact/contact_models.h"
#include "engine/contact/contact_set.h"
#include "engine/contact/make_contacts.h"
#include "engine/terms/potential_check.h"

namespace dda {
namespace {

using Vec12 = Eigen::Matrix<double, 12, 1>;
using Mat12 = Eigen::Matrix<double, 12, 12>;

// A few hundred products; differences of second order lose two digits of the largest entry.
constexpr double round_off = 1e-11;

Vec2 motion(const Vec6& q, const Vec2& offset) {
  const double x = offset.x();
  const double y = offset.y();
  return {q(0) - q(2) * y + q(3) * x + q(5) / 2 * y, q(1) + q(2) * x + q(4) * y + q(5) / 2 * x};
}

// Two blocks of different sizes, shapes and materials that touch along a part of their edges, turned by `angle`.
Model unlike_pair(double angle, InterfaceLaw law) {
  const Polygon left{{{0, 0}, {2, 0}, {2, 1.5}, {0.3, 1.2}}, {}};
  const Polygon right{{{2, 0.4}, {3, 0.2}, {3.2, 2}, {2, 2.1}}, {}};
  Model model = model_of({left, right}, {"left", 2600, 3.0, 0.2, PlaneState::stress});
  model.materials.push_back({"right", 2000, 7.0, 0.3, PlaneState::strain});
  model.blocks[1].material = 1;
  model.joints = {{.name = "joint",
                   .law = law,
                   .spring_over_young = 13,
                   .shear_to_normal = 0.3,
                   .penalty = 5,
                   .stabilisation = 0.2}};
  place(model, angle, Vec2(-1, 4));
  return model;
}

struct Pair {
  explicit Pair(const Model& given) : model(given), contacts(make_contacts(given)) {}

  [[nodiscard]] const Interface& interface() const { return contacts.interfaces.at(0); }
  [[nodiscard]] const InterfaceElement& element() const { return contacts.elements.own().at(0); }
  [[nodiscard]] Vec2 jump(const Vec12& q, const Vec2& point) const {
    return motion(q.tail<6>(), point - model.blocks[1].moments.centroid) -
           motion(q.head<6>(), point - model.blocks[0].moments.centroid);
  }
  // Normal stress vector that a block's strain exerts across the interface.
  [[nodiscard]] Vec2 traction(const Vec3& strain, std::size_t block) const {
    const Vec3 stress =
        elasticity_matrix(model.materials[static_cast<std::size_t>(model.blocks[block].material)]) * strain;
    const Vec2& n = interface().normal;
    return {stress(0) * n.x() + stress(2) * n.y(), stress(2) * n.x() + stress(1) * n.y()};
  }

  const Model& model;
  ContactSet contacts;
};

double spring_energy(const Vec2& jump, const Vec2& normal, double normal_stiffness, double shear_stiffness) {
  const double opening = normal.dot(jump);
  const double sliding = -normal.y() * jump.x() + normal.x() * jump.y();
  return (normal_stiffness * opening * opening + shear_stiffness * sliding * sliding) / 2;
}

double classical_energy(const Pair& pair, const Vec12& q) {
  const double normal = 13 * 3.0;  // the softer block's
  double energy = 0;
  for (const Vec2& end : {pair.interface().from, pair.interface().to})
    energy += spring_energy(pair.jump(q, end), pair.interface().normal, normal, 0.3 * normal);
  return energy;
}

double consistent_energy(const Pair& pair, const Vec12& q) {
  const Interface& interface = pair.interface();
  const double modulus = 7.0 * 0.7 / (1.3 * 0.4);        // plane strain, the stiffer block's
  const double unit = modulus * interface.length / 1.2;  // over the smaller width, of the right block
  const Vec2 at_from = pair.jump(q, interface.from);
  const Vec2 at_to = pair.jump(q, interface.to);
  const Vec2 mean_traction = (pair.traction(q.segment<3>(3), 0) + pair.traction(q.segment<3>(9), 1)) / 2;
  return interface.length * mean_traction.dot(at_from + at_to) / 2 +
         spring_energy((at_from + at_to) / 2, interface.normal, 5 * unit, 5 * unit) +
         spring_energy((at_to - at_from) / 2, interface.normal, 0.2 * unit, 0.2 * unit);
}

Mat12 stiffness_matrix(const InterfaceElement& element, const Vec4& mask = Vec4::Ones()) {
  const InterfaceMatrices k = stiffness_of(element, mask);
  Mat12 matrix;
  matrix << k.aa, k.ba.transpose(), k.ba, k.bb;
  return matrix;
}

Vec12 internal_force(const Pair& pair, const Vec12& q) {
  const InterfaceElement& element = pair.element();
  const Vec3 stress_a = elasticity_matrix(pair.model.materials[0]) * q.segment<3>(3);
  const Vec3 stress_b = elasticity_matrix(pair.model.materials[1]) * q.segment<3>(9);
  const Vec4 gap = gap_increment(element, q);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(12);
  add_interface_force(element, elastic_force(element, gap, stress_a, stress_b), gap, force);
  return force;
}

Vec12 some_motion(int seed) {
  Vec12 q;
  for (int i = 0; i < 12; ++i) q(i) = std::sin(3.7 * seed + 5.3 * i * i + i);
  return q;
}

constexpr std::array angles = {0.0, 0.4, 1.9, -2.6};

class TwoLaws : public testing::TestWithParam<InterfaceLaw> {
 protected:
  static double energy(const Pair& pair, const Vec12& q) {
    return GetParam() == InterfaceLaw::classical ? classical_energy(pair, q) : consistent_energy(pair, q);
  }
};

INSTANTIATE_TEST_SUITE_P(InterfaceElement, TwoLaws, testing::Values(InterfaceLaw::classical, InterfaceLaw::consistent),
                         [](const auto& law) {
                           return law.param == InterfaceLaw::classical ? "classical" : "consistent";
                         });

TEST_P(TwoLaws, StiffnessIsTheHessianOfThePotential) {
  for (const double angle : angles) {
    const Model model = unlike_pair(angle, GetParam());
    const Pair pair(model);
    const Mat12 stiffness = stiffness_matrix(pair.element());
    EXPECT_LT(relative_difference(stiffness, stiffness.transpose()), round_off);
    EXPECT_LT(relative_difference(stiffness, hessian<12>([&](const Vec12& q) { return energy(pair, q); }, 1)),
              round_off);
  }
}

TEST_P(TwoLaws, ForceAndEnergyFollowFromThePotential) {
  for (const double angle : angles) {
    const Model model = unlike_pair(angle, GetParam());
    const Pair pair(model);
    for (int seed = 1; seed <= 3; ++seed) {
      const Vec12 q = some_motion(seed);
      const auto potential = [&](const Vec12& at) { return energy(pair, at); };
      EXPECT_LT(relative_difference(internal_force(pair, q), gradient<12>(potential, q, 1)), round_off);
      InterfaceState state;
      state.gap = gap_increment(pair.element(), q);
      state.force = elastic_force(pair.element(), state.gap, elasticity_matrix(model.materials[0]) * q.segment<3>(3),
                                  elasticity_matrix(model.materials[1]) * q.segment<3>(9));
      EXPECT_NEAR(interface_energy(pair.element(), state), potential(q), round_off * std::abs(potential(q)));
    }
  }
}

TEST_P(TwoLaws, RigidMotionOfBothBlocksCausesNoForce) {
  for (const double angle : angles) {
    const Model model = unlike_pair(angle, GetParam());
    const Pair pair(model);
    const Vec2 pole(0.7, -0.2);
    for (const Vec3& rigid : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
      Vec12 q = Vec12::Zero();
      for (int block = 0; block < 2; ++block) {
        const Vec2 arm = model.blocks[static_cast<std::size_t>(block)].moments.centroid - pole;
        q.segment<3>(6 * block) = rigid + rigid(2) * Vec3(-arm.y(), arm.x(), 0);
      }
      const double scale = stiffness_matrix(pair.element()).cwiseAbs().maxCoeff();
      EXPECT_LT(internal_force(pair, q).cwiseAbs().maxCoeff(), round_off * scale);
    }
  }
}

TEST_P(TwoLaws, ActionEqualsReaction) {
  const Model model = unlike_pair(0.4, GetParam());
  const Pair pair(model);
  const Vec12 force = internal_force(pair, some_motion(4));
  EXPECT_NEAR((force.segment<2>(0) + force.segment<2>(6)).norm(), 0, round_off * force.norm());
  const Vec2 arm = model.blocks[1].moments.centroid - model.blocks[0].moments.centroid;
  const double moment = force(2) + force(8) + arm.x() * force(7) - arm.y() * force(6);
  EXPECT_NEAR(moment, 0, round_off * force.norm());
}

TEST(InterfaceElement, MaskedRowsCarryNothing) {
  const Model model = unlike_pair(0.4, InterfaceLaw::classical);
  const Pair pair(model);
  const auto energy = [&](const Vec12& q) {  // `from` slides, `to` is open
    return spring_energy(pair.jump(q, pair.interface().from), pair.interface().normal, 13 * 3.0, 0);
  };
  EXPECT_LT(relative_difference(stiffness_matrix(pair.element(), Vec4(1, 0, 0, 0)), hessian<12>(energy, 1)), round_off);
}

TEST(InterfaceElement, NormalSpringGivenOutrightAndPointContact) {
  Model model = model_of({{box_ring(-2, -1, 2, 0), {}}, {{{0.3, 0}, {1, 2}, {-1, 1.5}}, {}}});
  model.joints = {{.name = "joint", .law = InterfaceLaw::consistent, .normal_spring = 55, .shear_to_normal = 0.5}};
  const ContactSet contacts = make_contacts(model);
  EXPECT_EQ(contacts.elements.own().at(0).law, InterfaceLaw::classical);  // a point has no edge to be consistent on
  EXPECT_EQ(contacts.elements.own().at(0).stiffness, Vec4(55, 27.5, 0, 0));
}

TEST(InterfaceElement, InitialStressOfBothBlocksPressesWithoutGap) {
  Model model = model_of({{box_ring(0, 0, 1, 2), {}}, {box_ring(1, 0, 2, 2), {}}});
  model.blocks[0].initial_stress = model.blocks[1].initial_stress = Vec3(-5, -7, 2);
  const ContactSet contacts = make_contacts(model);
  EXPECT_NEAR((contacts.states.at(0).force - Vec4(-10, 4, 0, 0)).norm(), 0, round_off);  // 2 m of (sigma_xx, sigma_xy)
  EXPECT_NEAR(
      (mean_traction(model, contacts.interfaces[0], contacts.elements[0], contacts.states[0]) - Vec2(-5, 2)).norm(), 0,
      round_off);
}

}  // namespace
}  // namespace dda
