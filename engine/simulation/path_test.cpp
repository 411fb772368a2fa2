// The linear path (constant operators) and the general path (interface by interface) are the same mechanics.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/allocation_counter.h"
#include "engine/simulation/simulation_models.h"
#include "engine/simulation/step_coefficients.h"

namespace dda {
namespace {

// Everything a bonded scene can have.
Model full_scene(const JointMaterial& joint, const Integrator& integrator, bool grid) {
  Model model = grid ? grid_of(3, joint, Pattern::running_bond) : bar_of(5, joint);
  const double right = grid ? 3 : 5;
  const int last = static_cast<int>(model.blocks.size()) - 1;
  const double top = grid ? 2.1 : 0.8;
  const double bottom = grid ? 1.4 : 0;
  model.gravity = {0, -9.81};
  model.edge_loads = {{0, {0, 0.5}, {0, 0.1}, {3e5, 1e5}, SineCycles{60, 1.5, 0}}};
  model.point_loads = {{last, {right - 0.3, bottom + 0.2}, {1e4, -2e4}, Constant{}}};
  model.viscous_edges = {{last, {right, bottom}, {right, top}, 1.6e6, 1e6}};
  model.supports = {{0, {0, 0}, true, true, 2e9, {1e-4, 2e-4}, SineCycles{80, 2, 1e-3}},
                    {last, {right, bottom}, false, true, 1e9, Vec2::Zero(), {}}};
  model.blocks[1].initial_velocity = {0.1, 0.05};
  for (Block& block : model.blocks) block.initial_stress = {-2e5, -1e5, 3e4};
  Stage stage = stage_of(integrator, 4e-4, 100);
  stage.strain_inertia = 1.5;
  stage.damping_rate = 3;
  model.stages = {stage};
  return model;
}

TEST(Paths, LinearAndGeneralGiveTheSameHistories) {
  std::vector<Integrator> integrators = dynamic_integrators();
  integrators.push_back(static_integrator());
  for (Integrator& each : integrators) each = with_contacts(each);  // what the general path does anyway
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::consistent}) {
    for (const bool grid : {false, true}) {
      for (const Integrator& integrator : integrators) {
        Simulation linear = simulation_of(full_scene(bond(law), integrator, grid));
        Simulation general = simulation_of(full_scene(strong(law), integrator, grid));
        ASSERT_TRUE(linear.plan().linear);
        ASSERT_FALSE(general.plan().linear);
        for (int i = 0; i < 100; ++i) {
          ASSERT_EQ(linear.step(), Status::ok);
          ASSERT_EQ(general.step(), Status::ok);
        }
        double displacement = 0, displacement_scale = 0, stress = 0, stress_scale = 0;
        for (std::size_t b = 0; b < linear.state().displacement.size(); ++b) {
          displacement =
              std::max(displacement, (linear.state().displacement[b] - general.state().displacement[b]).norm());
          displacement_scale = std::max(displacement_scale, linear.state().displacement[b].norm());
          stress = std::max(stress, (linear.state().stress[b] - general.state().stress[b]).norm());
          stress_scale = std::max(stress_scale, linear.state().stress[b].norm());
        }
        // A hundred steps that add round-off times the condition of the step's matrix, below 1e3.
        EXPECT_LT(displacement, 1e-11 * displacement_scale) << integrator.name;
        EXPECT_LT(stress, 1e-11 * stress_scale) << integrator.name;
        for (std::size_t i = 0; i < linear.contacts().interfaces.size(); ++i) {
          const InterfaceState one = linear.interface_state(i);
          const InterfaceState other = general.interface_state(i);
          EXPECT_LT((one.force - other.force).norm(), 1e-10 * stress_scale);
          EXPECT_LT((one.gap - other.gap).norm(), 1e-10 * displacement_scale);
        }
        const EnergyLedger& a = linear.energy();
        const EnergyLedger& b = general.energy();
        const double scale = 1e-10 * a.scale();
        EXPECT_NEAR(a.kinetic, b.kinetic, scale);
        EXPECT_NEAR(a.strain, b.strain, scale);
        EXPECT_NEAR(a.contact, b.contact, scale);
        EXPECT_NEAR(a.external_work, b.external_work, scale);
        EXPECT_NEAR(a.gravity_work, b.gravity_work, scale);
        EXPECT_NEAR(a.radiated, b.radiated, scale);
        EXPECT_NEAR(a.dashpot, b.dashpot, scale);
        EXPECT_NEAR(a.damping, b.damping, scale);
        EXPECT_NEAR(a.numerical, b.numerical, scale);
        EXPECT_NEAR(linear.out_of_balance(), general.out_of_balance(), 1e-9 * (1 + general.out_of_balance()));
      }
    }
  }
}

