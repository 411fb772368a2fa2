// Bolts and linings that are taken out: the rock goes where it would be without them, at once, slowly or in part.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/simulation/lining_models.h"
#include "engine/simulation/memory_test_support.h"
#include "engine/simulation/snapshot_models.h"

namespace dda {
namespace {

constexpr int steps = 12;  // of each of two stages

// The first stage twice, the supports going between.
Model in_two_stages(Model model, const Kinematics kinematics) {
  model.stages.resize(1);
  model.stages[0] = stage_of(static_integrator(), 1, steps, kinematics);
  model.stages.push_back(model.stages[0]);
  model.stages[0].name = "held";
  for (Bolt& bolt : model.bolts) bolt.withdrawal.last_stage = 0;
  for (Lining& lining : model.linings) lining.withdrawal.last_stage = 0;
  return model;
}

void let_fade(const TimeFunction& course, Model& model) {
  for (Bolt& bolt : model.bolts) bolt.withdrawal.relaxation = course;
  for (Lining& lining : model.linings) lining.withdrawal.relaxation = course;
}

// A bar held on the left and pulled on the right, tied to a wall.
Model tied_bar(Kinematics kinematics) {
  Model model;
  model.materials = {rock()};
  model.blocks = {rectangle("wall", -2, 0, 1, 1), rectangle("bar", 0, 0, 10, 1)};
  model.held_blocks = {HeldBlock{}};
  model.supports = {{1, {0, 0}, true, false, 5e10, Vec2::Zero(), {}},
                    {1, {0, 1}, true, false, 5e10, Vec2::Zero(), {}},
                    {1, {5, 0.5}, false, true, 1e9, Vec2::Zero(), {}}};
  model.edge_loads = {{1, {10, 0}, {10, 1}, {4e5, 0}, Constant{}}};
  Bolt bolt;
  bolt.name = "bolt";
  bolt.links = {{0, 1, {-1.5, 0.5}, {8, 0.5}, 3e8, 0}};
  bolt.pretension = 2e4;
  model.bolts = {bolt};
  return in_two_stages(std::move(model), kinematics);
}

Model lined_ring(Kinematics kinematics) {
  LinedHole hole;
  hole.sectors = 16;
  return in_two_stages(lined_hole(hole, bond(InterfaceLaw::consistent)), kinematics);
}

double largest_difference(const State& a, const State& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.displacement.size(); ++i)
    most = std::max(most, (a.displacement[i] - b.displacement[i]).norm());
  return most;
}

State state_after(Model model, int count) {
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, count);
  EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
  EXPECT_EQ(count > steps ? simulation.energy().bolts + simulation.energy().linings : 0, 0);
  return simulation.state();
}

using Maker = std::function<Model(Kinematics)>;

// In small kinematics to what static steps leave; in finite to the strains, 1e-3.
void expect_let_go(const Maker& make) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    SCOPED_TRACE(kinematics == Kinematics::small ? "small" : "finite");
    const Model model = make(kinematics);
    const State held = state_after(model, steps);
    const State at_once = state_after(model, 2 * steps);
    Model never = model;
    never.bolts.clear();
    never.linings.clear();
    const State without = state_after(never, 2 * steps);
    const double moved = largest_difference(at_once, held);
    const bool small = kinematics == Kinematics::small;
    ASSERT_GT(moved, 1e-6);
    EXPECT_LT(largest_difference(at_once, without), (small ? 1e-6 : 3e-3) * moved);
    Model kept = model;
    let_fade(PiecewiseLinear{{0, 1}, {1, 1}}, kept);
    EXPECT_LT(largest_difference(state_after(kept, 2 * steps), held), (small ? 1e-6 : 1e-3) * moved);
    Model half = model;
    let_fade(PiecewiseLinear{{0, 3}, {1, 0.5}}, half);
    State middle = held;
    for (std::size_t i = 0; i < middle.displacement.size(); ++i)
      middle.displacement[i] = (held.displacement[i] + at_once.displacement[i]) / 2;
    EXPECT_LT(largest_difference(state_after(half, 2 * steps), middle), (small ? 1e-6 : 3e-3) * moved);
    Model slowly = model;
    let_fade(PiecewiseLinear{{0, 5}, {1, 0}}, slowly);
    EXPECT_LT(largest_difference(state_after(slowly, 2 * steps), at_once), (small ? 1e-6 : 3e-3) * moved);
  }
}

TEST(Withdrawal, OfABoltLetsTheBarGo) { expect_let_go(tied_bar); }
TEST(Withdrawal, OfALiningLetsTheHoleGo) { expect_let_go(lined_ring); }

TEST(Withdrawal, GoesOnFromASnapshotToTheBit) {
  for (const Maker& make : {Maker(tied_bar), Maker(lined_ring)})
    for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite})
      for (const bool fades : {false, true}) {
        Model model = make(kinematics);
        if (fades) let_fade(PiecewiseLinear{{0, 5}, {1, 0}}, model);
        finish_model(model);
        Simulation whole(model);
        run(whole, 2 * steps);
        for (const int stop : {1, steps - 1, steps, steps + 1, steps + 7}) {
          Simulation first(model);
          run(first, stop);
          Simulation second(model);
          restore(second, first.state(), save(first));
          run(second, 2 * steps - stop);
          EXPECT_EQ(memory_of(second), memory_of(whole)) << stop;
        }
      }
}

TEST(Withdrawal, BeforeWhatIsPutInIsRefused) {
  Model model = tied_bar(Kinematics::small);
  model.bolts[0].first_stage = 1;
  EXPECT_THROW(finish_model(model), InputError);
  model = tied_bar(Kinematics::small);
  model.bolts[0].withdrawal.last_stage = 7;
  EXPECT_THROW(finish_model(model), InputError);
}

}  // namespace
}  // namespace dda
