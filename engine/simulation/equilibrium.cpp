#include "engine/simulation/equilibrium.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "engine/simulation/block_system.h"

namespace dda {
namespace {

constexpr std::size_t most_named = 3;

// The largest unbalanced force of each block, as a share of the largest load.
std::vector<double> shares_of(const BlockSystem& system, double in_situ_force) {
  Eigen::VectorXd unbalanced = system.unbalanced_forces();
  system.held.clear(unbalanced);
  double scale = std::max(in_situ_force, system.forces.load_old.cwiseAbs().maxCoeff());
  if (system.plan.gravity) scale = std::max(scale, system.external.weight().cwiseAbs().maxCoeff());
  std::vector<double> shares(system.model.blocks.size());
  for (std::size_t i = 0; i < shares.size(); ++i)
    shares[i] = unbalanced.segment<6>(static_cast<Eigen::Index>(6 * i)).cwiseAbs().maxCoeff() / (scale > 0 ? scale : 1);
  return shares;
}

}  // namespace

double out_of_balance(const BlockSystem& system, double in_situ_force) {
  return std::ranges::max(shares_of(system, in_situ_force));
}

std::vector<int> blocks_out_of_balance(const BlockSystem& system, double in_situ_force, double share) {
  const std::vector<double> shares = shares_of(system, in_situ_force);
  std::vector<int> blocks(shares.size());
  std::iota(blocks.begin(), blocks.end(), 0);
  std::erase_if(blocks, [&](int block) { return shares[static_cast<std::size_t>(block)] <= share; });
  std::ranges::stable_sort(blocks, std::ranges::greater(),
                           [&](int block) { return shares[static_cast<std::size_t>(block)]; });
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
