// Explicit steps by central differences: against the closed form of the discrete oscillator, against the implicit step
// as dt goes to 0, and that they conserve, go on to the last bit and allocate nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/core/allocation_counter.h"
#include "engine/core/error.h"
#include "engine/core/parallel.h"
#include "engine/simulation/block_system.h"
#include "engine/simulation/explicit_models.h"
#include "engine/simulation/memory_test_support.h"
#include "engine/simulation/stability_limit.h"

namespace dda {
namespace {

using namespace explicit_models;

constexpr double held_mass = 2600 * 2.0 * 1.0;
constexpr double spring = 4e7;
const double spring_omega = std::sqrt(spring / held_mass);

// A block held at its centroid: an oscillator of one unknown. Its strains, which nothing moves, are far faster.
Model oscillating_block(double dt, int steps) {
  Model model = model_of({{box_ring(0, 0, 2, 1), {}}});
  model.joints = {bond(InterfaceLaw::consistent)};
  model.blocks[0].initial_velocity = {0.3, 0};
  model.supports = {{0, {1, 0.5}, true, false, spring, Vec2::Zero(), {}}};
  model.stages = {stage_of(central_difference_integrator(), dt, steps)};
  return model;
}

// x_(n+1) - 2 x_n + x_(n-1) = -theta^2 x_n with x_0 = 0 and x_1 = dt v: x_n = dt v sin(n phi)/sin(phi), cos(phi) =
// 1 - theta^2/2.
TEST(ExplicitStep, IsTheDiscreteOscillator) {
  const double dt = 4e-4;
  Simulation simulation = simulation_of(oscillating_block(dt, 400));
  const double phi = std::acos(1 - std::pow(spring_omega * dt, 2) / 2);
  for (int n = 1; n <= 400; ++n) {
    ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
    // Round-off of each step stays and turns by phi a step: some 400 of them over theta = 0.035.
    ASSERT_NEAR(simulation.state().displacement[0](0), 0.3 * dt * std::sin(n * phi) / std::sin(phi),
                1e-12 * 0.3 / spring_omega)
        << "step " << n;
  }
}

// One mode of a bar: all of K and M, with the inertia between the blocks of a cubic chain too. A block matrix has no
// closed form, so the mode and its frequency come from dense algebra over the operators.
TEST(ExplicitStep, KeepsAModeOfABarToRoundOff) {
  for (const InterfaceLaw law : {InterfaceLaw::consistent, InterfaceLaw::cubic, InterfaceLaw::classical}) {
    Model model = bar_of(6, bond(law));
    model.stages = {explicit_stage(1e-4, 400)};
    finish_model(model);
    const DenseModes modes = modes_of(model);
    const Eigen::Index last = modes.squares.size() - 1;
    for (const Eigen::Index mode : {Eigen::Index{3}, last / 2, last}) {  // the first three are rigid motion
      const Eigen::VectorXd shape = modes.shapes.col(mode);
      set_in_motion(shape, model);
      Simulation simulation(model);
      const double phi = std::acos(1 - modes.squares(mode) * 1e-8 / 2);
      for (int n = 1; n <= 300; ++n) {
        ASSERT_EQ(simulation.step(), Status::ok);
        const double amplitude = 1e-4 / std::sin(phi);
        const double off = (displacements(simulation) - amplitude * std::sin(n * phi) * shape).norm();
        ASSERT_LT(off, 1e-10 * amplitude * shape.norm()) << "mode " << mode << ", step " << n;
      }
    }
  }
}

// Second order against the exact motion, from both sides, with loads and dashpots.
TEST(ExplicitStep, ConvergesToTheImplicitStepWithOrderTwo) {
  std::mt19937 random(4917);
  for (int scene = 0; scene < 12; ++scene) {
    const RandomBondedScene drawn(random, false);
    const double dt = 0.5 * drawn.stable_dt();
    const auto off = [&](int parts) {
      Simulation simulation(drawn.with(explicit_stage(dt / parts, 64 * parts)));
      run(simulation, 64 * parts);
      return displacements(simulation);
    };
    Simulation fine(drawn.with(stage_of(trapezoidal_integrator(), dt / 64, 64 * 64)));
    run(fine, 64 * 64);
    const Eigen::VectorXd exact = displacements(fine);
    const double coarse = (off(2) - exact).norm(), half = (off(4) - exact).norm();
    // The reference's own error is 1/128 of the finer one's (its period error is twice as large, dt a sixteenth).
    EXPECT_NEAR(coarse / half, 4, 0.35) << "scene " << scene;
    EXPECT_LT(half, 0.05 * exact.norm()) << "scene " << scene;
  }
}

// The ledger closes, and nothing is lost or won by the steps themselves, at nine tenths of the limit.
TEST(ExplicitStep, AccountsForAllEnergy) {
  std::mt19937 random(1201);
  for (int scene = 0; scene < 40; ++scene) {
    const RandomBondedScene drawn(random, true);
    const Stage stage = drawn.random_stage(random, 0.9 * drawn.stable_dt(), 200);
    Simulation simulation(drawn.with(stage));
    run(simulation, 200);
    const EnergyLedger& energy = simulation.energy();
    EXPECT_LT(std::abs(energy.relative_residual()), 1e-11) << "scene " << scene;
    EXPECT_LT(std::abs(energy.numerical), 1e-11 * energy.scale()) << "scene " << scene;
  }
}

// Explicit and implicit steps count kinetic energy differently: no stage gains or loses that.
TEST(ExplicitStep, HandsOverNoEnergyThatItDoesNotHave) {
  std::mt19937 random(4);
  for (int scene = 0; scene < 30; ++scene) {
    const RandomBondedScene drawn(random, true);
    const Stage first = explicit_stage(0.95 * drawn.stable_dt(), 30);
    const Stage between = stage_of(trapezoidal_integrator(), 1.7 * drawn.stable_dt(), 15);
    const Stage last = explicit_stage(0.5 * drawn.stable_dt(), 30);
    Model model = drawn.with(first);
    model.stages = {first, between, last, last, between};
    finish_model(model);
    Simulation simulation(model);
    run(simulation, 120);
    const EnergyLedger& energy = simulation.energy();
    EXPECT_LT(std::abs(energy.relative_residual()), 1e-11) << "scene " << scene;
    EXPECT_LT(std::abs(energy.numerical), 1e-10 * energy.scale()) << "scene " << scene;
  }
}

// A static stage that follows takes off the kinetic energy that the blocks have, and finds no other at the start than
// central differences count otherwise.
TEST(ExplicitStep, EndsWithTheKineticEnergyOfItsVelocities) {
  for (const InterfaceLaw law : {InterfaceLaw::consistent, InterfaceLaw::classical}) {
    Model model = grid_of(20, bond(law));
    model.edge_loads = {{0, {0, 0.7}, {0, 0}, {3e5, 1e5}, SineCycles{60, 1.5, 0}}};
    model.stages = {explicit_stage(1e-4, 100)};
    Model alone = model;
    finish_model(alone);
    Simulation before(alone);
    run(before, 100);
    model.stages.push_back(stage_of(static_integrator(), 1, 1));
    finish_model(model);
    Simulation simulation(model);
    run(simulation, 101);
    const double kinetic = kinetic_energy(before.system().terms, before.state());
    const double scale = before.energy().scale();
    ASSERT_GT(kinetic, 0.01 * scale);
    EXPECT_NEAR(simulation.energy().initial.kinetic, kinetic - before.energy().kinetic, 1e-11 * scale);
    EXPECT_GE(simulation.energy().damping, (1 - 1e-11) * kinetic);  // and what it finds on its way
  }
}

TEST(ExplicitStep, GoesOnToTheLastBit) {
  std::mt19937 random(77);
  for (int scene = 0; scene < 12; ++scene) {
    const RandomBondedScene drawn(random, true);
    const Model model = drawn.with(drawn.random_stage(random, 0.8 * drawn.stable_dt(), 60));
    Simulation whole(model);
    const int at = std::uniform_int_distribution(1, 59)(random);
    run(whole, at);
    const State state = whole.state();
    const std::vector<std::byte> snapshot = save(whole);
    run(whole, 60 - at);
    Simulation resumed(model);
    restore(resumed, state, snapshot);
    run(resumed, 60 - at);
    EXPECT_EQ(memory_of(resumed), memory_of(whole)) << "scene " << scene << " at " << at;
  }
}

TEST(ExplicitStep, HasTheBitsOfOneThread) {
  Model model = grid_of(40, bond(InterfaceLaw::consistent));
  model.edge_loads = {{0, {0, 0.7}, {0, 0}, {3e5, 1e5}, SineCycles{60, 1.5, 0}}};
  model.gravity = {0, -9.81};
  model.viscous_edges = {{39, {40, 0}, {40, 0.7}, 1.6e6, 1e6}};
  model.stages = {explicit_stage(1e-4, 40)};
  finish_model(model);
  const auto bits = [&](int threads) {
    const ThreadsInUse in_use(threads);
    Simulation simulation(model);
    run(simulation, 40);
    return memory_of(simulation);
  };
  EXPECT_EQ(bits(1), bits(2));
}

TEST(ExplicitStep, AllocatesNothing) {
  std::mt19937 random(5);
  for (int scene = 0; scene < 6; ++scene) {
    const RandomBondedScene drawn(random, true);
    Simulation simulation(drawn.with(drawn.random_stage(random, 0.5 * drawn.stable_dt(), 40)));
    run(simulation, 5);
    const long before = allocations_so_far();
    for (int i = 0; i < 20; ++i) ASSERT_EQ(simulation.step(), Status::ok);
    EXPECT_EQ(allocations_so_far() - before, 0) << "scene " << scene;
  }
}

// A static stage, explicit steps, implicit ones, explicit ones again: what was in balance stays at rest.
TEST(ExplicitStep, KeepsTheBalanceThatItFinds) {
  for (const InterfaceLaw law : {InterfaceLaw::consistent, InterfaceLaw::cubic}) {
    Model model = bar_of(5, bond(law));
    model.gravity = {1, -9.81};
    model.supports = {{0, {0, 0}, true, true, 2e9, Vec2::Zero(), {}},
                      {0, {0, 0.8}, true, false, 1e9, Vec2::Zero(), {}}};
    Stage settling = stage_of(static_integrator(), 1, 20);
    model.stages = {settling, explicit_stage(1e-4, 50), stage_of(trapezoidal_integrator(), 1e-4, 20),
                    explicit_stage(1e-4, 50)};
    finish_model(model);
    Simulation simulation(model);
    run(simulation, 20);
    const Eigen::VectorXd settled = displacements(simulation);
    run(simulation, 120);
    EXPECT_TRUE(simulation.finished());
    // Round-off: 2e-15 was measured.
    EXPECT_LT((displacements(simulation) - settled).norm(), 1e-13 * settled.norm());
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-11);
  }
}

// A block of a grid that hangs from its upper row is removed while it swings: as under the trapezoidal rule, whose
// error is as large and of the other sign (-1/12 and 1/6 of omega^2 dt^2).
TEST(ExplicitStep, GoesOnWithoutWhatIsRemoved) {
  const auto swung = [](const Integrator& integrator, double dt, int steps) {
    Model model = grid_of(3, bond(InterfaceLaw::consistent));
    model.gravity = {0, -9.81};
    for (const int block : {6, 7, 8})
      model.supports.push_back({block, {block - 5.5, 2.1}, true, true, 2e8, Vec2::Zero(), {}});
    Stage later = stage_of(integrator, dt, steps);
    later.name = "without";
    later.removal.blocks = {4};
    model.stages = {stage_of(integrator, dt, steps), later};
    Simulation simulation = simulation_of(model);
    run(simulation, 2 * steps);
    EXPECT_TRUE(simulation.finished());
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-11);
    EXPECT_GT(simulation.energy().removed, 0);
    return displacements(simulation);
  };
  const Eigen::VectorXd exact = swung(trapezoidal_integrator(), 5e-6, 4000);
  const double coarse = (swung(central_difference_integrator(), 1e-4, 200) - exact).norm();
  const double fine = (swung(central_difference_integrator(), 5e-5, 400) - exact).norm();
  EXPECT_LT(fine, 0.01 * exact.norm());
  // Short waves, which the removal at once sets going, are not of second order yet at these steps.
  EXPECT_GT(coarse / fine, 2.5);
}

