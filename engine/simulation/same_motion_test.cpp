// Exactly the state of a step decides: dry rock moves the same whether its blocks and corners are numbered this way or
// that, and turned, mirrored, moved or larger. At every node corners of four blocks meet, or of three, exactly.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "engine/simulation/block_system.h"
#include "engine/simulation/seen_rock.h"

namespace dda {
namespace {

constexpr int rocks_of_a_kind = 5;  // 30 in all

constexpr int most_steps = 20;  // rock that settles does so in fewer; of the rest the way is compared

// The share of the motion by which runs may differ. Balance is found to 1e-10 of the largest contact force, ten to a
// hundred times a block's weight. Before, rocks whose numbering was changed were nearly all off by 1e-4 to 5e-2.
constexpr double same = 1e-6;

// Where friction has several answers all views find the same one, as nothing on the way to it is decided by round-off
// (ADR 97).
constexpr int rocks_with_several_answers = 0;

std::vector<int> reversed(std::size_t blocks) {
  std::vector<int> order(blocks);
  std::iota(order.rbegin(), order.rend(), 0);
  return order;
}

std::vector<int> shuffled(std::size_t blocks) {
  std::vector<int> order = reversed(blocks);
  SeededNumbers random(7);
  for (std::size_t i = blocks; i > 1; --i)
    std::swap(order[i - 1], order[static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1))]);
  return order;
}

Mat2 mirror() {
  Mat2 turn = Mat2::Identity();
  turn(0, 0) = -1;
  return turn;
}

Mat2 quarter_turn() {
  Mat2 turn;
  turn << 0, -1, 1, 0;
  return turn;
}

// Where a run has come to, and whether it says that others may come elsewhere: friction leaves the answer open (ADR
// 46), or nothing holds a block.
struct Outcome {
  std::optional<std::vector<Vec3>> motion;  // none where a step did not come to an end
  bool is_open = false;
};

Outcome outcome_of(const Model& drawn, const View& view, int most) {
  Simulation simulation = simulation_of(seen(drawn, view));
  Outcome outcome;
  Status status = Status::ok;
  for (int step = 0; step < most && !simulation.finished() && status == Status::ok; ++step) status = simulation.step();
  if (status == Status::ok) outcome.motion = motion_of(simulation, view);
  outcome.is_open = simulation.system().audit.unsettled.count > 0 || !simulation.results().loose.empty();
  return outcome;
}

// The share of the motion by which two runs differ; 1 where one of them came to no end.
double apart(const Outcome& one, const Outcome& other) {
  if (!one.motion && !other.motion) return 0;  // some block falls out of the rock
  return one.motion && other.motion ? difference(*one.motion, *other.motion) : 1;
}

constexpr double full_turn = 2 * std::numbers::pi;

View seen_of(const View& view, std::size_t blocks, std::uint64_t rock) {
  View own = view;
  if (view.name == "turned by lot") own.turn = rotation(SeededNumbers(rock).number(0, full_turn));
  if (view.name == "reversed") own.order = reversed(blocks);
  if (view.name == "shuffled") own.order = shuffled(blocks);
  return own;
}

struct Seen {
  View view;
  double tolerance = same;  // share of the motion
  int allowed = rocks_with_several_answers;
  int differ = 0, unsaid = 0;
  std::string names = {};
};

void compare(const Outcome& expected, const Outcome& actual, const std::string& name, Seen& each) {
  const double off = apart(expected, actual);
  if (off < each.tolerance) return;
  ++each.differ;
  each.names += fmt::format("{}: {:.1e}; ", name, off);
  if (!expected.is_open && !actual.is_open) ++each.unsaid;
}

// In every view at most as many rocks end elsewhere as are allowed, and all of these say that they may.
void expect_same_motion(const Stage& stage, std::vector<Seen> all) {
  for (int kind = 0; kind < cut_kinds; ++kind)
    for (std::uint64_t seed = 1; seed <= rocks_of_a_kind; ++seed) {
      Model rock = dry_rock(static_cast<CutKind>(kind), seed);
      rock.stages = {stage};
      const Outcome expected = outcome_of(rock, {}, most_steps);
      for (Seen& each : all) {
        const View view = seen_of(each.view, rock.blocks.size(), 10 * seed + static_cast<std::uint64_t>(kind));
        compare(expected, outcome_of(rock, view, most_steps), fmt::format("kind {}, seed {}", kind, seed), each);
      }
    }
  for (const Seen& each : all) {
    EXPECT_LE(each.differ, each.allowed) << each.view.name << ": " << each.names;
    EXPECT_EQ(each.unsaid, 0) << each.view.name << ": " << each.names;
  }
}

