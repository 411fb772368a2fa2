#include "engine/simulation/step_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/contact/contact_search.h"
#include "engine/simulation/carried_motion.h"
#include "engine/simulation/relative_size.h"
#include "engine/simulation/settling_drag.h"
#include "engine/simulation/step.h"

namespace dda {
namespace {

// In static stages a larger turn is put right by the steps that follow; and a small block that tumbles faster than the
// shortest parts of a step resolve does not stop the others: what it meets forgives it the rest (moving_contacts).
constexpr double most_turn_in_static_steps = 0.05;
constexpr double most_turn_in_shortest_steps = 0.3;

double most_turn_now(const BlockSystem& system) {
  if (system.plan.is_static) return most_turn_in_static_steps;
  return is_shortest_part(system) ? most_turn_in_shortest_steps : most_turn;
}

// Below this share of the area of most blocks a block is a splinter.
constexpr double splinter_share = 1e-5;

// What weighs nothing ends nobody's run: in the shortest parts of a step a splinter may turn so far that its gaps are
// off by half of its size, which is nothing to what it meets.
constexpr double most_turn_of_splinters = 1;

// And of one below this share it is said that the rock would do without it.
constexpr double sliver_share = 1e-4;

// What tumbles like a small block in the shortest steps does so in steps of any length when it is a splinter: rock of
// hundreds of blocks is not stepped 64 times as often for what weighs nothing. Between slivers and splinters the room
// to turn grows with how little a block is, by equal factors. (A slope of 784 blocks had 14,400 passes in 115 steps for
// one block of 0.1 mm that tumbled, 3e-6 of the others' area, and has 3,900.)
double most_turn_of(const BlockSystem& system, double area, double of_most, double most) {
  const double of_splinters = is_shortest_part(system) ? most_turn_of_splinters : most_turn_in_shortest_steps;
  const double smallness = std::log(sliver_share * of_most / area) / std::log(sliver_share / splinter_share);
  return most * std::pow(of_splinters / most, std::clamp(smallness, 0.0, 1.0));
}

std::string_view remedy_of_unsettled(const Stage& stage) {
  if (stage.paces_itself()) return R"(no step is short enough; "strength": "unlimited" lets them stick)";
  if (stage.integrator.is_static) return "leave out dt, and the stage finds its own steps";
  return "take another dt or a static stage first";
}

double largest_motion(const BlockTerms& terms, const Eigen::VectorXd& increments) {
  double largest = 0;
  for (std::size_t i = 0; i < terms.area.size(); ++i) {
    const Vec6 own = increments.segment<6>(static_cast<Eigen::Index>(6 * i));
    largest = std::max(largest, motion_share(own, terms.area[i]));
  }
  return largest;
}

// By what `motion_of` says of each block.
template <typename Motion>
std::string turn_problem(const BlockSystem& system, const Motion& motion_of) {
  const double most = most_turn_now(system);
  std::vector<double> room;  // stays empty where nothing turns far
  for (std::size_t i = 0; i < system.terms.area.size(); ++i) {
    const double turn = turn_or_strain(motion_of(i));
    if (turn <= most) continue;
    const double area = system.terms.area[i];
    const double of_most = area_of_most(system.terms, system.held, room);
    const double own_most = most_turn_of(system, area, of_most, most);
    if (turn > own_most)
      return fmt::format(
          "block \"{}\" would turn or be strained by {:.2g} in a step of {:.3g} s, and first-order gaps hold to {:g}: "
          "take a smaller dt{}",
          system.model.blocks[i].name, turn, system.coefficients.dt, own_most,
          area < sliver_share * of_most ? ", or leave out what is so much smaller than the others" : "");
  }
  return "";
}

}  // namespace

double geometry_tolerance(const BlockSystem& system) {
  constexpr double most = 1e-6;
  constexpr double of_balance = 1e-3;  // bolts may be that much shorter than blocks, and turn by so much more
  constexpr std::int64_t few_steps = 20;
  const Stage& stage = system.stage();
  const bool is_restless = stage.integrator.is_static && stage.equilibrium > 0 && system.clock.step >= few_steps;
  return is_restless ? std::min(of_balance * stage.equilibrium, most) : most;
}

bool goes_far_for_its_geometry(const BlockSystem& system) {
  constexpr double far = 1e-5;
  return system.plan.finite_kinematics && largest_motion(system) > far;
}

bool is_shortest_part(const BlockSystem& system) {
  const Stage& stage = system.stage();
  return system.coefficients.dt <= std::ldexp(stage.dt_of(system.clock.step), -stage.limits.step_reductions);
}

int most_passes(const Stage& stage) {
  constexpr int most_when_paced = 60;
  const int most = stage.limits.open_close_iterations;
  return stage.paces_itself() ? std::min(most, most_when_paced) : most;
}

// A stage that finds its own steps rather takes shorter ones. But the parts of one that moves something wait for long
// steps: in short ones rock falls after what goes away under it, and never comes to lie on it again.
bool goes_from_inside(const BlockSystem& system) {
  return !system.stage().paces_itself() || system.clock.parts.all > 1;
}

double largest_motion(const BlockSystem& system) { return largest_motion(system.terms, system.increment); }

bool hold_back_what_goes_far(BlockSystem& system) {
  const auto hold_back = [&system](const Eigen::VectorXd& increments) {
    return largest_motion(system.terms, increments) > ContactSearch::reach / 2 &&
           system.drag.raise(system.terms, system.held, increments);
  };
  return takes_blocks_along(system) ? hold_back(own_increments(system)) : hold_back(system.increment);
}

bool finds_loose_blocks(BlockSystem& system) {
  SettlingDrag& drag = system.drag;
  return takes_blocks_along(system) ? drag.follow(system.terms, own_increments(system))
                                    : drag.follow(system.terms, system.increment);
}

double largest_motion_within(const BlockSystem& system, double time) {
  double largest = 0;
  for (std::size_t i = 0; i < system.terms.area.size(); ++i)
    largest = std::max(largest, motion_share(system.state.velocity[i], system.terms.area[i]));
  return time * largest;
}

std::string turn_problem(const BlockSystem& system) {
  return turn_problem(
      system, [&](std::size_t i) -> Vec6 { return system.increment.segment<6>(static_cast<Eigen::Index>(6 * i)); });
}

std::string foreseen_turn_problem(const BlockSystem& system) {
  if (system.plan.is_static) return "";  // nothing goes on there
  return turn_problem(system, [&](std::size_t i) -> Vec6 { return system.coefficients.dt * system.state.velocity[i]; });
}

void note_unsettled(const StepSolution& solution, BlockSystem& s) {
  const int place = solution.restless_contact;
  const Interface* restless = place < 0 ? nullptr : &s.contacts.interfaces[static_cast<std::size_t>(place)];
  s.audit.unsettled.note(s.state.step, s.state.time, restless ? restless->block_a : -1,
                         restless ? restless->block_b : -1);
}

std::string unsettled_message(const StepSolution& solution, const BlockSystem& system) {
  if (solution.restless_contact < 0) return sentence(solution.failure);
  const InterfaceElement& worst = system.contacts.elements[static_cast<std::size_t>(solution.restless_contact)];
  const auto name = [&](int block) { return system.model.blocks[static_cast<std::size_t>(block)].name; };
  return fmt::format(
      "the open-close iteration did not settle in {} passes; blocks \"{}\" and \"{}\" still change most, by {:.2g} N: "
      "{}",
      most_passes(system.stage()), name(worst.block_a), name(worst.block_b), solution.restless_force,
      remedy_of_unsettled(system.stage()));
}

}  // namespace dda