TEST(Paths, CountersSayWhatALinearSceneNeeds) {
  Simulation simulation = simulation_of(full_scene(bond(InterfaceLaw::consistent), trapezoidal_integrator(), false));
  run(simulation, 100);
  const Counters counters = simulation.counters();
  EXPECT_EQ(counters.steps, 100);
  EXPECT_EQ(counters.solves, 100);
  EXPECT_EQ(counters.analyses, 1);
  EXPECT_EQ(counters.factorizations, 1);
  EXPECT_EQ(counters.matrix_rebuilds, 1);
  EXPECT_EQ(counters.open_close_iterations, 0);
}

long allocations_of_warm_steps(Model model) {
  Simulation simulation = simulation_of(std::move(model));
  for (int i = 0; i < 20; ++i) EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
  const long before = allocations_so_far();
  for (int i = 0; i < 20; ++i) {
    if (simulation.step() != Status::ok) return -1;
  }
  return allocations_so_far() - before;
}

TEST(WarmStep, AllocatesNothingInALinearScene) {
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::consistent, InterfaceLaw::cubic}) {
    EXPECT_EQ(allocations_of_warm_steps(full_scene(bond(law), generalized_alpha_integrator(0.8), false)), 0);
    EXPECT_EQ(allocations_of_warm_steps(full_scene(bond(law), thesis_integrator(), true)), 0);
  }
}

TEST(WarmStep, AllocatesNothingWhereContactsAreJudged) {
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::consistent})
    EXPECT_EQ(allocations_of_warm_steps(full_scene(strong(law), generalized_alpha_integrator(0.8), true)), 0);
}

TEST(WarmStep, AllocatesNothingWhileJointsOpenAndSlide) {
  Model model = bar_of(6, bond(InterfaceLaw::classical));
  model.joints[0].bonded = false;
  model.joints[0].friction_angle = 0.4;
  model.joints[0].cohesion = 1e4;
  for (std::size_t i = 0; i < model.blocks.size(); ++i)
    model.blocks[i].initial_velocity = {(i % 2 == 0 ? 0.1 : -0.1), 0.02 * std::sin(static_cast<double>(i))};
  model.stages = {stage_of(generalized_alpha_integrator(0.8), 1e-4, 100)};
  Simulation watched = simulation_of(model);
  run(watched, 40);
  ASSERT_GT(watched.counters().contact_state_changes, 10);
  EXPECT_EQ(allocations_of_warm_steps(std::move(model)), 0);
}

TEST(WarmStep, AllocatesNothingWithBoltsAndAShakenBlock) {
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::consistent}) {
    Model model = full_scene(strong(law), generalized_alpha_integrator(0.8), false);
    HeldBlock held;
    held.amplitude = {1, 0};
    held.history = SineCycles{200, 100, 0};
    held.kind = MotionKind::acceleration;
    model.held_blocks = {held};
    Bolt bolt;
    bolt.links = {{0, 2, model.blocks[0].shape.outer[0], model.blocks[2].shape.outer[2], 1e9, 0}};
    bolt.pretension = bolt.yield_force = 1e3;
    model.bolts = {bolt};
    EXPECT_EQ(allocations_of_warm_steps(std::move(model)), 0);
  }
}

TEST(WarmStep, AllocatesNothingInFiniteKinematics) {
  Model model = full_scene(bond(InterfaceLaw::consistent), generalized_alpha_integrator(0.8), false);
  model.stages[0].kinematics = Kinematics::finite;
  EXPECT_EQ(allocations_of_warm_steps(std::move(model)), 0);
}

}  // namespace
}  // namespace dda
