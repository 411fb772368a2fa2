#include "engine/simulation/equilibrium.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "engine/simulation/block_system.h"
#include "engine/solve/largest_entry.h"

namespace dda {
namespace {

constexpr std::size_t most_named = 3;

// Of the entries of one block. Moments count as forces at the arm of its size, or balance would be asked for the more
// strictly the larger a scene.
double largest_of(const BlockSystem& system, const Eigen::VectorXd& forces, std::size_t block) {
  return largest_entry(forces, block, system.terms.area[block]);
}

// Not a number where an entry is none.
double largest_of_all(const BlockSystem& system, const Eigen::VectorXd& forces) {
  double largest = 0;
  for (std::size_t i = 0; i < system.terms.area.size(); ++i) largest = std::max(largest, largest_of(system, forces, i));
  return largest + 0 * forces.sum();
}

// Unbalanced forces as shares of the largest load, those of held blocks zero.
Eigen::VectorXd unbalanced_shares(const BlockSystem& system, double in_situ_force) {
  Eigen::VectorXd unbalanced = system.unbalanced_forces();
  system.held.clear(unbalanced);
  double scale = std::max(in_situ_force, largest_of_all(system, system.forces.load_old));
  if (system.plan.gravity) scale = std::max(scale, largest_of_all(system, system.external.weight()));
  if (scale > 0) unbalanced /= scale;
  return unbalanced;
}

}  // namespace

double out_of_balance(const BlockSystem& system, double in_situ_force) {
  return largest_of_all(system, unbalanced_shares(system, in_situ_force));
}

std::vector<int> blocks_out_of_balance(const BlockSystem& system, double in_situ_force, double share) {
  const Eigen::VectorXd shares = unbalanced_shares(system, in_situ_force);
  const auto largest = [&](int block) { return largest_of(system, shares, static_cast<std::size_t>(block)); };
  std::vector<int> blocks(system.model.blocks.size());
  std::iota(blocks.begin(), blocks.end(), 0);
  std::erase_if(blocks, [&](int block) { return largest(block) <= share; });
  std::ranges::stable_sort(blocks, std::ranges::greater(), largest);
  return blocks;
}

std::string equilibrium_problem(const BlockSystem& system, double in_situ_force) {
  const Stage& ended = system.stage();
  const double imbalance = out_of_balance(system, in_situ_force);
  const std::vector<int>& loose = system.drag.loose();
  const auto named = [&](const std::vector<int>& blocks) {
    return named_with_places(system.model, placed(system, blocks));
  };
  if (ended.equilibrium > 0 && !(imbalance <= ended.equilibrium))
    return fmt::format(
        "static stage \"{}\" ended with forces out of balance by {:.2g} of the largest load, {:.2g} were asked for{}: "
        "{}",
        ended.name, imbalance, ended.equilibrium, ended.paces_itself() ? "" : "; more steps or a larger dt may help",
        named(blocks_out_of_balance(system, in_situ_force, ended.equilibrium)));
  const bool is_last = system.clock.stage + 1 == system.model.stages.size();
  if (is_last && !loose.empty())
    return fmt::format("static stage \"{}\" has no equilibrium for {}, which nothing holds", ended.name, named(loose));
  return "";
}

std::vector<UnbalancedBlock> placed(const BlockSystem& system, const std::vector<int>& blocks) {
  std::vector<UnbalancedBlock> found;
  for (const int block : blocks) {
    const auto i = static_cast<std::size_t>(block);
    const Vec2 place = system.model.blocks[i].moments.centroid + system.state.displacement[i].head<2>();
    found.push_back({static_cast<int>(system.clock.stage), block, place});
  }
  return found;
}

std::string named_with_places(const Model& model, const std::vector<UnbalancedBlock>& blocks) {
  std::string text = blocks.size() == 1 ? "block " : "blocks ";
  for (std::size_t i = 0; i < std::min(most_named, blocks.size()); ++i) {
    const auto& [stage, block, place] = blocks[i];
    text += fmt::format("{}\"{}\" at ({:.4g}, {:.4g}) m", i == 0 ? "" : ", ",
                        model.blocks[static_cast<std::size_t>(block)].name, place.x(), place.y());
  }
  if (blocks.size() > most_named) text += fmt::format(" and {} more", blocks.size() - most_named);
  return text;
}

}  // namespace dda
