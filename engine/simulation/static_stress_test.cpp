// Static stress on edges that absorb waves: supports that are let go and leave their force, dashpots that begin late.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/simulation/simulation_models.h"
#include "engine/simulation/snapshot.h"

namespace dda {
namespace {

constexpr double gravity = 9.81;
constexpr int settling = 20;  // steps

// A column of 6 blocks under its weight: settles on rollers and walls, which then go, and dashpots take their place.
Model settled_column(InterfaceLaw law, const Integrator& integrator, Kinematics settles, Kinematics waves) {
  Model model;
  model.materials = {rock()};
  model.joints = {bond(law)};
  for (int i = 0; i < 6; ++i) model.blocks.push_back(rectangle("", 0, i, 1, 1));
  model.gravity = {0, -gravity};
  for (int i = 0; i < 6; ++i)
    for (const double x : {0.0, 1.0}) {
      model.supports.push_back({i, {x, i + 0.5}, true, false, 3e10, Vec2::Zero(), {}});
      model.supports.back().last_stage = 0;
      model.viscous_edges.push_back({i, {x, 1.0 * i}, {x, i + 1.0}, 1e7, 6e6, 1});
    }
  for (const double x : {0.0, 1.0}) {
    model.supports.push_back({0, {x, 0}, false, true, 2e10, Vec2::Zero(), {}});
    model.supports.back().last_stage = 0;
  }
  model.viscous_edges.push_back({0, {0, 0}, {1, 0}, 1e7, 6e6, 1});
  model.stages = {stage_of(static_integrator(), 10, settling, settles), stage_of(integrator, 1e-4, 100, waves)};
  model.stages[0].name = "settle";
  return model;
}

// What a weight dropped on it would make of it: g t.
void expect_stays(Simulation& simulation, double tolerance) {
  const State settled = simulation.state();
  run(simulation, 100);
  const double fall = gravity * 0.01;
  for (std::size_t i = 0; i < settled.stress.size(); ++i) {
    EXPECT_LT(simulation.state().velocity[i].cwiseAbs().maxCoeff(), tolerance * fall) << i;
    EXPECT_LT((simulation.state().stress[i] - settled.stress[i]).norm(), tolerance * settled.stress[0].norm()) << i;
  }
}

TEST(SupportsLetGo, LeaveWhatTheyHeldAtRest) {
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::consistent, InterfaceLaw::cubic})
    for (const Integrator& integrator : dynamic_integrators()) {
      Simulation simulation = simulation_of(settled_column(law, integrator, Kinematics::small, Kinematics::small));
      run(simulation, settling);
      // The weight presses the foot, and the walls the sides.
      EXPECT_LT(simulation.state().stress[0](1), -5 * 2500 * gravity);
      EXPECT_LT(simulation.state().stress[0](0), 0);
      expect_stays(simulation, 1e-9);  // the linear solver's digits, times the condition of the springs
      EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-11);
    }
}

TEST(SupportsLetGo, LeaveWhatTheyHeldAtRestInMovingGeometry) {
  for (const auto& [settles, waves] : {std::pair(Kinematics::finite, Kinematics::finite),
                                       {Kinematics::finite, Kinematics::small},
                                       {Kinematics::small, Kinematics::finite}})
    for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::consistent}) {
      Simulation simulation = simulation_of(settled_column(law, generalized_alpha_integrator(0.8), settles, waves));
      run(simulation, settling);
      expect_stays(simulation, 1e-4);  // strains of 1e-5 between the geometry of the one stage and that of the other
    }
}

// Without the forces left behind it would fall through its dashpots at once.
TEST(SupportsLetGo, TakeTheirEnergyWithThem) {
  Simulation simulation = simulation_of(
      settled_column(InterfaceLaw::consistent, trapezoidal_integrator(), Kinematics::small, Kinematics::small));
  run(simulation, settling - 1);
  const EnergyLedger before = simulation.energy();
  run(simulation, 1);
  const EnergyLedger after = simulation.energy();
  const double weight = 6 * simulation.model().mass_of(0) * gravity;
  // Two springs under the foot hold the weight, twelve at the sides a little.
  EXPECT_LT(after.external_work, -weight * weight / (2 * 4e10));
  EXPECT_NEAR(after.external_work, after.contact - before.contact, 1e-12 * before.contact);
  EXPECT_LT(std::abs(after.relative_residual()), 1e-11);
}

TEST(SupportsLetGo, KeepAForceThatStillMovesThePoint) {
  Model model = bar_of(1, bond(InterfaceLaw::consistent));
  model.supports = {{0, {0, 0.4}, true, true, 1e6, {1e-3, 0}, Constant{}}};
  model.supports[0].last_stage = 0;
  model.stages = {stage_of(trapezoidal_integrator(), 1e-4, 1), stage_of(trapezoidal_integrator(), 1e-4, 100)};
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 1);
  const double velocity = simulation.state().velocity[0](0);
  const double moved = point_displacement(simulation.model(), simulation.state(), 0, {0, 0.4}).x();
  run(simulation, 100);
  const double force = 1e6 * (1e-3 - moved);
  EXPECT_NEAR(simulation.state().velocity[0](0), velocity + force / simulation.model().mass_of(0) * 1e-2,
              1e-9 * force / simulation.model().mass_of(0) * 1e-2);
  EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-11);
}

