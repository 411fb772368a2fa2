#include "dda/simulation/snapshot.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <memory>
#include <string>

#include "dda/core/error.h"
#include "dda/simulation/simulation_models.h"

namespace dda {
namespace {

Model bare_model(InterfaceLaw law, Kinematics kinematics) {
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
Model bar(InterfaceLaw law) {
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
Model corrected_bar() {
  Model model = bar(InterfaceLaw::cubic);
  model.stages[0].correct_time_dispersion = true;
  return model;
}

Model mesh_inertia() {
  Model model = bar(InterfaceLaw::consistent);
  model.stages[0].strain_inertia = Stage::by_mesh;
  return model;
}

// Bricks on a shaken floor, thrown up so that joints break, slide, open and close.
Model shaken_stack(InterfaceLaw law, Kinematics kinematics) {
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
Model stressed_stack() {
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
Model two_stages() {
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

// A linear stage that begins with stresses, displacements and gaps.
Model bar_first_finite() {
  Model model = bar(InterfaceLaw::consistent);
  model.stages[0].duration = 30e-4;
  model.stages[0].kinematics = Kinematics::finite;
  model.stages.push_back(model.stages[0]);
  model.stages[1].kinematics = Kinematics::small;
  model.stages[1].duration = 70e-4;
  finish_model(model);
  return model;
}

TimeFunction ground_motion() {
  return Recorded{
      std::make_shared<const Recording>("", std::vector{0.0, 0.003, 0.006, 0.02}, std::vector{0.0, 90.0, -120.0, 0.0}),
      0};
}

// The floor shaken by a recording, the stack tied to it by bolts that yield.
Model bolted_stack(Kinematics kinematics) {
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
Model hanging_block() {
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
Model bolted_bar() {
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
Model beside_a_column(Kinematics kinematics) {
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

Model bonded_finite() {
  Model model = bar(InterfaceLaw::consistent);
  model.stages[0].kinematics = Kinematics::finite;
  return model;
}

// Under gravity on springs that go at step 30; then it leans on a dashpot.
Model let_go(Kinematics kinematics) {
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
Model taken_away(Kinematics kinematics) {
  Model model = let_go(kinematics);
  model.supports[1].takes_force_along = true;
  return model;
}

template <typename Values>
void expect_same_bits(const Values& a, const Values& b, const char* what) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_EQ(std::memcmp(a[i].data(), b[i].data(), sizeof a[i]), 0) << what << " of block " << i;
}

void expect_same(const Simulation& a, const Simulation& b) {
  EXPECT_EQ(a.state().time, b.state().time);
  EXPECT_EQ(a.state().step, b.state().step);
  expect_same_bits(a.state().displacement, b.state().displacement, "displacement");
  expect_same_bits(a.state().velocity, b.state().velocity, "velocity");
  expect_same_bits(a.state().acceleration, b.state().acceleration, "acceleration");
  expect_same_bits(a.state().stress, b.state().stress, "stress");
  expect_same_bits(a.state().deformation, b.state().deformation, "deformation");
  EXPECT_EQ(std::memcmp(&a.energy(), &b.energy(), sizeof(EnergyLedger)), 0);
  EXPECT_EQ(a.out_of_balance(), b.out_of_balance());
  for (std::size_t i = 0; i < a.model().bolts.size(); ++i)
    for (std::size_t link = 0; link < a.model().bolts[i].links.size(); ++link) {
      const LinkState& one = a.bolts().state(static_cast<int>(i), link);
      const LinkState& other = b.bolts().state(static_cast<int>(i), link);
      EXPECT_EQ(one.gap, other.gap);
      EXPECT_EQ(one.plastic, other.plastic);
      EXPECT_EQ(one.force, other.force);
    }
  for (std::size_t i = 0; i < a.contacts().interfaces.size(); ++i) {
    EXPECT_EQ(a.contacts().elements[i].law, b.contacts().elements[i].law);
    const InterfaceState one = a.interface_state(i);
    const InterfaceState other = b.interface_state(i);
    EXPECT_EQ(one.gap, other.gap);
    EXPECT_EQ(one.force, other.force);
    EXPECT_EQ(one.status, other.status);
    EXPECT_EQ(one.broken, other.broken);
    EXPECT_EQ(one.slip, other.slip);
  }
}

struct Case {
  const char* name;
  std::function<Model()> model;
  bool contacts_change;
};

class SnapshotCase : public testing::TestWithParam<Case> {};

TEST_P(SnapshotCase, GoesOnToTheLastBit) {
  Simulation whole(GetParam().model());
  run(whole, 50);
  const State at_50 = whole.state();
  const std::vector<std::byte> snapshot = save(whole);
  const Counters counters_at_50 = whole.counters();
  run(whole, 50);
  // Otherwise the scene would not show what a snapshot must hold.
  if (GetParam().contacts_change) {
    EXPECT_GT(counters_at_50.contact_state_changes, 0);
    EXPECT_GT(whole.counters().contact_state_changes, counters_at_50.contact_state_changes);
  }
  EXPECT_TRUE(whole.finished());

  Simulation resumed(GetParam().model());
  restore(resumed, at_50, snapshot);
  EXPECT_EQ(resumed.plan().describe(), whole.plan().describe());
  EXPECT_EQ(resumed.counters().steps, counters_at_50.steps);
  run(resumed, 50);
  expect_same(whole, resumed);
  EXPECT_TRUE(resumed.finished());
  const Counters a = whole.counters();
  const Counters b = resumed.counters();
  EXPECT_EQ(a.solves, b.solves);
  EXPECT_EQ(a.solver_iterations, b.solver_iterations);
  EXPECT_EQ(a.open_close_iterations, b.open_close_iterations);
  EXPECT_EQ(a.contact_state_changes, b.contact_state_changes);
  EXPECT_EQ(a.analyses + 1, b.analyses);
}

// The end of a run can be saved and read, e.g. for its last state.
TEST_P(SnapshotCase, OfAFinishedRun) {
  Simulation whole(GetParam().model());
  run(whole, 100);
  Simulation resumed(GetParam().model());
  restore(resumed, whole.state(), save(whole));
  EXPECT_TRUE(resumed.finished());
  expect_same(whole, resumed);
}

Model with_pcg(Model model) {
  for (Stage& stage : model.stages) stage.solver = SolverRequest::pcg;
  return model;
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, SnapshotCase,
    testing::Values(Case{"bonded", [] { return bar(InterfaceLaw::consistent); }, false},
                    Case{"cubic", [] { return bar(InterfaceLaw::cubic); }, false},
                    Case{"corrected", corrected_bar, false}, Case{"mesh_inertia", mesh_inertia, false},
                    Case{"pcg", [] { return with_pcg(bar(InterfaceLaw::classical)); }, false},
                    Case{"classical", [] { return shaken_stack(InterfaceLaw::classical, Kinematics::small); }, true},
                    Case{"consistent", [] { return shaken_stack(InterfaceLaw::consistent, Kinematics::small); }, true},
                    Case{"finite", [] { return shaken_stack(InterfaceLaw::consistent, Kinematics::finite); }, true},
                    Case{"in_situ", stressed_stack, true},
                    Case{"finite_pcg",
                         [] { return with_pcg(shaken_stack(InterfaceLaw::classical, Kinematics::finite)); }, true},
                    Case{"bolts", [] { return bolted_stack(Kinematics::finite); }, true},
                    Case{"bolts_small", [] { return bolted_stack(Kinematics::small); }, true},
                    Case{"hanging_block", hanging_block, false}, Case{"bolted_bar", bolted_bar, false},
                    Case{"two_stages", two_stages, true}, Case{"bar_first_finite", bar_first_finite, false},
                    Case{"bonded_finite", bonded_finite, false},
                    Case{"free_field", [] { return beside_a_column(Kinematics::small); }, true},
                    Case{"free_field_finite", [] { return beside_a_column(Kinematics::finite); }, true},
                    Case{"let_go", [] { return let_go(Kinematics::small); }, false},
                    Case{"let_go_finite", [] { return let_go(Kinematics::finite); }, false},
                    Case{"taken_away", [] { return taken_away(Kinematics::small); }, false},
                    Case{"taken_away_finite", [] { return taken_away(Kinematics::finite); }, false}),
    [](const auto& test) { return std::string(test.param.name); });

std::string refusal(Model model, const State& state, std::span<const std::byte> snapshot) {
  Simulation simulation(std::move(model));
  try {
    restore(simulation, state, snapshot);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Snapshot, RefusesWhatDoesNotFit) {
  const Model model = bar(InterfaceLaw::consistent);
  Simulation simulation(model);
  run(simulation, 50);
  const std::vector<std::byte> snapshot = save(simulation);
  const State& state = simulation.state();
  EXPECT_EQ(refusal(model, state, snapshot), "accepted");

  Model changed = model;
  changed.supports.clear();
  EXPECT_EQ(refusal(changed, state, snapshot),
            "checkpoint is of a scene with 1 supports, expected one with 0 supports as this scene has");
  changed = model;
  changed.stages[0].dt = 5e-5;
  EXPECT_EQ(refusal(changed, state, snapshot),
            "checkpoint is of steps of 0.0001 s, expected the 5e-05 s of stage \"run\"");
  changed = model;
  changed.stages[0].duration = 40e-4;
  EXPECT_EQ(refusal(changed, state, snapshot),
            "checkpoint is at step 50 of a stage, expected less than the 40 steps of stage \"run\"");

  EXPECT_NE(refusal(model, state, std::span(snapshot).first(snapshot.size() - 1)), "accepted");
  std::vector<std::byte> longer = snapshot;
  longer.push_back(std::byte{0});
  EXPECT_NE(refusal(model, state, longer), "accepted");
  EXPECT_NE(refusal(model, state, {}), "accepted");
}

// Contacts are looked at from time to time; a resumed run looks at the same times.
TEST(Snapshot, LeavesTheContactRangeAtTheSameStep) {
  Model model = bare_model(InterfaceLaw::classical, Kinematics::finite);
  model.blocks = {rectangle("floor", 0, 0, 3, 1), rectangle("stone", 1, 1.1, 1, 1)};
  model.blocks[1].initial_velocity = {0, -1};
  model.joints[0].bonded = true;  // other contacts are followed
  model.stages[0].dt = 1e-3;
  model.stages[0].duration = 1;
  finish_model(model);
  const auto step_of_end = [](Simulation& simulation) {
    Status status = Status::ok;
    while (status == Status::ok && !simulation.finished()) status = simulation.step();
    EXPECT_EQ(status, Status::left_contact_range);
    return simulation.state().step;
  };
  Simulation whole(model);
  run(whole, 50);
  Simulation resumed(model);
  restore(resumed, whole.state(), save(whole));
  EXPECT_EQ(step_of_end(resumed), step_of_end(whole));
}

TEST(Snapshot, DurationMayGrow) {
  Model model = bar(InterfaceLaw::consistent);
  Simulation first(model);
  run(first, 50);
  const State at_50 = first.state();
  const std::vector<std::byte> snapshot = save(first);
  model.stages[0].duration = 120e-4;
  Simulation longer(model);
  restore(longer, at_50, snapshot);
  run(longer, 70);
  EXPECT_TRUE(longer.finished());
}

}  // namespace
}  // namespace dda
