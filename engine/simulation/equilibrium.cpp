#include "engine/simulation/equilibrium.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "engine/core/principal_stress.h"
#include "engine/simulation/block_system.h"
#include "engine/solve/largest_entry.h"

namespace dda {
namespace {

// Blocks may follow a prescribed motion until no force is left; what is smaller than this share of the largest force
// exchanged on the way counts as none. (All of it would be too much: a first step that is short has the lid of a press
// push blocks that do not give way yet.)
constexpr double share_remembered = 1e-3;

// No block's own weight and load count as a smaller share of the largest force that acts. With the balance of 1e-9 that
// is asked for by default a block is in it to a thousandth of its weight.
constexpr double least_share = 1e-6;

// Gaps are differences of coordinates, of which the last digit is 2e-16 of the diameter of the scene, or this share of
// the length that tells what touches. What holds blocks lighter than the force that it makes nobody can tell.
constexpr double round_off_of_places = 2e-7;

// In units of round-off, of the forces that would move rock as far as it has gone: contacts are stiffer than blocks.
constexpr double most_round_off = 1024;

// The largest of the entries of one block. Moments count as forces at the arm of its size, or balance would be asked
// for the more strictly the larger a scene.
double largest_of(const BlockSystem& system, const Eigen::VectorXd& forces, std::size_t block) {
  return largest_entry(forces, block, system.terms.area[block]);
}

// Not a number where an entry is none.
double largest_of_all(const BlockSystem& system, const Eigen::VectorXd& forces) {
  double largest = 0;
  for (std::size_t i = 0; i < system.terms.area.size(); ++i) largest = std::max(largest, largest_of(system, forces, i));
  return largest + 0 * forces.sum();
}

// The largest force of supports and bolts, N per m of thickness.
double largest_of_springs(const BlockSystem& system) {
  double largest = 0;
  for (const SupportElement& support : system.supports)
    largest = std::max(largest, (support.stiffness * support.gap).norm());
  for (const LinkElement& link : system.reinforcement.bolts.links())
    if (!link.carries_nothing()) largest = std::max(largest, link.state.force.cwiseAbs().maxCoeff());
  return largest;
}

// What stresses carry across the width of a block, and what holds the held, N per m of thickness.
double largest_in_rock(const BlockSystem& system) {
  double largest = 0;
  for (std::size_t i = 0; i < system.terms.area.size(); ++i)
    largest = std::max(largest, std::sqrt(system.terms.area[i]) * largest_stress(system.state.stress[i]));
  for (const int block : system.held.blocks)
    largest = std::max(largest, largest_of(system, system.forces.internal_old, static_cast<std::size_t>(block)));
  return largest;
}

// Something acts that is no load: a motion that is prescribed, or the pretension of a bolt.
bool acts_without_load(const BlockSystem& system) {
  const auto has_moved = [&](const HeldBlock& held) {
    return !system.state.displacement[static_cast<std::size_t>(held.block)].isZero(0);
  };
  const auto is_displaced = [](const SupportElement& support) { return !support.prescribed.isZero(0); };
  const auto is_tensioned = [&](const Bolt& bolt) {
    return bolt.pretension != 0 && bolt.first_stage <= static_cast<int>(system.clock.stage) &&
           !bolt.withdrawal.is_over_in(system.clock.stage);
  };
  return std::ranges::any_of(system.model.held_blocks, has_moved) ||
         std::ranges::any_of(system.supports, is_displaced) || std::ranges::any_of(system.model.bolts, is_tensioned);
}

double exchanged_now(const BlockSystem& system) {
  return std::max(largest_of_springs(system), largest_in_rock(system));
}

// Round-off in forces between blocks that have moved together, N per m of thickness.
double round_off_of_motion(const BlockSystem& system) {
  double largest = 0;
  for (std::size_t i = 0; i < system.terms.area.size(); ++i)
    largest = std::max(largest, system.terms.elasticity[i](0, 0) * system.state.displacement[i].head<2>().norm());
  return most_round_off * std::numeric_limits<double>::epsilon() * largest;
}

// The largest weight of a held block in N per m of thickness, where steps do not take it from an inertia that these do
// not have. It is in no balance, but of the size of what rests on them; no more of it counts than does rest on them, or
// the ground below a stone would say that a stone in the air is at rest.
double largest_held_weight(const BlockSystem& system) {
  double largest = 0;
  if (!system.plan.gravity || system.plan.linear) return largest;
  const double gravity = system.model.gravity.norm();
  for (const int held : system.held.blocks) {
    const double carried = largest_of(system, system.forces.internal_old, static_cast<std::size_t>(held));
    largest = std::max(largest, std::min(carried, system.model.mass_of(held) * gravity));
  }
  return largest;
}

// The largest load, weight or force in situ, N per m of thickness.
double largest_load(const BlockSystem& system, double in_situ_force) {
  const double load = std::max(in_situ_force, largest_of_all(system, system.forces.load_old));
  if (!system.plan.gravity) return load;
  return std::max({load, largest_of_all(system, system.external.weight()), largest_held_weight(system)});
}

// The largest force that acts, N per m of thickness, and whether only loads do. Prescribed motions and pretensions act
// by the forces that they make blocks exchange. The same where nothing acts, and the rock comes to rest from what an
// earlier stage has left.
struct Acting {
  double largest;
  bool as_loads;
};

Acting largest_acting(const BlockSystem& system, double in_situ_force) {
  const double load = largest_load(system, in_situ_force);
  if (load > 0 && !acts_without_load(system)) return {load, true};
  return {std::max({load, exchanged_now(system), share_remembered * system.forces.most_exchanged}), false};
}

double round_off_of_gaps(const BlockSystem& system) {
  double stiffest = 0;
  for (const Mat3& elasticity : system.terms.elasticity) stiffest = std::max(stiffest, elasticity(0, 0));
  return round_off_of_places * system.model.length_tolerance * stiffest;
}

// What a force on a block is measured by, N per m of thickness: the largest that acts, and less for blocks whose own
// weight and load are next to nothing beside it. Linear stages, in which blocks stay where they are, know the first.
class Measure {
 public:
  Measure(const BlockSystem& system, double largest)
      : system_(system), largest_(largest), is_one_for_all_(!system.plan.gravity || system.plan.linear) {
    if (!is_one_for_all_) least_ = round_off_of_gaps(system);
  }