// A load beyond all numbers: the step that meets it is not taken.
TEST(ExplicitStep, AStepThatFailsLeavesTheStateAsItWas) {
  std::mt19937 random(11);
  for (int i = 0; i < 20; ++i) {
    const RandomBondedScene scene(random, i % 2 == 0);
    const double dt = 0.5 * scene.stable_dt();
    Model model = scene.with(RandomBondedScene::random_stage(random, dt, 10));
    const TimeFunction history = PiecewiseLinear{{0, 5 * dt, 6 * dt}, {0, 0, 1e300}};
    model.point_loads.push_back({0, model.blocks[0].moments.centroid, {1, 1}, history});
    Simulation simulation = simulation_of(model);
    Status status = Status::ok;
    State before;
    EnergyLedger ledger;
    std::vector<Vec2> gaps;
    const auto gaps_of_supports = [&] {
      std::vector<Vec2> all;
      for (const SupportElement& support : simulation.system().supports) all.push_back(support.gap);
      return all;
    };
    while (status == Status::ok && !simulation.finished()) {
      before = simulation.state();
      ledger = simulation.energy();
      gaps = gaps_of_supports();
      status = simulation.step();
    }
    ASSERT_EQ(status, Status::not_finite) << i;
    EXPECT_EQ(simulation.energy().external_work, ledger.external_work);
    EXPECT_EQ(simulation.energy().residual(), ledger.residual());
    EXPECT_EQ(gaps_of_supports(), gaps);
    const State& now = simulation.state();
    EXPECT_EQ(now.time, before.time);
    EXPECT_EQ(now.acceleration, before.acceleration);
    for (std::size_t b = 0; b < before.velocity.size(); ++b) {
      // Velocities are differences of those in the middle of the step and what a half step adds, ten times as large.
      EXPECT_LE((now.velocity[b] - before.velocity[b]).norm(),
                1e-11 * (before.velocity[b].norm() + dt * before.acceleration[b].norm()));
      EXPECT_LE((now.displacement[b] - before.displacement[b]).norm(),
                1e-11 * (before.displacement[b].norm() + dt * before.velocity[b].norm()));
      EXPECT_LT((now.stress[b] - before.stress[b]).norm(), 1e-9 * (before.stress[b].norm() + 1));
      EXPECT_LT((now.deformation[b] - before.deformation[b]).norm(), 1e-12);
    }
  }
}

}  // namespace
}  // namespace dda
