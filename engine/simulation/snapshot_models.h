// Scenes that between them have all that a snapshot must hold.
#pragma once

#include <memory>
#include <vector>

#include "engine/simulation/simulation_models.h"

namespace dda::snapshots {

inline Model bare_model(InterfaceLaw law, Kinematics kinematics) {
  Model model;
  model.materials = {{"rock", 2650, 50e9, 0.25, PlaneState::stress}};
  JointMaterial joint;
  joint.law = law;
  joint.spring_over_young = 4;
  model.joints = {joint};
  Stage stage;
  stage.dt = 1e-4;
  stage.duration = 100e-4;
  stage.kinematics = kinematics;
  model.stages = {stage};
  return model;
}

// A bonded bar with a dashpot at its right end, pushed on the left, its foot held and shaken.
inline Model bar(InterfaceLaw law) {
  Model model = bare_model(law, Kinematics::small);
  model.joints[0].bonded = true;
  for (int i = 0; i < 6; ++i) model.blocks.push_back(rectangle(fmt::format("b{}", i), 2.0 * i, 0, 2, 1));
  model.edge_loads = {{0, {0, 1}, {0, 0}, {1e6, 0}, SineCycles{300, 1.5, 0}}};
  model.viscous_edges = {{5, {12, 0}, {12, 1}, 1e7, 6e6}};
  model.supports = {{2, {5, 0}, true, true, 1e10, {1e-4, 0}, SineCycles{100, 1, 1e-3}}};
  finish_model(model);
  return model;
}

// Inertia lowered and loads sharpened to make up for the period error of the steps.
inline Model corrected_bar() {
  Model model = bar(InterfaceLaw::cubic);
  model.stages[0].correct_time_dispersion = true;
  return model;
}

inline Model corrected_mesh() {
  Model model = bar(InterfaceLaw::consistent);
  model.stages[0].correct_block_dispersion = true;
  model.stages[0].correct_time_dispersion = true;
  return model;
}

// Bricks on a shaken floor, thrown up so that joints break, slide, open and close.
inline Model shaken_stack(InterfaceLaw law, Kinematics kinematics) {
  Model model = bare_model(law, kinematics);
  model.joints[0].friction_angle = 0.5;
  model.joints[0].cohesion = 2e4;
  model.joints[0].tensile_strength = 1e4;
  model.blocks = {rectangle("floor", -1, -1, 4, 1), rectangle("low", 0, 0, 1, 0.5),
                  rectangle("high", 0.2, 0.5, 1, 0.5)};
  model.blocks[2].initial_velocity = {0.2, 0.1};
  model.blocks[2].initial_spin = -0.3;
  model.gravity = {0, -300};  // so that what is thrown up comes down within the few steps of a test
  model.supports = {{0, {-1, -1}, true, true, 1e11, {2e-4, 1e-4}, SineCycles{150, 10, 0}},
                    {0, {3, -1}, true, true, 1e11, {2e-4, 0}, SineCycles{150, 10, 0}}};
  model.point_loads = {{2, {1.2, 0.75}, {-2e3, 0}, SineCycles{80, 10, 0}}};
  model.stages[0].integrator = generalized_alpha_integrator(0.8);
  finish_model(model);
  return model;
}

// Two dry bricks that in-situ stress holds between floor and roof, one of them pushed to and fro beyond its friction.
inline Model stressed_stack() {
  Model model = shaken_stack(InterfaceLaw::classical, Kinematics::finite);
  model.joints[0].cohesion = model.joints[0].tensile_strength = 0;
  model.blocks = {rectangle("floor", -1, -1, 4, 1), rectangle("low", 0, 0, 1, 0.5), rectangle("high", 0, 0.5, 1, 0.5),
                  rectangle("roof", -1, 1, 4, 1)};
  for (Block& block : model.blocks) block.initial_stress = {0, -1e5, 0};
  model.supports.clear();
  model.held_blocks.resize(2);
  model.held_blocks[1].block = 3;
  model.point_loads = {{2, {1, 0.75}, {-1.5e5, 0}, SineCycles{150, 10, 0}}};
  finish_model(model);
  return model;
}

// Half of the steps in finite, half in small kinematics, whose geometry is then neither that of the drawing nor of now.
inline Model two_stages() {
  Model model = shaken_stack(InterfaceLaw::classical, Kinematics::finite);
  model.viscous_edges = {{2, {1.2, 0.5}, {1.2, 1}, 1e6, 5e5}};
  model.stages[0].duration = 30e-4;
  model.stages.push_back(model.stages[0]);
  model.stages[1].kinematics = Kinematics::small;
  model.stages[1].duration = 70e-4;
  model.stages[1].strain_inertia = 2;
  model.stages[1].damping_rate = 5;
  finish_model(model);
  return model;
}

// Two dry bricks with dampers in their contacts slide down a slope after a stage in which they stick: what the rule for
// contacts says depends on the stage.
inline Model slides_after_sticking() {
  Model model = bare_model(InterfaceLaw::classical, Kinematics::finite);
  model.joints[0].friction_angle = 0.3;
  model.joints[0].contact_damping = 0.2;
  model.blocks = {rectangle("slope", -1, -1, 6, 1), rectangle("low", 0, 0, 1, 0.5), rectangle("high", 0, 0.5, 1, 0.5)};
  model.held_blocks = {HeldBlock{}};
  model.gravity = {7, -7};
  model.stages[0].integrator = static_integrator();
  model.stages[0].unlimited_strength = true;
  model.stages[0].duration = 20e-4;
  model.stages.push_back(model.stages[0]);
  model.stages[1].integrator = generalized_alpha_integrator(0.8);
  model.stages[1].unlimited_strength = false;
  model.stages[1].duration = 80e-4;
  finish_model(model);
  return model;
}

// A linear stage that begins with stresses, displacements and gaps.
inline Model bar_first_finite() {
  Model model = bar(InterfaceLaw::consistent);
  model.stages[0].duration = 30e-4;
  model.stages[0].kinematics = Kinematics::finite;
  model.stages.push_back(model.stages[0]);
  model.stages[1].kinematics = Kinematics::small;
  model.stages[1].duration = 70e-4;
  finish_model(model);
  return model;
}

inline TimeFunction ground_motion() {
  return Recorded{
      std::make_shared<const Recording>("", std::vector{0.0, 0.003, 0.006, 0.02}, std::vector{0.0, 90.0, -120.0, 0.0}),
      0};
}

// The floor shaken by a recording, the stack tied to it by bolts that yield.
inline Model bolted_stack(Kinematics kinematics) {
  Model model = shaken_stack(InterfaceLaw::classical, kinematics);
  model.supports.clear();
  model.held_blocks = {HeldBlock{}};
  model.held_blocks[0].amplitude = {1, 0.2};
  model.held_blocks[0].kind = MotionKind::acceleration;
  model.held_blocks[0].history = ground_motion();
  for (const double x : {0.3, 0.9}) {
    Bolt bolt;
    bolt.name = fmt::format("bolt {}", x);
    bolt.direction = {0, 1};
    bolt.links = {{0, 2, {x, -0.5}, {x, 0.8}, 4e8, 0}};
    bolt.pretension = 1e3;
    bolt.yield_force = 3e4;
    model.bolts.push_back(bolt);
  }
  finish_model(model);
  return model;
}

// A block hangs from one that is held, by two bolts and nothing else.
inline Model hanging_block() {
  Model model = bare_model(InterfaceLaw::classical, Kinematics::finite);
  model.blocks = {rectangle("roof", 0, 2, 2, 1), rectangle("block", 0, 0.5, 2, 1)};
  model.held_blocks = {HeldBlock{}};
  model.gravity = {0, -10};
  for (const double x : {0.5, 1.5}) {
    Bolt bolt;
    bolt.name = fmt::format("bolt {}", x);
    bolt.direction = {0, -1};
    bolt.links = {{0, 1, {x, 2.5}, {x, 1}, 1e8 * x, 0}};
    model.bolts.push_back(bolt);
  }
  model.stages[0].dt = 1e-3;
  model.stages[0].duration = 0.1;
  finish_model(model);
  return model;
}

// Bonded, elastic but for its bolts.
inline Model bolted_bar() {
  Model model = bar(InterfaceLaw::consistent);
  model.supports.clear();
  model.held_blocks = {HeldBlock{}};
  model.held_blocks[0].amplitude = {1, 0};
  model.held_blocks[0].kind = MotionKind::acceleration;
  model.held_blocks[0].history = ground_motion();
  Bolt bolt;
  bolt.name = "bolt";
  bolt.grouted = true;
  bolt.links = {{1, 2, {4, 0.5}, {4, 0.5}, 1e10, 1e9}, {2, 3, {6, 0.5}, {6, 0.5}, 1e10, 1e9}};
  bolt.yield_force = 2e3;
  model.bolts = {bolt};
  finish_model(model);
  return model;
}

// Two blocks on a shaken base with a column beside their left side, which begins to act at step 40.
inline Model beside_a_column(Kinematics kinematics) {
  Model model = bare_model(InterfaceLaw::classical, kinematics);
  model.joints[0].friction_angle = 0.5;
  model.joints[0].cohesion = model.joints[0].tensile_strength = 1e4;
  model.blocks = {rectangle("base", 0, -1, 3, 1), rectangle("low", 0, 0, 1, 0.5), rectangle("high", 0, 0.5, 1, 0.5),
                  rectangle("loose", 1.5, 0, 1, 0.5)};
  model.blocks[3].initial_velocity = {0.2, 0.1};
  model.gravity = {0, -300};
  model.held_blocks = {HeldBlock{}};
  model.held_blocks[0].amplitude = {1, 0.2};
  model.held_blocks[0].kind = MotionKind::acceleration;
  model.held_blocks[0].history = ground_motion();
  model.viscous_edges = {{1, {0, 0.5}, {0, 0}, 1e6, 5e5, 1}, {2, {0, 1}, {0, 0.5}, 1e6, 5e5, 1}};
  model.free_field_sides = {{{0, 1}, -1}};
  model.stages[0].duration = 40e-4;
  model.stages.push_back(model.stages[0]);
  model.stages[1].duration = 60e-4;
  finish_model(model);
  return model;
}

inline Model bonded_finite() {
  Model model = bar(InterfaceLaw::consistent);
  model.stages[0].kinematics = Kinematics::finite;
  return model;
}

// Under gravity on springs that go at step 30; then it leans on a dashpot.
inline Model let_go(Kinematics kinematics) {
  Model model = bar(InterfaceLaw::consistent);
  model.gravity = {0, -9.81};
  model.supports = {{2, {5, 0}, true, true, 1e10, {1e-4, 0}, SineCycles{100, 1, 1e-3}},
                    {4, {10, 0}, true, true, 1e10, Vec2::Zero(), {}}};
  for (PointSupport& support : model.supports) support.last_stage = 0;
  model.viscous_edges[0].first_stage = 1;
  model.stages[0].kinematics = kinematics;
  model.stages[0].duration = 30e-4;
  model.stages.push_back(model.stages[0]);
  model.stages[1].duration = 70e-4;
  finish_model(model);
  return model;
}

// One of the springs takes its force along.
inline Model taken_away(Kinematics kinematics) {
  Model model = let_go(kinematics);
  model.supports[1].takes_force_along = true;
  return model;
}

}  // namespace dda::snapshots