  [[nodiscard]] double of(std::size_t block) const {
    if (is_one_for_all_) return largest_;
    const auto place = static_cast<Eigen::Index>(6 * block);
    const Vec6 own = system_.forces.load_old.segment<6>(place) + system_.external.weight().segment<6>(place);
    const double force = largest_entry(own, system_.terms.area[block]);
    return force > least_ ? std::min(largest_, force / least_share) : largest_;
  }

 private:
  const BlockSystem& system_;
  double largest_, least_ = 0;
  bool is_one_for_all_;
};

// Unbalanced forces as shares of these, those of held blocks zero. What is no more than round-off of prescribed motions
// is none, and in linear stages, whose blocks go no further than rock gives way, nor is that of any motion.
Eigen::VectorXd unbalanced_shares(const BlockSystem& system, double in_situ_force) {
  Eigen::VectorXd unbalanced = system.unbalanced_forces();
  system.held.clear(unbalanced);
  const Acting acting = largest_acting(system, in_situ_force);
  const bool goes_as_far_as_rock_gives_way = !acting.as_loads || system.plan.linear;
  if (goes_as_far_as_rock_gives_way && largest_of_all(system, unbalanced) <= round_off_of_motion(system))
    unbalanced.setZero();
  if (!(acting.largest > 0)) return unbalanced;
  const Measure measure(system, acting.largest);
  for (std::size_t i = 0; i < system.terms.area.size(); ++i)
    unbalanced.segment<6>(static_cast<Eigen::Index>(6 * i)) /= measure.of(i);
  return unbalanced;
}

// Dashpots hold nothing at rest.
bool holds_something(const Model& model, std::size_t stage) {
  const auto holds = [stage](const PointSupport& support) {
    return !support.partner && (support.last_stage < 0 || static_cast<std::size_t>(support.last_stage) >= stage);
  };
  return !model.held_blocks.empty() || std::ranges::any_of(model.supports, holds);
}

// What is left where springs pass contacts from corner to corner with every step, of columns under strains of a
// thousandth and more: up to 3e-8 of the largest force was seen.
constexpr double left_by_springs = 1e-6;

std::string remedy_of_imbalance(const Stage& stage, double left) {
  if (!stage.paces_itself()) return "; more steps or a larger dt may help";
  if (!(left <= left_by_springs)) return "";
  return fmt::format(
      "; so little can be left for good where springs hop from corner to corner: \"equilibrium\": {:.0e} "
      "bears with it",
      std::pow(10, std::ceil(std::log10(left))));
}

constexpr const char* nor_the_rock =
    "; nor is anything held that they could rest on: rock whose loads are in balance may drift and turn as a whole, "
    "and "
    "its blocks with it; hold it by supports";

}  // namespace

void note_exchanged_forces(BlockSystem& system) {
  system.forces.most_exchanged = std::max(system.forces.most_exchanged, exchanged_now(system));
}

void note_asked_balance(BlockSystem& system, double in_situ_force) {
  constexpr double margin = 0.5;  // geometry that follows the step changes a little more
  std::vector<double>& asked = system.forces.asked_balance;
  asked.clear();
  if (!system.plan.is_static || system.plan.linear || system.stage().equilibrium == 0) return;
  const Measure measure(system, largest_acting(system, in_situ_force).largest);
  asked.resize(system.terms.area.size());
  for (std::size_t i = 0; i < asked.size(); ++i) asked[i] = margin * system.stage().equilibrium * measure.of(i);
}

double out_of_balance(const BlockSystem& system, double in_situ_force) {
  return largest_of_all(system, unbalanced_shares(system, in_situ_force));
}

std::vector<UnbalancedBlock> find_blocks_out_of_balance(const BlockSystem& system, double in_situ_force) {
  const double asked = system.stage().equilibrium;
  if (!system.plan.is_static || asked == 0) return {};
  const Eigen::VectorXd shares = unbalanced_shares(system, in_situ_force);
  const auto largest = [&](int block) { return largest_of(system, shares, static_cast<std::size_t>(block)); };
  std::vector<int> blocks(system.model.blocks.size());
  std::iota(blocks.begin(), blocks.end(), 0);
  std::erase_if(blocks, [&](int block) { return largest(block) <= asked; });
  std::ranges::stable_sort(blocks, std::ranges::greater(), largest);
  return placed(system, blocks);
}

std::string equilibrium_problem(const Model& model, const StageEnd& end) {
  const Stage& ended = model.stages[end.stage];
  if (!ended.integrator.is_static || ended.on_unbalanced == OnUnbalanced::carry_on) return "";
  if (ended.equilibrium > 0 && !(end.out_of_balance <= ended.equilibrium))
    return fmt::format(
        "static stage \"{}\" ended with forces out of balance by {:.2g} of the largest force, {:.2g} were asked for{}: "
        "{}",
        ended.name, end.out_of_balance, ended.equilibrium, remedy_of_imbalance(ended, end.out_of_balance),
        named_with_places(model, end.unbalanced));
  const bool loose_ones_count = ended.on_unbalanced == OnUnbalanced::stop || end.stage + 1 == model.stages.size();
  if (!loose_ones_count || end.loose.empty()) return "";
  return fmt::format("static stage \"{}\" has no equilibrium for {}, which nothing holds{}", ended.name,
                     named_with_places(model, end.loose), holds_something(model, end.stage) ? "" : nor_the_rock);
}

}  // namespace dda
