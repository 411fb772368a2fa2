// Orders of the integrators from both sides, on a block held at its centroid by a spring: an oscillator of one unknown.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "engine/simulation/simulation_models.h"
#include "engine/simulation/step_coefficients.h"

namespace dda {
namespace {

constexpr double mass = 2600 * 2.0 * 1.0;
constexpr double stiffness = 4e7;
const double omega = std::sqrt(stiffness / mass);
constexpr double push = 3e4;   // N, from the start on
constexpr double shake = 5e4;  // N, a sine of this frequency
const double shake_omega = 0.37 * omega;
constexpr double velocity = 0.3;

// m x'' + k x = push + shake sin(shake_omega t), x(0) = 0, x'(0) = velocity.
double exact_displacement(double t) {
  const double resonance = shake / (mass * (omega * omega - shake_omega * shake_omega));
  return velocity / omega * std::sin(omega * t) + push / stiffness * (1 - std::cos(omega * t)) +
         resonance * (std::sin(shake_omega * t) - shake_omega / omega * std::sin(omega * t));
}

double exact_velocity(double t) {
  const double resonance = shake / (mass * (omega * omega - shake_omega * shake_omega));
  return velocity * std::cos(omega * t) + push / stiffness * omega * std::sin(omega * t) +
         resonance * shake_omega * (std::cos(shake_omega * t) - std::cos(omega * t));
}

Model oscillator(const Stage& stage) {
  Model model = model_of({{box_ring(0, 0, 2, 1), {}}});
  model.blocks[0].initial_velocity = {velocity, 0};
  model.supports = {{0, {1, 0.5}, true, false, stiffness, Vec2::Zero(), {}}};
  model.point_loads = {{0, {1, 0.5}, {push, 0}, Constant{}},
                       {0, {1, 0.5}, {shake, 0}, SineCycles{shake_omega / (2 * std::numbers::pi), 100, 0}}};
  model.stages = {stage};
  return model;
}

// After 2.3 periods, m: displacement, and velocity over omega. Either alone may pass through zero near some moment.
double error_with(const Integrator& integrator, Kinematics kinematics, int steps) {
  const double end = 2.3 * 2 * std::numbers::pi / omega;
  Simulation simulation = simulation_of(oscillator(stage_of(integrator, end / steps, steps, kinematics)));
  run(simulation, steps);
  return std::hypot(simulation.state().displacement[0](0) - exact_displacement(end),
                    (simulation.state().velocity[0](0) - exact_velocity(end)) / omega);
}

struct OrderCase {
  const char* name;
  Integrator integrator;
  double order;
};

class Order : public testing::TestWithParam<OrderCase> {};
INSTANTIATE_TEST_SUITE_P(Integrators, Order,
                         testing::Values(OrderCase{"thesis", thesis_integrator(), 1},
                                         OrderCase{"trapezoidal", trapezoidal_integrator(), 2},
                                         OrderCase{"hht", hht_integrator(0.1), 2},
                                         OrderCase{"generalized_alpha", generalized_alpha_integrator(0.8), 2},
                                         OrderCase{"generalized_alpha_0", generalized_alpha_integrator(0), 2}),
                         [](const auto& each) { return each.param.name; });

TEST_P(Order, FromBothSides) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    const double coarse = error_with(GetParam().integrator, kinematics, 1600);
    const double fine = error_with(GetParam().integrator, kinematics, 3200);
    // omega dt is 0.009 and 0.0045: the next term of the error moves the slope by about that much.
    EXPECT_NEAR(std::log2(coarse / fine), GetParam().order, 0.02);
  }
}