Stage motion() { return stage_of(generalized_alpha_integrator(0), 1e-3, 20, Kinematics::finite); }

Stage settling() { return settling_stage(1e-9); }

std::vector<Seen> other_numberings() {
  std::vector<Seen> views(3);
  views[0].view.name = "reversed";
  views[1].view.name = "shuffled";
  views[2].view = {.name = "rings from another corner", .first_corner = 1};
  return views;
}

std::vector<Seen> other_places() {
  return {{.view = {.name = "mirrored", .turn = mirror()}},
          {.view = {.name = "a quarter turn", .turn = quarter_turn()}},
          {.view = {.name = "1000 times larger", .scale = 1000}},
          {.view = {.name = "1000 times smaller", .scale = 1e-3}}};
}

TEST(SameMotion, HoweverBlocksAndCornersAreNumbered) { expect_same_motion(motion(), other_numberings()); }

TEST(SameMotion, TurnedMirroredMovedOrLarger) {
  std::vector<Seen> views = other_places();
  views.push_back({.view = {.name = "turned", .turn = rotation(0.7)}});
  views.push_back({.view = {.name = "turned by lot"}});
  views.push_back({.view = {.name = "1000 sizes away", .shift = {4e3, -4e3}}});
  expect_same_motion(motion(), views);
}

// Rock that was drawn in coordinates of mines, and the same at the origin: no corner is rounded on the way there.
TEST(SameMotion, InCoordinatesOfMines) {
  for (int kind = 0; kind < cut_kinds; ++kind)
    for (std::uint64_t seed = 1; seed <= rocks_of_a_kind; ++seed) {
      Model drawn = dry_rock(static_cast<CutKind>(kind), seed);
      drawn.stages = {motion()};
      for (const double far : {1e5, 1e6, 1e7}) {
        const Model there = seen(drawn, {.shift = {far, -far}});
        const Outcome here = outcome_of(there, {.shift = {-far, far}}, most_steps);
        EXPECT_LT(apart(here, outcome_of(there, {}, most_steps)), same) << kind << ", seed " << seed << ", " << far;
      }
    }
}

// Lengths are 4^7 times as large, times 2^7: but for what is not a product or a root of them, as sines, all numbers are
// the same to the last bit in other units, and so are the passes in which steps come to their end.
TEST(SameMotion, TakesAsManyPassesOnAnyScale) {
  int differ = 0;
  for (int kind = 0; kind < cut_kinds; ++kind)
    for (std::uint64_t seed = 1; seed <= rocks_of_a_kind; ++seed) {
      Model rock = dry_rock(static_cast<CutKind>(kind), seed);
      rock.stages = {motion()};
      const auto passes_of = [&rock](double scale) {
        Simulation simulation = simulation_of(seen(rock, {.scale = scale}));
        for (int step = 0; step < most_steps && simulation.step() == Status::ok; ++step) continue;
        return simulation.counters().open_close_iterations;
      };
      if (passes_of(1) != passes_of(16384)) ++differ;
    }
  EXPECT_LE(differ, rocks_with_several_answers);
}

TEST(SameMotion, SettlesTheSameHoweverNumbered) { expect_same_motion(settling(), other_numberings()); }

// The largest force that acts is the weight of the held floor here: its length counts, and not its larger component.
TEST(SameMotion, IsAsFarOutOfBalanceTurned) {
  for (int kind = 0; kind < cut_kinds; ++kind) {
    Model rock = dry_rock(static_cast<CutKind>(kind), 1);
    rock.stages = {settling()};
    const double as_drawn = simulation_of(seen(rock, {})).out_of_balance();
    const double turned = simulation_of(seen(rock, {.name = "turned", .turn = rotation(0.7)})).out_of_balance();
    EXPECT_NEAR(turned, as_drawn, 1e-9 * as_drawn) << kind;  // round-off of coordinates
  }
}

// A block that falls out of one rock meets others there that it misses elsewhere. (Before nothing was decided by
// round-off three rocks came to other answers where they were turned: ADR 59, 97.)
constexpr int rocks_that_fall_elsewhere = 1;

TEST(SameMotion, SettlesTheSameTurnedMirroredOrLarger) {
  std::vector<Seen> views = other_places();
  views.push_back({.view = {.name = "turned", .turn = rotation(0.7)}});
  views.push_back({.view = {.name = "turned by half of that", .turn = rotation(0.35)}});
  views.push_back({.view = {.name = "turned by lot"}});
  for (Seen& each : views) each.allowed = rocks_that_fall_elsewhere;
  expect_same_motion(settling(), views);
}

