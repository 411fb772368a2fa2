#include "engine/simulation/parts_of_stage.h"

#include <algorithm>

#include "engine/simulation/block_system.h"
#include "engine/simulation/equilibrium.h"
#include "engine/simulation/held_blocks.h"
#include "engine/simulation/prescribed_motion.h"
#include "engine/simulation/step_limits.h"

namespace dda {
namespace {

// Measured: for a block that slides on friction under a spring that is pulled, one whose bolt yields, and a tunnel that
// that is let go, the work is off by 15, 54 and 9 % in one part, by 15, 2.4 and 0.3 % in 8, by 0.3, 0.4 and 0.03 %
// in 32.
constexpr int parts_of_what_yields = 32;

// A share of the smallest block's size. Measured: of 40 arches by lot on a springer that goes out by 0.2 to 3 % of the
// span 17 end with another thrust than in 16 stages with parts of 0.01 (which miss no contact), 13 with 0.003, 3 with
// 0.001; none with interior passes and 0.001.
constexpr double most_motion_of_part = 0.001;

// Turns that can be foreseen, by more than round-off.
constexpr double most_turn_of_part = 0.999 * most_turn;

// What may be out of balance when loads go on to their next part, of the largest force: a thirtieth of a part of it.
constexpr double at_rest = 1e-3;

}  // namespace

LoadParts parts_of_stage(bool contacts_are_followed, BlockSystem& system) {
  if (!system.stage().paces_itself() || nothing_prescribed_changes_until(system.end_of_stage(), system)) return {};
  const StepPlan& plan = system.plan;
  int all = 1;
  if (plan.contacts_can_change || plan.reinforcement.linings_yield) all = parts_of_what_yields;
  if (contacts_are_followed && plan.finite_kinematics)
    all = std::max(all, steps_of_motion(system.model, system.clock.start, system.end_of_stage(), most_motion_of_part,
                                        most_turn_of_part));
  LoadParts parts;
  parts.begin(all);
  return parts;
}

void go_on_with_loads(double in_situ_force, bool steps_are_long, BlockSystem& system) {
  LoadParts& parts = system.clock.parts;
  if (parts.all == 1) return parts.follow(true, 0);
  parts.follow(steps_are_long && out_of_balance(system, in_situ_force) <= at_rest, largest_motion(system));
}

bool goes_further_than_the_last_part(const BlockSystem& system) {
  const LoadParts& parts = system.clock.parts;
  return parts.waits && parts.gone > 0 && largest_motion(system) > parts.moved;
}

}  // namespace dda