// Free oscillation under Eq. 5 satisfies x2 - 2 r cos(p) x1 + r^2 x0 = 0 with r^2 = 1/(1 + theta^2/2) and
// 2 r cos(p) = r^2 (2 - theta^2/2).
TEST(ThesisIntegrator, DampsTheContactOscillatorAsDerived) {
  constexpr double theta = 0.11;
  Model model = oscillator(stage_of(thesis_integrator(), theta / omega, 2000));
  model.point_loads.clear();
  Simulation simulation = simulation_of(std::move(model));
  std::vector<double> x{0};
  for (int i = 0; i < 2000; ++i) {
    ASSERT_EQ(simulation.step(), Status::ok);
    x.push_back(simulation.state().displacement[0](0));
  }
  const double r2 = 1 / (1 + theta * theta / 2);
  for (std::size_t i = 2; i < x.size(); ++i)
    ASSERT_NEAR(x[i], r2 * (2 - theta * theta / 2) * x[i - 1] - r2 * x[i - 2], 1e-14 * velocity / omega / theta);
  // Peak of the first and of the last two periods (57 steps each) against exp(-omega^2 dt t/4); the exponent is short
  // by theta^4/16 a step, and a sampled peak lies up to theta^2/8 below the true one.
  const auto peak = [&](std::size_t first) {
    double largest = 0;
    for (std::size_t i = first; i < first + 115; ++i)
      largest = std::max(largest, std::abs(x[i]) * std::exp(theta * theta / 4 * static_cast<double>(i)));
    return largest;
  };
  EXPECT_NEAR(peak(1885) / peak(1), 1, 1885 * std::pow(theta, 4) / 16 + theta * theta / 4);
}

TEST(Trapezoidal, KeepsTheAmplitude) {
  Model model = oscillator(stage_of(trapezoidal_integrator(), 0.11 / omega, 5000));
  model.point_loads.clear();
  Simulation simulation = simulation_of(std::move(model));
  const double start = simulation.energy().kinetic;
  for (int i = 0; i < 5000; ++i) {
    ASSERT_EQ(simulation.step(), Status::ok);
    ASSERT_NEAR(simulation.energy().kinetic + simulation.energy().contact, start, 1e-11 * start);
  }
}

TEST(StepCoefficients, AreTheBalanceOfSettings) {
  // Both sides of "M a(n+1-am) + C v(n+1-af) + K x(n+1-af) = F(n+1-af)" for numbers without a pattern.
  for (const Integrator& integrator : dynamic_integrators()) {
    constexpr double dt = 0.3;
    constexpr double v0 = 1.7, a0 = -0.6, d = 0.9, m = 2.1, c = 0.4, k = 3.3, x0 = 0.2;
    const StepCoefficients s = step_coefficients(integrator, dt);
    const double a1 = (d - dt * v0 - dt * dt * (0.5 - integrator.beta) * a0) / (dt * dt * integrator.beta);
    const double v1 = v0 + dt * ((1 - integrator.gamma) * a0 + integrator.gamma * a1);
    EXPECT_NEAR(s.a_d * d + s.a_v * v0 + s.a_a * a0, a1, 1e-12);
    EXPECT_NEAR(s.v_v * v0 + s.v_a0 * a0 + s.v_a1 * a1, v1, 1e-12);
    const auto at = [](double alpha, double one, double zero) { return (1 - alpha) * one + alpha * zero; };
    const double balance = m * at(integrator.alpha_m, a1, a0) + c * at(integrator.alpha_f, v1, v0) +
                           k * at(integrator.alpha_f, x0 + d, x0);
    const double step = (s.mass * m + s.damping * c + s.stiffness * k) * d + k * x0 -
                        m * (s.mass_v * v0 + s.mass_a * a0) + c * (s.damping_v * v0 + s.damping_a * a0);
    EXPECT_NEAR(step, balance, 1e-12) << integrator.name;
    EXPECT_NEAR(s.load_new, 1 - integrator.alpha_f, 1e-15);
    EXPECT_NEAR(s.load_old, integrator.alpha_f, 1e-15);
    EXPECT_NEAR(s.weight_new_a, 1 - integrator.alpha_m, 1e-15);
  }
}

TEST(Static, ReachesEquilibriumOfSpringAndWeight) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    Model model = bar_of(4, bond(InterfaceLaw::consistent));
    model.gravity = {9.81, 0};
    model.supports = {{0, {0, 0}, true, true, 1e10, Vec2::Zero(), {}},
                      {0, {0, 0.8}, true, true, 1e10, Vec2::Zero(), {}}};
    model.stages = {stage_of(static_integrator(), 10, 60, kinematics)};
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, 60);
    EXPECT_LT(simulation.out_of_balance(), 1e-9);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(simulation.state().velocity[i], Vec6::Zero());
      // Each block hangs from the face behind it: its mean stress is the weight of what follows and half its own.
      // Finite kinematics follow displacements of 1e-4 of the length.
      EXPECT_NEAR(simulation.state().stress[i](0), 2600 * 9.81 * (3.5 - static_cast<double>(i)), 30);
    }
  }
}

}  // namespace
}  // namespace dda
