#include "engine/simulation/snapshot.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <memory>
#include <string>

#include "engine/core/error.h"
#include "engine/simulation/run_so_far.h"
#include "engine/simulation/snapshot_models.h"

namespace dda {
namespace {

using namespace snapshots;

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
                    Case{"corrected", corrected_bar, false}, Case{"corrected_mesh", corrected_mesh, false},
                    Case{"pcg", [] { return with_pcg(bar(InterfaceLaw::classical)); }, false},
                    Case{"classical", [] { return shaken_stack(InterfaceLaw::classical, Kinematics::small); }, true},
                    Case{"consistent", [] { return shaken_stack(InterfaceLaw::consistent, Kinematics::small); }, true},
                    Case{"finite", [] { return shaken_stack(InterfaceLaw::consistent, Kinematics::finite); }, true},
                    Case{"projected", [] { return shaken_stack(InterfaceLaw::projected, Kinematics::small); }, true},
                    Case{"in_situ", stressed_stack, true},
                    Case{"finite_pcg",
                         [] { return with_pcg(shaken_stack(InterfaceLaw::classical, Kinematics::finite)); }, true},
                    Case{"bolts", [] { return bolted_stack(Kinematics::finite); }, true},
                    Case{"bolts_small", [] { return bolted_stack(Kinematics::small); }, true},
                    Case{"hanging_block", hanging_block, false}, Case{"bolted_bar", bolted_bar, false},
                    Case{"two_stages", two_stages, true}, Case{"slides_after_sticking", slides_after_sticking, false},
                    Case{"bar_first_finite", bar_first_finite, false}, Case{"bonded_finite", bonded_finite, false},
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

// A stone has sunk on to a floor in steps that moved less and less, so that the next one, which throws it, looks for no
// contacts before it is solved: whether it went too far for those it has is told by where the last search has left it.
TEST(Snapshot, KnowsWhereTheLastSearchHasLeftTheBlocks) {
  Model model = bare_model(InterfaceLaw::classical, Kinematics::finite);
  model.blocks = {rectangle("floor", 0, 0, 3, 1), rectangle("stone", 1, 1.3, 1, 1)};
  model.held_blocks = {HeldBlock{}};
  model.gravity = {0, -9.81};
  model.point_loads = {{1, {1.5, 1.8}, {0, 4e8}, PiecewiseLinear{{0, 1e-9}, {0, 1}}}};
  Stage settle;
  settle.name = "settle";
  settle.integrator = static_integrator();
  settle.equilibrium = 1e-9;
  settle.dt = 0;
  settle.kinematics = Kinematics::finite;
  model.stages.front().dt = 1e-3;
  model.stages.front().duration = 0.01;
  model.stages.insert(model.stages.begin(), settle);
  finish_model(model);
  Simulation whole(model);
  while (stages_done(whole) == 0) ASSERT_EQ(whole.step(), Status::ok) << whole.message();
  ASSERT_LT(whole.state().displacement[1].y(), -0.29);
  Simulation resumed(model);
  restore(resumed, whole.state(), save(whole));
  ASSERT_EQ(whole.step(), Status::ok) << whole.message();
  ASSERT_EQ(resumed.step(), Status::ok);
  EXPECT_GT(whole.state().displacement[1].y(), -0.28);  // beyond the 2 % of its size that contacts are looked for
  expect_same(whole, resumed);
  EXPECT_EQ(whole.counters().contact_searches, resumed.counters().contact_searches);
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
