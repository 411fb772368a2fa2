#include "verification/cases/wall_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "engine/builder/generators.h"
#include "verification/cases/contact_rig.h"
#include "verification/exact/brick_wall.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

constexpr double density = 2600;
constexpr double young = 5e9;
constexpr double spring_over_young = 10;

// `side` rows of as many bricks 1 x 0.5 m on a held base, which is the last block; friction 0.6 as in the walls that
// other programs were measured on.
dda::Model brick_wall(int side, double poisson) {
  dda::Model model;
  model.title = fmt::format("dry wall of {} x {} bricks", side, side);
  model.materials = {{"brick", density, young, poisson, dda::PlaneState::stress}};
  dda::JointMaterial joint = dry_joint(std::atan(0.6));
  joint.spring_over_young = spring_over_young;
  model.joints = {joint};
  model.gravity = {0, -standard_gravity};
  dda::append_grid(model, {.columns = side,
                           .rows = side,
                           .block_width = 1,
                           .block_height = 0.5,
                           .pattern = dda::GridPattern::running_bond});
  model.held_blocks.emplace_back().block = add_box(model, -1, -1, side + 1, 0);
  return model;
}

exact::BrickWall by_hand(int side) {
  return {side, 1, 0.5, density * standard_gravity, young, spring_over_young * young};
}

// Mean over the top row, whose centroids are the highest.
double settlement_of(const dda::Simulation& simulation, double height) {
  double sum = 0;
  int bricks = 0;
  for (std::size_t i = 0; i < simulation.model().blocks.size(); ++i) {
    if (simulation.model().blocks[i].moments.centroid.y() < height - 0.5) continue;
    sum -= simulation.state().displacement[i](1);
    ++bricks;
  }
  return sum / bricks;
}

double farthest_apart(const dda::State& one, const dda::State& other) {
  double distance = 0;
  for (std::size_t i = 0; i < one.displacement.size(); ++i)
    distance = std::max(distance, (one.displacement[i] - other.displacement[i]).head<2>().norm());
  return distance;
}

constexpr double time_to_settle = 11;  // s, of the static stages

// Weight comes on in static steps while joints stick; then friction holds; then the wall is left alone.
dda::Model settling_wall(int side, double poisson, double rest) {
  dda::Model model = brick_wall(side, poisson);
  dda::Stage weight = moving_stage(dda::static_integrator(), 0.1, 1);
  weight.unlimited_strength = true;
  dda::Stage friction = moving_stage(dda::static_integrator(), 0.1, time_to_settle - 1);
  friction.equilibrium = 1e-9;
  dda::Stage alone = moving_stage(dda::thesis_integrator(), 1e-3, rest);
  model.stages = {weight, friction, alone};
  for (dda::Stage& stage : model.stages) stage.solver = dda::SolverRequest::automatic;
  return model;
}

// Without lateral strain: the ground does not spread, and holds bricks that do (Poisson ratio 0.2) up by 2 %.
Outcome wall_at_rest(int side, double rest) {
  Outcome outcome;
  WatchedRun run(settling_wall(side, 0, rest));
  run.run_to(time_to_settle);
  const dda::State settled = run.state();
  const double expected = exact::settlement(by_hand(side));
  const double got = settlement_of(run.simulation(), 0.5 * side);
  outcome.assertions.push_back(
      expect(fmt::format("settlement of the top of {} rows", side), "m")
          .is(got)
          .against(expected, "weights by hand on springs and bricks in a row (exact/brick_wall)")
          .within(1e-4, "springs in series with bricks, to first order in strains of up to 2e-4"));
  run.run_to_end();
  const double drift = farthest_apart(run.state(), settled);
  outcome.assertions.push_back(expect(fmt::format("drift in {:g} s at rest (m)", rest), "m")
                                   .is(drift)
                                   .against(0, "rest")
                                   .absolutely()
                                   .within(1e-9, "equilibrium was asked for to 1e-9 of the weight"));
  outcome.assertions.push_back(energy_assertion("a wall", run.energy_residual()));
  outcome.counters += run.simulation().counters();
  return outcome;
}

Outcome long_rest() {
  constexpr int steps = 100000;
  Outcome outcome;
  WatchedRun run(settling_wall(10, 0.2, 1e-3 * steps));
  run.run_to(time_to_settle);
  const dda::State settled = run.state();
  run.run_to_end();
  const double drift = farthest_apart(run.state(), settled) / 10;
  outcome.assertions.push_back(expect("drift of a wall in 1e5 steps at rest, over its width", "-")
                                   .is(drift)
                                   .against(0, "rest")
                                   .absolutely()
                                   .within(1e-9, "target 1e-6; equilibrium was asked for to 1e-9 of the weight"));
  outcome.counters += run.simulation().counters();
  return outcome;
}

// Gravity switched on at once, as no one should: thousands of contacts open, close and slide in every step.
dda::State fallen_wall(dda::SolverRequest solver, Outcome& outcome) {
  dda::Model model = brick_wall(10, 0.2);
  model.stages = {moving_stage(dda::thesis_integrator(), 1e-3, 0.2)};
  model.stages[0].solver = solver;
  WatchedRun run(std::move(model));
  run.run_to_end();
  outcome.assertions.push_back(energy_assertion("a wall that gravity is switched on for", run.energy_residual()));
  outcome.counters += run.simulation().counters();
  return run.state();
}

Outcome same_with_every_solver() {
  Outcome outcome;
  const dda::State direct = fallen_wall(dda::SolverRequest::cholesky, outcome);
  const dda::State iterative = fallen_wall(dda::SolverRequest::pcg, outcome);
  const double apart = farthest_apart(direct, iterative);
  outcome.assertions.push_back(
      expect("centroids of 10 x 10 bricks, PCG against Cholesky, 0.2 s after gravity came on (m)", "m")
          .is(apart)
          .against(0, "one model, one result")
          .absolutely()
          .within(1e-10, "forces balance to 1e-11 in every step; bricks have moved by 1e-4 m"));
  return outcome;
}

}  // namespace

std::vector<Case> wall_cases() {
  return {{"wall-10",
           "Dry wall of 10 x 10 bricks: settlement, rest",
           {8, 26},
           CaseLabel::fast,
           [] { return wall_at_rest(10, 1); }},
          {"wall-40",
           "Dry wall of 40 x 40 bricks: settlement, rest",
           {8, 26},
           CaseLabel::slow,
           [] { return wall_at_rest(40, 0.1); }},
          {"wall-80",
           "Dry wall of 80 x 80 bricks: settlement, rest",
           {8, 26},
           CaseLabel::slow,
           [] { return wall_at_rest(80, 0.02); }},
          {"wall-long-rest", "Dry wall of 10 x 10 bricks: 100,000 steps at rest", {8}, CaseLabel::slow, long_rest},
          {"wall-solvers", "A falling wall with either solver", {8}, CaseLabel::fast, same_with_every_solver}};
}

}  // namespace verify
