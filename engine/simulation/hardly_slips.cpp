#include "engine/simulation/hardly_slips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "engine/simulation/bonded_joints.h"

namespace dda {
namespace {

// rad, where geometry is followed. A slender column that must fall, drawn by lot, leans by more in the step, and stays
// in an equilibrium that does not last: without inertia nothing tells it from others. What strain turns is below that.
constexpr double most_turn_at_once = 2e-3;

bool turns_far(int block, const Eigen::VectorXd& increment) {
  return std::abs(increment(6 * block + 2)) > most_turn_at_once;
}

// Only what leans on others can be in such an equilibrium; what hangs on bolts or is glued on turns by what these give.
bool leans(const InterfaceTrial& trial) {
  return (trial.broken[0] && trial.active(0) > 0) || (trial.broken[1] && trial.active(2) > 0);
}

bool some_block_turns_far(const InterfaceTrials& contacts, const Eigen::VectorXd& increment) {
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const InterfaceElement& element = contacts.element(k);
    if (leans(contacts[k]) && (turns_far(element.block_a, increment) || turns_far(element.block_b, increment)))
      return true;
  }
  return false;
}

// An end without friction slides, but its force is the same whichever way it went.
bool slips(const InterfaceSprings& springs, const InterfaceTrial& trial) {
  for (int end = 0; end < ends_of(springs); ++end) {
    const auto e = static_cast<std::size_t>(end);
    if (trial.broken[e] && trial.capacity[e] > 0 && trial.active(2 * end + 1) == 0) return true;
  }
  return false;
}

// A few slip wherever a load ends or next to nothing presses them together: of wedges around an opening a twentieth, of
// such with a friction of 0.1 a tenth. Where many do, as in random rock under its weight, the way matters.
constexpr double few = 0.15;

bool many_contacts_slip(const InterfaceTrials& contacts) {
  std::size_t slipping = 0;
  for (std::size_t k = 0; k < contacts.size(); ++k)
    if (slips(contacts.element(k), contacts[k])) ++slipping;
  return static_cast<double>(slipping) > few * static_cast<double>(contacts.size());
}

}  // namespace

bool hardly_slips(const BlockSystem& system, const ContactSolver& solved, const StepSolution& solution,
                  std::span<const int> bonded) {
  const auto breaks = [&](int joint) {
    const std::array<bool, 2> broken = ends_that_break(system, solved.increment(), static_cast<std::size_t>(joint));
    return broken[0] || broken[1];
  };
  if (system.plan.finite_kinematics && some_block_turns_far(solved.contacts(), solved.increment())) return false;
  if (solution.something_broke() || many_contacts_slip(solved.contacts())) return false;
  return !system.plan.contacts_judged || std::ranges::none_of(bonded, breaks);
}

}  // namespace dda