// A block hung by two springs at its centroid, which do not strain it: m u'' = -m g - k u. One is taken away.
Model hung_by_two_springs(const Integrator& second, double dt, int steps, Kinematics kinematics) {
  Model model = model_of({{box_ring(0, 0, 1, 1), {}}});
  model.gravity = {0, -gravity};
  for (int i = 0; i < 2; ++i) model.supports.push_back({0, {0.5, 0.5}, true, true, 1e6, Vec2::Zero(), {}});
  model.supports[1].last_stage = 0;
  model.supports[1].takes_force_along = true;
  model.stages = {stage_of(static_integrator(), 10, settling, kinematics), stage_of(second, dt, steps, kinematics)};
  return model;
}

TEST(SupportsTakenAway, LeaveTheirShareToTheOthers) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    Simulation simulation = simulation_of(hung_by_two_springs(static_integrator(), 10, settling, kinematics));
    run(simulation, settling);
    const double weight = simulation.model().mass_of(0) * gravity;
    EXPECT_NEAR(simulation.state().displacement[0](1), -weight / 2e6, 1e-12 * weight / 2e6);
    run(simulation, settling);
    EXPECT_NEAR(simulation.state().displacement[0](1), -weight / 1e6, 1e-12 * weight / 1e6);
    EXPECT_LT(simulation.out_of_balance(), 1e-12);
  }
}

// It swings to twice the new settlement: u = -w/k + w/(2 k) cos(n theta), tan(theta/2) = omega dt/2 by the trapezoidal
// rule, which is exact to round-off.
TEST(SupportsTakenAway, AtOnceMakeItSwingTwiceAsFar) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    constexpr int steps = 200;
    constexpr double dt = 2e-3;
    Simulation simulation = simulation_of(hung_by_two_springs(trapezoidal_integrator(), dt, steps, kinematics));
    run(simulation, settling);
    const EnergyLedger before = simulation.energy();
    const double mass = simulation.model().mass_of(0);
    const double settlement = mass * gravity / 1e6;
    const double angle = 2 * std::atan(std::sqrt(1e6 / mass) * dt / 2);
    double lowest = 0;
    for (int n = 1; n <= steps; ++n) {
      run(simulation, 1);
      const double expected = -settlement + settlement / 2 * std::cos(n * angle);
      EXPECT_NEAR(simulation.state().displacement[0](1), expected, 1e-11 * settlement) << n;  // 200 steps of round-off
      lowest = std::min(lowest, simulation.state().displacement[0](1));
    }
    // From half the settlement to 1.5 times it, less what falls between two steps: 1 - cos(angle/2).
    EXPECT_NEAR(lowest, -1.5 * settlement, 0.5 * settlement * (1 - std::cos(angle / 2)));
    // The spring's energy, k u^2/2 of u = w/(2 k), went with it.
    EXPECT_NEAR(before.external_work, -1e6 * settlement * settlement / 8, 1e-9 * 1e6 * settlement * settlement);
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-11);
  }
}

// Point by point as if it had never been there: with no load left over, a free block falls by g t^2/2.
TEST(SupportsTakenAway, LeaveNoForce) {
  for (const Integrator& integrator : dynamic_integrators()) {
    if (integrator.is_static) continue;
    Model model = hung_by_two_springs(integrator, 1e-3, 100, Kinematics::small);
    model.supports.erase(model.supports.begin());
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, settling + 100);
    EXPECT_NEAR(simulation.state().velocity[0](1), -gravity * 0.1, 1e-11);
  }
}

TEST(ViscousEdge, ActsFromItsFirstStageOn) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    Model model = bar_of(1, bond(InterfaceLaw::consistent));
    model.blocks[0].initial_velocity = {0, 1};
    model.viscous_edges = {{0, {0, 0}, {1, 0}, 1e4, 1e4, 1}};
    model.stages = {stage_of(trapezoidal_integrator(), 1e-4, 100, kinematics),
                    stage_of(trapezoidal_integrator(), 1e-4, 100, kinematics)};
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, 100);
    EXPECT_NEAR(simulation.state().velocity[0](1), 1, 1e-12);
    EXPECT_EQ(simulation.energy().radiated, 0);
    run(simulation, 100);
    const double decay = 1e4 / simulation.model().mass_of(0);  // 1/s
    EXPECT_NEAR(simulation.state().velocity[0](1), std::exp(-decay * 0.01), 1e-2 * decay * 0.01);
    EXPECT_GT(simulation.energy().radiated, 0);
  }
}

}  // namespace
}  // namespace dda
