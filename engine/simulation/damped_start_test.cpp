// Motion that begins with a jump under damping, and where the energy of moving feet goes.
#include "engine/simulation/damped_start.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <variant>

#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr double speed = 0.1;  // m/s, of the feet

// A block on springs at its corners whose feet move off at once: it goes along without deforming, an oscillator.
Model block_on_moving_feet(const Integrator& integrator, double omega, double ratio, double dt, int steps) {
  Model model = bar_of(1, bond(InterfaceLaw::consistent));
  finish_model(model);
  const double stiffness = model.mass_of(0) * omega * omega / 4;
  for (const Vec2& corner : model.blocks[0].shape.outer)
    model.supports.push_back({0, corner, true, true, stiffness, Vec2(speed, 0), Constant{}, MotionKind::velocity});
  model.stages = {stage_of(integrator, dt, steps)};
  model.stages[0].material_damping.stiffness = 2 * ratio / omega;
  return model;
}

struct Errors {
  double place = 0, speed = 0;  // the largest; in V dt and in V
};

// Against x = V t + y, y'' + 2 r w y' + w^2 y = 0, y(0) = 0, y'(0) = -V.
Errors errors_of(const Integrator& integrator, double omega, double ratio, double dt, int steps) {
  Simulation simulation = simulation_of(block_on_moving_feet(integrator, omega, ratio, dt, steps));
  const std::complex<double> root = std::sqrt(std::complex<double>(ratio * ratio - 1));
  const std::complex<double> fast = omega * (-ratio - root), slow = omega * (-ratio + root);
  Errors errors;
  for (int i = 1; i <= steps; ++i) {
    run(simulation, 1);
    const double t = i * dt;
    const auto behind = -speed * (std::exp(slow * t) - std::exp(fast * t)) / (slow - fast);
    const auto rate = -speed * (slow * std::exp(slow * t) - fast * std::exp(fast * t)) / (slow - fast);
    const double place = simulation.state().displacement[0](0) - speed * t - behind.real();
    const double velocity = simulation.state().velocity[0](0) - speed - rate.real();
    errors.place = std::max(errors.place, std::abs(place) / (speed * dt));
    errors.speed = std::max(errors.speed, std::abs(velocity) / speed);
  }
  return errors;
}

const std::vector<Integrator> little_damped = {trapezoidal_integrator(), hht_integrator(0.1),
                                               generalized_alpha_integrator(0.85)};

// z = dt C/M from what steps resolve to what they cannot follow. The largest errors are those about z = 3, 0.15 of V
// and of V dt (the same of the formula by hand); without the change at once they were 0.98 V and, under hht, 7 V dt.
TEST(DampedStart, FollowsAFootThatMovesOffAtOnce) {
  for (const Integrator& integrator : little_damped)
    for (const double ratio : {1.01, 5.0, 20.0, 1000.0})
      for (const double dt : {0.002, 0.01, 0.05, 0.2}) {
        const Errors errors = errors_of(integrator, 6.28, ratio, dt, 40);
        EXPECT_LT(errors.place, 0.2) << integrator.name << " ratio " << ratio << " dt " << dt;
        EXPECT_LT(errors.speed, 0.2) << integrator.name << " ratio " << ratio << " dt " << dt;
      }
}

TEST(DampedStart, KeepsTheSecondOrder) {
  for (const Integrator& integrator : little_damped) {
    const double coarse = errors_of(integrator, 6.28, 1.5, 4e-3, 250).speed;
    const double fine = errors_of(integrator, 6.28, 1.5, 2e-3, 500).speed;
    EXPECT_LT(fine, 1e-3) << integrator.name;
    EXPECT_GT(std::log2(coarse / fine), 1.8) << integrator.name;
  }
}

// Feet and blocks that move off at once, or swing, under a damping of up to 30 times what the steps resolve.
Model shaken_bar(bool on_feet, const TimeFunction& history, const Integrator& integrator) {
  Model model = bar_of(6, bond(InterfaceLaw::consistent));
  if (on_feet) {
    for (const double y : {0.0, 0.8})
      model.supports.push_back({0, {0, y}, true, true, 1e10, {speed, speed / 2}, history, MotionKind::velocity});
  } else {
    model.held_blocks = {HeldBlock{0, {speed, speed / 2}, 0, Vec2::Zero(), history, MotionKind::velocity}};
  }
  model.stages = {stage_of(integrator, 1e-4, 200)};
  model.stages[0].material_damping = {.mass = 30, .stiffness = 1e-4};
  return model;
}

// The trapezoidal rule neither loses nor gains, whatever moves against dampers; what these take is never given back.
TEST(DampedStart, TheTrapezoidalRuleLosesNothingToIt) {
  for (const bool on_feet : {true, false})
    for (const TimeFunction& history : {TimeFunction(Constant{}), TimeFunction(SineCycles{100, 10, 0})})
      for (const Integrator& integrator : dynamic_integrators()) {
        Simulation simulation = simulation_of(shaken_bar(on_feet, history, integrator));
        double damping = 0;
        for (int i = 0; i < 200; ++i) {
          run(simulation, 1);
          EXPECT_GE(simulation.energy().damping, damping - 1e-3 * simulation.energy().scale()) << integrator.name;
          damping = simulation.energy().damping;
        }
        // Round-off of products with stiff dampers, 2.4e-11 at most.
        EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-10) << integrator.name;
        EXPECT_GT(damping, 1e-3 * simulation.energy().scale());
        EXPECT_LT(simulation.energy().gain(), 1e-3) << integrator.name;
        // A held block has its prescribed velocity at the start of a step, and at its end what the integrator makes of
        // its motion: the same where that is even.
        const bool is_even = on_feet || std::holds_alternative<Constant>(history);
        if (integrator.name != trapezoidal_integrator().name || !is_even) continue;
        EXPECT_LT(std::abs(simulation.energy().numerical), 1e-10 * simulation.energy().scale());
      }
}

// A stage that begins within a run books what its dampers do at once.
TEST(DampedStart, EnergyBalancesFromStageToStage) {
  for (const bool on_feet : {true, false}) {
    Model model = shaken_bar(on_feet, Constant{}, trapezoidal_integrator());
    model.stages.push_back(model.stages[0]);
    model.stages[0].material_damping = {};
    model.stages[0].duration = 0.01;
    for (std::size_t i = 1; i < 6; ++i) model.blocks[i].initial_velocity = {0.1 * static_cast<double>(i), -0.3};
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, 300);
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-11);
    EXPECT_GT(simulation.energy().damping, 0);
    EXPECT_LT(std::abs(simulation.energy().numerical), 1e-10 * simulation.energy().scale());
  }
}

}  // namespace
}  // namespace dda
