// Joints that open and slide, and consistent joints that go over to the classical law.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr double gravity = 10;
constexpr double weight = 2600 * 1.0 * 2.0 * gravity;  // of the block on the floor

// A block 1 m wide and 2 m high on a floor that is held at its corners.
Model block_on_floor(InterfaceLaw law, const Stage& stage) {
  Model model = model_of({{box_ring(-3, -1, 4, 0), {}}, {box_ring(0, 0, 1, 2), {}}});
  model.joints[0].law = law;
  model.joints[0].friction_angle = std::atan(0.8);
  model.gravity = {0, -gravity};
  model.supports = {{0, {-3, -1}, true, true, 1e12, Vec2::Zero(), {}},
                    {0, {4, -1}, true, true, 1e12, Vec2::Zero(), {}}};
  model.stages = {stage};
  return model;
}

bool some_end_is(const Simulation& simulation, ContactStatus status) {
  const InterfaceState state = simulation.interface_state(0);
  return state.status[0] == status || state.status[1] == status;
}

// Pushed sideways at half its height the block tips when push * 1 m exceeds weight * 0.5 m.
TEST(Uplift, AtTheMomentThatTipsTheBlock) {
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::consistent}) {
    for (const double share : {0.49, 0.51, -0.49, -0.51}) {
      Model model = block_on_floor(law, stage_of(static_integrator(), 0.1, 40));
      // First its weight, then the push, which else would meet a joint without pressure.
      model.point_loads = {{1, {0.5, 1}, {share * weight, 0}, PiecewiseLinear{{1, 3}, {0, 1}}}};
      Simulation simulation = simulation_of(std::move(model));
      while (!simulation.finished() && !some_end_is(simulation, ContactStatus::open))
        ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
      EXPECT_EQ(some_end_is(simulation, ContactStatus::open), std::abs(share) > 0.5)
          << "law " << static_cast<int>(law) << ", push " << share;
    }
  }
}

TEST(Sliding, AtTheFrictionAngle) {
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::consistent, InterfaceLaw::projected}) {
    for (const double share : {0.79, 0.81}) {
      Model model = block_on_floor(law, stage_of(static_integrator(), 0.1, 40));
      model.point_loads = {{1, {0.5, 0}, {share * weight, 0}, PiecewiseLinear{{1, 3}, {0, 1}}}};
      Simulation simulation = simulation_of(std::move(model));
      run(simulation, 40);
      const InterfaceState state = simulation.interface_state(0);
      const bool slides = state.status[0] == ContactStatus::sliding && state.status[1] == ContactStatus::sliding;
      EXPECT_EQ(slides, share > 0.8) << "law " << static_cast<int>(law) << ", push " << share;
    }
  }
}

// A consistent joint gives way in the middle of a dynamic step: the step's solution must be that of the forces it
// leaves.
TEST(ConsistentJoint, GivesWayWithoutAJumpOfMomentum) {
  Model model = bar_of(2, {});
  model.joints[0].tensile_strength = model.joints[0].cohesion = 1e5;
  for (std::size_t i = 0; i < 2; ++i) model.blocks[i].initial_velocity = {i == 0 ? -0.1 : 0.1, 0.03};
  model.blocks[1].initial_spin = 0.05;
  for (const Integrator& integrator : dynamic_integrators()) {
    model.stages = {stage_of(integrator, 1e-5, 200)};
    Simulation simulation = simulation_of(model);
    bool broke = false;
    for (int i = 0; i < 200; ++i) {
      ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
      // Not at once, so that there is a gap, and with it a force of Nitsche's method on the strains, to lose.
      EXPECT_FALSE(broke && i < 3);
      broke = broke || simulation.contacts().elements[0].law == InterfaceLaw::classical;
      // Both blocks weigh the same.
      const Vec2 mean = (simulation.state().velocity[0] + simulation.state().velocity[1]).head<2>() / 2;
      ASSERT_LT((mean - Vec2(0, 0.03)).norm(), 1e-12) << "step " << i;
      ASSERT_LT(std::abs(simulation.energy().relative_residual()), 1e-9) << integrator.name << ", step " << i;
    }
    EXPECT_TRUE(broke) << integrator.name;
  }
}

// A block hung by a joint a thousandth too weak: it breaks in the step that finds it so, and not one later because what
// the joint's law did to the strains has gone with it.
TEST(ConsistentJoint, BreaksInTheStepThatExceedsItsStrength) {
  constexpr double dt = 1e-3;
  Model model;
  model.materials = {rock()};
  model.joints.resize(1);
  model.joints[0].tensile_strength = 0.999 * rock().density * 10 * 2;
  model.joints[0].cohesion = 1e6;
  model.blocks = {rectangle("held", 0, 0, 1, 1), rectangle("hung", 0, -2, 1, 2)};
  model.gravity = {0, -10};
  for (const double x : {0.0, 1.0}) model.supports.push_back({0, {x, 1}, true, true, 1e12, Vec2::Zero(), {}});
  Stage settle = stage_of(static_integrator(), 0.1, 10);
  settle.unlimited_strength = true;
  model.stages = {settle, stage_of(thesis_integrator(), dt, 1)};
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 11);
  EXPECT_NEAR(simulation.state().velocity[1](1), -10 * dt, 1e-12);
}

}  // namespace
}  // namespace dda
