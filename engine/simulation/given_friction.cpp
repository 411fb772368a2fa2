#include "engine/simulation/given_friction.h"

#include <cstdint>

#include "engine/simulation/block_system.h"
#include "engine/simulation/settling_pace.h"
#include "engine/simulation/step_limits.h"

namespace dda {
namespace {

// Steps that take friction as given come in runs of so many: to try otherwise costs ten to forty passes in vain as long
// as much still moves, and a few more such steps cost less.
constexpr int steps_in_a_run = 5;

// Stages that settle by themselves are over by then, and go the way of the least motion: a slope near its limit gives
// way at a friction 0.1 % higher where steps take it as given from the first on. Counted for each part of the way of
// loads and motions: the first step of one moves blocks on a base that turns off the base by what first-order gaps
// miss, and friction given by contacts that carry nothing lets them slide down it.
constexpr int first_step_given = 20;

// Share of the first step of the stage. In a shorter one nothing moves that could go either way, nor does the stage
// come nearer to its end: rocks of hundreds of blocks took the twenty steps in vain.
constexpr double shortest_followed = 1.0 / 64;

// Share of dt: where parts may not be that short, friction would be too late to be believed.
constexpr double longest_part_given = 1.0 / 16;

// A step of no more passes had next to nothing to change, and ends the run.
constexpr std::int64_t passes_at_rest = 3;

bool may_be_over_soon(const BlockSystem& system) {
  const double first = first_step(system.model, system.stage(), system.contacts.can_change);
  return system.clock.parts.steps_of_part() < first_step_given && system.coefficients.dt > shortest_followed * first;
}

}  // namespace

void GivenFriction::begin_step(const BlockSystem& system) {
  if (system.clock.parts.steps_of_part() == 0) steps_left_ = 0;
}

bool GivenFriction::give(const BlockSystem& system) {
  const bool is_convex = system.stage().unlimited_strength;
  if (is_given() || !system.stage().paces_itself() || is_convex || may_be_over_soon(system)) return false;
  steps_left_ = steps_in_a_run;
  return true;
}

bool GivenFriction::give_to_shortest_part(const BlockSystem& system) {
  const bool is_short = system.coefficients.dt <= longest_part_given * system.stage().dt && is_shortest_part(system);
  if (is_given() || system.plan.is_static || !is_short) return false;
  steps_left_ = 1;
  return true;
}

void GivenFriction::settled(const BlockSystem& system) {
  was_given_ = is_given();
  if (!was_given_) return;
  steps_left_ = system.passes_of_step() <= passes_at_rest ? 0 : steps_left_ - 1;
}

}  // namespace dda