// Newton's steps are solved for to many digits where rock settles (ADR 98), and it is then not the linear solver that
// chooses among the answers of friction: before, one that factors and one that iterates went apart in 22 of these
// rocks. Where blocks fall by half a metre in the step that is tried first, these digits are not enough.
constexpr int rocks_that_settle_otherwise = 3;

TEST(SameMotion, SettlesTheSameWithAnotherSolver) {
  Seen iterating{.view = {.name = "pcg"}, .allowed = rocks_that_settle_otherwise};
  for (int kind = 0; kind < cut_kinds; ++kind)
    for (std::uint64_t seed = 1; seed <= 2 * rocks_of_a_kind; ++seed) {
      Model rock = dry_rock(static_cast<CutKind>(kind), seed);
      rock.stages = {settling()};
      const auto settled_with = [&rock](SolverRequest solver) {
        rock.stages[0].solver = solver;
        return outcome_of(rock, {}, most_steps);
      };
      const Outcome by_factors = settled_with(SolverRequest::cholesky);
      compare(by_factors, settled_with(SolverRequest::pcg), fmt::format("kind {}, seed {}", kind, seed), iterating);
    }
  EXPECT_LE(iterating.differ, iterating.allowed) << iterating.names;
  EXPECT_EQ(iterating.unsaid, 0) << iterating.names;
}

// ---- Rock under stress, in which blocks are taken out, joints slide and break.

constexpr int first_steps = 10;  // of what moves after the excavation

Model excavated_rock(std::uint64_t seed) {
  Model rock = stressed_rock(seed);
  const std::vector<int> removed = rock.stages[1].removal.blocks;
  Stage settle = settling();
  settle.on_unbalanced = OnUnbalanced::carry_on;
  Stage move = stage_of(generalized_alpha_integrator(0), 2e-4, first_steps, Kinematics::finite);
  rock.stages = {settle, settle, move};
  rock.stages[1].removal.blocks = removed;
  return rock;
}

std::vector<View> views_of(const Model& rock, std::uint64_t seed) {
  const std::vector<View> named = {{.name = "turned by lot"},
                                   {.name = "mirrored", .turn = mirror()},
                                   {.name = "shuffled"},
                                   {.name = "rings from another corner", .first_corner = 1},
                                   {.name = "moved", .shift = {130, -70}},
                                   {.name = "1000 times larger", .scale = 1000},
                                   {.name = "1000 times smaller", .scale = 1e-3}};
  std::vector<View> views;
  for (const View& each : named) views.push_back(seen_of(each, rock.blocks.size(), seed));
  return views;
}

// Counts in how many rocks the answer is said to be open.
int expect_same_or_said_open(std::uint64_t first, std::uint64_t rocks) {
  constexpr int all_steps = 1000;
  int open = 0;
  for (std::uint64_t seed = first; seed < first + rocks; ++seed) {
    const Model rock = excavated_rock(seed);
    const Outcome drawn = outcome_of(rock, {}, all_steps);
    bool is_open = drawn.is_open;
    for (const View& view : views_of(rock, seed)) {
      const Outcome other = outcome_of(rock, view, all_steps);
      is_open = is_open || other.is_open;
      if (drawn.is_open || other.is_open) continue;
      EXPECT_LT(apart(drawn, other), same) << "seed " << seed << ", " << view.name;
    }
    open += is_open ? 1 : 0;
  }
  return open;
}

// Among them are the two of the first hundred that went another way while round-off chose the contacts of corners drawn
// in one point: 155, larger, by 2e-5, and 199, mirrored, by 6e-3.
TEST(SameMotion, ExcavationsComeToTheSameOrSayThatTheAnswerIsOpen) {
  EXPECT_LE(expect_same_or_said_open(151, 6) + expect_same_or_said_open(195, 6), 1);
}

// Nothing is rounded on the way, so that even those whose answer is open come to the same one (before by up to 2e-3 to
// another, now 2e-9).
TEST(SameMotion, ExcavationsInCoordinatesOfMines) {
  constexpr int all_steps = 1000;
  for (std::uint64_t seed = 100; seed < 140; ++seed) {
    const Model there = seen(excavated_rock(seed), {.shift = {1e6, -2e6}});
    const Outcome here = outcome_of(there, {.shift = {-1e6, 2e6}}, all_steps);
    EXPECT_LT(apart(here, outcome_of(there, {}, all_steps)), same) << "seed " << seed;
  }
}

TEST(SameMotion, DISABLED_HundredsOfExcavations) { EXPECT_LE(expect_same_or_said_open(100, 300), 55); }

}  // namespace
}  // namespace dda
