// The cubic law against the cubic itself: Hermite interpolation between two centroids, integrated by Gauss quadrature.
#include "engine/contact/cubic_law.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>

#include "engine/contact/contact_models.h"
#include "engine/contact/contact_set.h"
#include "engine/scene/generators.h"
#include "engine/terms/potential_check.h"

namespace dda {
namespace {

using Vec12 = Eigen::Matrix<double, 12, 1>;
using Mat12 = Eigen::Matrix<double, 12, 12>;

constexpr double round_off = 1e-11;  // some hundred products, and differences that lose two digits
constexpr double length = 1.6;       // of a block, along the chain
constexpr double width = 0.9;        // of the chain
constexpr std::array angles = {0.0, 0.4, 1.9, -2.6};

Model pair_of(const Material& material, double angle) {
  Model model = model_of({{box_ring(0, 0, length, width), {}}, {box_ring(length, 0, 2 * length, width), {}}}, material);
  model.joints[0].law = InterfaceLaw::cubic;
  model.joints[0].bonded = true;
  place(model, angle, Vec2(3, -2));
  return model;
}

// What the cubic needs of a block: displacement and strains in axes along and across the chain.
struct AxialMotion {
  AxialMotion(const Vec6& q, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    displacement = c * q(0) + s * q(1);
    strain = c * c * q(3) + s * s * q(4) + c * s * q(5);
    lateral = s * s * q(3) + c * c * q(4) - c * s * q(5);
  }
  double displacement, strain, lateral;
};

// Hermite cubic over the cell of length `length` between centroids, t from 0 (block a) to 1 (block b).
struct Hermite {
  AxialMotion a, b;
  [[nodiscard]] double value(double t) const {
    return (1 + 2 * t) * (1 - t) * (1 - t) * a.displacement + t * (1 - t) * (1 - t) * length * a.strain +
           t * t * (3 - 2 * t) * b.displacement + t * t * (t - 1) * length * b.strain;
  }
  [[nodiscard]] double slope(double t) const {
    return 6 * t * (1 - t) * (b.displacement - a.displacement) / length + (1 - t) * (1 - 3 * t) * a.strain +
           t * (3 * t - 2) * b.strain;
  }
};

// Integral over the half [first, first + 1/2] of the cell; four points are exact to degree 7.
template <class Function>
double half_cell(double first, const Function& integrand) {
  constexpr std::array points = {0.861136311594052575, 0.339981043584856265};
  constexpr std::array weights = {0.347854845137453857, 0.652145154862546143};
  double sum = 0;
  for (std::size_t i = 0; i < 2; ++i)
    for (const double sign : {-1.0, 1.0}) sum += weights[i] * integrand(first + (1 + sign * points[i]) / 4);
  return sum * length / 4;
}

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

double axial_kinetic(const Hermite& cubic, double density) {
  const auto straight = [&](const AxialMotion& block, double t) {
    return block.displacement + t * length * block.strain;
  };
  const auto excess = [&](const AxialMotion& block, double from_centroid, double t) {
    return (std::pow(cubic.value(t), 2) - std::pow(straight(block, from_centroid), 2)) / 2;
  };
  return density * width *
         (half_cell(0, [&](double t) { return excess(cubic.a, t, t); }) +
          half_cell(0.5, [&](double t) { return excess(cubic.b, t - 1, t); }));
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
  const double penalty = model.joints[0].penalty * elasticity(0, 0) * width / length;
  const double bar_modulus = elasticity(0, 0) - elasticity(0, 1) * elasticity(0, 1) / elasticity(1, 1);
  // A beam of length L bent by theta between its ends stores E I/(2 L) theta^2, theta = 2 opening/width.
  const double bending = bar_modulus * std::pow(width, 3) / 12 / length * std::pow(2 * opening / width, 2) / 2;
  return width * shear_stress * slide + penalty * slide * slide / 2 + bending;
}

Hermite hermite(const Vec12& q, double angle) {
  return {AxialMotion(q.head<6>(), angle), AxialMotion(q.tail<6>(), angle)};
}

Vec12 some_motion(int seed) {
  Vec12 q;
  for (int i = 0; i < 12; ++i) q(i) = std::sin(3.7 * seed + 5.3 * i * i + i);
  return q;
}

Mat12 joined(const Mat6& aa, const Mat6& ba, const Mat6& bb) {
  return (Mat12() << aa, ba.transpose(), ba, bb).finished();
}

std::array<Material, 2> materials() {
  return {Material{"stress", 2.3, 5.0, 0.3, PlaneState::stress},
          Material{"strain", 2.3, 5.0, 0.35, PlaneState::strain}};
}

TEST(CubicLaw, StiffnessIsTheHessianOfTheCubicsEnergy) {
  for (const Material& material : materials()) {
    for (const double angle : angles) {
      const Model model = pair_of(material, angle);
      const ContactSet contacts = make_contacts(model);
      ASSERT_EQ(contacts.elements.at(0).law, InterfaceLaw::cubic);
      const InterfaceMatrices k = stiffness_of(contacts.elements[0], Vec4::Ones());
      const auto energy = [&](const Vec12& q) {
        return axial_potential(hermite(q, angle), elasticity_matrix(material)) + transverse_potential(model, q, angle);
      };
      EXPECT_LT(relative_difference(joined(k.aa, k.ba, k.bb), hessian<12>(energy, 1)), round_off);
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

TEST(CubicLaw, InertiaIsTheHessianOfTheCubicsKineticEnergy) {
  for (const double angle : angles) {
    const Model model = pair_of(materials()[0], angle);
    const InterfaceMatrices m = interface_inertia(model, find_interfaces(model).at(0), 0, 0.1);
    const auto energy = [&](const Vec12& v) { return axial_kinetic(hermite(v, angle), 2.3); };
    EXPECT_LT(relative_difference(joined(m.aa, m.ba, m.bb), hessian<12>(energy, 1)), round_off);
  }
}

TEST(CubicLaw, CorrectionLowersTheInertiaOfRelativeMotionUpToALimit) {
  const Model model = pair_of(materials()[0], 0.4);
  const Interface interface = find_interfaces(model).at(0);
  const double mass = 2.3 * length * width;
  const double courant = std::sqrt(5.0 / 2.3) * 0.1 / length;
  for (const auto& [error, expected] : {std::pair(0.2, 0.2 * courant * courant), std::pair(1e3, 0.1)}) {
    const InterfaceMatrices plain = interface_inertia(model, interface, 0, 0.1);
    const InterfaceMatrices lowered = interface_inertia(model, interface, error, 0.1);
    Vec12 apart = some_motion(1);
    const AxialMotion a(apart.head<6>(), 0.4), b(apart.tail<6>(), 0.4);
    const double relative = b.displacement - a.displacement;
    const double jump = length * (b.strain - a.strain);
    const Mat12 difference = joined(plain.aa - lowered.aa, plain.ba - lowered.ba, plain.bb - lowered.bb);
    const double of_jump = std::min(expected, 0.05) * jump * jump / 12;
    EXPECT_NEAR(apart.dot(difference * apart) / 2, mass / 2 * (expected * relative * relative + of_jump), round_off);
  }
}

TEST(CubicLaw, LateralInertiaIsTheKineticEnergyOfSidewaysStrain) {
  const double angle = 0.4;
  const Model model = pair_of(materials()[0], angle);
  const double mass = 2.3 * length * width;
  const Mat6 lateral = lateral_inertia(mass, model.blocks[0].moments, find_interfaces(model).at(0).normal);
  // A strip of this width with velocity y e: m width^2/12 e^2/2.
  const auto energy = [&](const Vec6& v) {
    return mass * width * width / 24 * std::pow(AxialMotion(v, angle).lateral, 2);
  };
  EXPECT_LT(relative_difference(lateral, hessian<6>(energy, 1)), round_off);
}

// A motion exp(i theta n) is that of an oscillator whose omega dt is this: the share by which waves are longer or
// shorter than they should be.
double apparent_phase(const Integrator& scheme, double theta) {
  using Complex = std::complex<double>;
  const Complex z = std::polar(1.0, theta);
  const Complex inertia = ((1 - scheme.alpha_m) + scheme.alpha_m / z) * (z - 2.0 + 1.0 / z);
  const Complex time =
      scheme.beta * z + (0.5 + scheme.gamma - 2 * scheme.beta) + (0.5 - scheme.gamma + scheme.beta) / z;
  return std::real(std::sqrt(-inertia / (((1 - scheme.alpha_f) + scheme.alpha_f / z) * time)));
}

TEST(CubicLaw, PeriodErrorIsThatOfTheIntegrator) {
  for (const Integrator& scheme : {thesis_integrator(), trapezoidal_integrator(), hht_integrator(0.1),
                                   generalized_alpha_integrator(0.8), generalized_alpha_integrator(0)}) {
    // The next term is theta^2 times a number of order one; round-off in theta^2 is amplified by theta^-2.
    constexpr double theta = 0.02;
    const double error = 2 * (apparent_phase(scheme, theta) / theta - 1) / (theta * theta);
    EXPECT_NEAR(error, period_error(scheme), 1e-3) << scheme.name;
  }
  EXPECT_NEAR(period_error(trapezoidal_integrator()), 1.0 / 6, 1e-15);
  EXPECT_NEAR(period_error(thesis_integrator()), -1.0 / 48, 1e-15);
}

std::vector<InterfaceLaw> laws_of(const Model& model) {
  std::vector<InterfaceLaw> laws;
  for (const InterfaceElement& element : make_contacts(model).elements) laws.push_back(element.law);
  return laws;
}

Model cubic_bar() {
  Model model = model_of(std::vector<Polygon>{});
  append_bar(model, {.length = 4, .height = 1, .block_length = 1});
  model.joints = {{.name = "bond", .law = InterfaceLaw::cubic, .bonded = true}};
  model.stages = {{.name = "run",
                   .dt = 1e-3,
                   .duration = 1,
                   .integrator = trapezoidal_integrator(),
                   .kinematics = Kinematics::small}};
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
  EXPECT_EQ(laws_of(loaded), (std::vector{InterfaceLaw::consistent, InterfaceLaw::cubic, InterfaceLaw::cubic}));
  Model pushed = cubic_bar();
  pushed.edge_loads.push_back({0, Vec2(0, 1), Vec2(0, 0), Vec2(1, 0), {}});
  pushed.viscous_edges.push_back({3, Vec2(4, 0), Vec2(4, 1), 1, 1});
  EXPECT_EQ(laws_of(pushed), std::vector(3, InterfaceLaw::cubic));
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
