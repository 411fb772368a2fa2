// The cubic law against the cubic itself.
#include "engine/contact/cubic_law.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/builder/generators.h"
#include "engine/contact/contact_models.h"
#include "engine/contact/contact_set.h"
#include "engine/contact/cubic_pair_models.h"
#include "engine/contact/make_contacts.h"
#include "engine/terms/potential_check.h"

namespace dda {
namespace {

using namespace cubic_pair;

constexpr double round_off = 1e-11;  // some hundred products, and differences that lose two digits

// Elastic energy of the cubic less that of the two straight half blocks; the strain that the cubic adds is free to
// contract sideways.
double axial_potential(const Hermite& cubic, const Mat3& elasticity) {
  const double contraction = elasticity(0, 1) / elasticity(1, 1);
  const auto density = [&](const AxialMotion& block, double strain) {
    const Vec3 e(strain, block.lateral - contraction * (strain - block.strain), 0);
    const Vec3 straight(block.strain, block.lateral, 0);
    return (e.dot(elasticity * e) - straight.dot(elasticity * straight)) / 2;
  };
  return width * (half_cell(0, [&](double t) { return density(cubic.a, cubic.slope(t)); }) +
                  half_cell(0.5, [&](double t) { return density(cubic.b, cubic.slope(t)); }));
}

// The rest of the law: Nitsche's method for the tangential gap, and a spring for the opening of one end against the
// other. Both from the displacement jumps at the ends.
double transverse_potential(const Model& model, const Vec12& q, double angle) {
  const Interface interface = find_interfaces(model).at(0);
  const Mat3 elasticity = elasticity_matrix(model.materials[0]);
  const Vec2 n = interface.normal;
  const Vec2 t(-n.y(), n.x());
  const auto jump = [&](const Vec2& point) -> Vec2 {
    return displacement_rows(point - model.blocks[1].moments.centroid) * q.tail<6>() -
           displacement_rows(point - model.blocks[0].moments.centroid) * q.head<6>();
  };
  const Vec3 stress = elasticity * (q.segment<3>(3) + q.segment<3>(9)) / 2;
  const double shear_stress = std::cos(2 * angle) * stress(2) + std::sin(2 * angle) * (stress(1) - stress(0)) / 2;
  const double slide = t.dot(jump(interface.from) + jump(interface.to)) / 2;
  const double opening = n.dot(jump(interface.to) - jump(interface.from)) / 2;
  const double penalty = model.joints[0].penalty * std::min(elasticity(0, 0), 4 * elasticity(2, 2)) * width / length;
  const double bar_modulus = elasticity(0, 0) - elasticity(0, 1) * elasticity(0, 1) / elasticity(1, 1);
  // A beam of length L bent by theta between its ends stores E I/(2 L) theta^2, theta = 2 opening/width.
  const double bending = bar_modulus * std::pow(width, 3) / 12 / length * std::pow(2 * opening / width, 2) / 2;
  return width * shear_stress * slide + penalty * slide * slide / 2 + bending;
}

TEST(CubicLaw, StiffnessIsTheHessianOfTheCubicsEnergy) {
  for (const Material& material : materials()) {
    for (const double angle : angles) {
      const Model model = pair_of(material, angle);
      const ContactSet contacts = make_contacts(model);
      ASSERT_EQ(contacts.elements.own().at(0).law, InterfaceLaw::cubic);
      const InterfaceMatrices k = stiffness_of(contacts.elements[0], Vec4::Ones());
      const auto energy = [&](const Vec12& q) {
        return axial_potential(hermite(q, angle), elasticity_matrix(material)) + transverse_potential(model, q, angle);
      };
      EXPECT_LT(relative_difference(joined(k), hessian<12>(energy, 1)), round_off);
    }
  }
}

TEST(CubicLaw, EnergyOfAStateIsThatOfTheCubic) {
  const double angle = 0.4;
  for (const Material& material : materials()) {
    const Model model = pair_of(material, angle);
    const ContactSet contacts = make_contacts(model);
    const Mat3 elasticity = elasticity_matrix(material);
    for (int seed = 1; seed <= 3; ++seed) {
      const Vec12 q = some_motion(seed);
      const InterfaceState state = linear_state(contacts.elements[0], Vec4::Zero(), q.head<6>(), q.tail<6>(),
                                                elasticity * q.segment<3>(3), elasticity * q.segment<3>(9));
      const double expected = axial_potential(hermite(q, angle), elasticity) + transverse_potential(model, q, angle);
      EXPECT_NEAR(interface_energy(contacts.elements[0], state), expected, round_off * std::abs(expected));
    }
  }
}

TEST(CubicLaw, TractionIsThatOfTheCubicAtTheInterface) {
  const double angle = 0.4;
  for (const Material& material : materials()) {
    const Model model = pair_of(material, angle);
    const ContactSet contacts = make_contacts(model);
    const Mat3 elasticity = elasticity_matrix(material);
    Vec12 q = some_motion(2);
    const Vec3 stress_a = elasticity * q.segment<3>(3);
    const Vec3 stress_b = elasticity * q.segment<3>(9);
    const InterfaceState state =
        linear_state(contacts.elements[0], Vec4::Zero(), q.head<6>(), q.tail<6>(), stress_a, stress_b);
    // With free sides sigma = Q w'; here each block has a lateral stress too, of which the mean of both shows.
    const double modulus = side_free_modulus(material);
    const double mean_lateral = [&] {
      double sum = 0;
      for (const Vec3& e : {Vec3(q.segment<3>(3)), Vec3(q.segment<3>(9))}) {
        Vec6 unknowns = Vec6::Zero();
        unknowns.tail<3>() = e;
        const AxialMotion axial(unknowns, angle);
        const Vec3 stress = elasticity * Vec3(axial.strain, axial.lateral, 0);
        sum += (stress(0) - side_free_ratio(material) * stress(1) - modulus * axial.strain) / 2;
      }
      return sum;
    }();
    EXPECT_NEAR(mean_lateral, 0, round_off);
    const Vec2 traction = mean_traction(model, contacts.interfaces[0], contacts.elements[0], state);
    EXPECT_NEAR(traction(0), modulus * hermite(q, angle).slope(0.5), round_off * modulus);
  }
}

std::vector<InterfaceLaw> laws_of(const Model& model) {
  std::vector<InterfaceLaw> laws;
  const ContactSet contacts = make_contacts(model);
  for (const InterfaceElement& element : contacts.elements.own()) laws.push_back(element.law);
  return laws;
}

Model cubic_bar() {
  Model model = model_of(std::vector<Polygon>{});
  append_bar(model, {.length = 4, .height = 1, .block_length = 1});
  model.joints = {{.name = "bond", .law = InterfaceLaw::cubic, .bonded = true}};
  Stage& stage = model.stages.emplace_back();
  stage.dt = 1e-3;
  stage.duration = 1;
  stage.integrator = trapezoidal_integrator();
  stage.kinematics = Kinematics::small;
  finish_model(model);
  return model;
}

TEST(CubicCandidates, BarIsCubicThroughout) {
  EXPECT_EQ(laws_of(cubic_bar()), std::vector(3, InterfaceLaw::cubic));
  Model turned = cubic_bar();
  place(turned, 0.7, Vec2(3, 4));
  EXPECT_EQ(laws_of(turned), std::vector(3, InterfaceLaw::cubic));
}

TEST(CubicCandidates, NotWhereAnythingCanChange) {
  Model loose = cubic_bar();
  loose.joints[0].bonded = false;
  EXPECT_EQ(laws_of(loose), std::vector(3, InterfaceLaw::consistent));
  Model moving = cubic_bar();
  moving.stages[0].kinematics = Kinematics::finite;
  EXPECT_EQ(laws_of(moving), std::vector(3, InterfaceLaw::consistent));
}

TEST(CubicCandidates, NotBesideAnotherMaterialOrALoadedSide) {
  Model mixed = cubic_bar();
  mixed.materials.push_back(mixed.materials[0]);
  mixed.blocks[3].material = 1;
  EXPECT_EQ(laws_of(mixed), (std::vector{InterfaceLaw::cubic, InterfaceLaw::cubic, InterfaceLaw::consistent}));
  Model loaded = cubic_bar();
  loaded.edge_loads.push_back({0, Vec2(0, 1), Vec2(1, 1), Vec2(0, -1), {}});
  EXPECT_EQ(laws_of(loaded), std::vector(3, InterfaceLaw::consistent));
  Model pushed = cubic_bar();
  pushed.edge_loads.push_back({0, Vec2(0, 1), Vec2(0, 0), Vec2(1, 0), {}});
  pushed.viscous_edges.push_back({3, Vec2(4, 0), Vec2(4, 1), 1, 1});
  EXPECT_EQ(laws_of(pushed), std::vector(3, InterfaceLaw::cubic));
}

// A bar turned by `angle` with one support at (x, y) of its own axes that holds along (along, across).
Model supported_bar(double angle, const Vec2& point, const Vec2& direction) {
  Model model = cubic_bar();
  place(model, angle, Vec2(3, 4));
  PointSupport support;
  support.block = std::clamp(static_cast<int>(point.x()), 0, 3);
  support.point = rotation(angle) * point + Vec2(3, 4);
  support.stiffness = 1e9;
  support.direction = rotation(angle) * direction;
  model.supports.push_back(support);
  return model;
}

TEST(CubicCandidates, NotInAChainWhoseSidesAreHeld) {
  const Vec2 across(0, 1);
  for (const double angle : angles) {
    for (const Vec2& side : {Vec2(2.5, 0), Vec2(1, 1), Vec2(0.2, 1), Vec2(3.9, 0), Vec2(3.5, 0.7)}) {
      EXPECT_EQ(laws_of(supported_bar(angle, side, across)), std::vector(3, InterfaceLaw::consistent)) << side;
      EXPECT_EQ(laws_of(supported_bar(angle, side, Vec2(1, 0))), std::vector(3, InterfaceLaw::cubic)) << side;
      Model loaded = supported_bar(angle, side, Vec2(1, 0));
      loaded.point_loads.push_back({loaded.supports[0].block, loaded.supports[0].point, rotation(angle) * across, {}});
      EXPECT_EQ(laws_of(loaded), std::vector(3, InterfaceLaw::consistent)) << side;
    }
    for (const Vec2& elsewhere : {Vec2(0, 0), Vec2(0, 1), Vec2(4, 0), Vec2(4, 0.3), Vec2(2.2, 0.5)})
      EXPECT_EQ(laws_of(supported_bar(angle, elsewhere, across)), std::vector(3, InterfaceLaw::cubic)) << elsewhere;
  }
}

TEST(CubicCandidates, NotInAGridNorBetweenUnequalBlocks) {
  Model grid = cubic_bar();
  grid.blocks.clear();
  append_grid(grid, {.columns = 2, .rows = 2, .block_width = 1, .block_height = 1});
  finish_model(grid);
  EXPECT_EQ(laws_of(grid), std::vector(4, InterfaceLaw::consistent));
  Model unequal = cubic_bar();
  for (Vec2& vertex : unequal.blocks[3].shape.outer)
    if (vertex.x() > 3.5) vertex.x() = 5;
  finish_model(unequal);
  EXPECT_EQ(laws_of(unequal), (std::vector{InterfaceLaw::cubic, InterfaceLaw::cubic, InterfaceLaw::consistent}));
}

}  // namespace
}  // namespace dda
