#include "engine/app/run_warnings.h"

#include <fmt/format.h>

#include <cstddef>
#include <optional>

#include "engine/advice/spin_remarks.h"
#include "engine/advice/unseen_loads.h"
#include "engine/core/place_in_words.h"
#include "engine/simulation/shared_ground.h"

namespace dda {
namespace {

const std::string& name_of(const Simulation& simulation, int block) {
  return simulation.model().blocks[static_cast<std::size_t>(block)].name;
}

// Contacts that are pressed in so deep carry the right forces in the wrong place.
std::string penetration_warning(const Simulation& simulation) {
  const Penetration& deepest = simulation.deepest_penetration();
  if (deepest.share <= tolerated_penetration) return "";
  return fmt::format(
      "warning: blocks \"{}\" and \"{}\" were {:.3g} m deep in each other at {:.6g} s, {:.2g} % of the smaller one; {}",
      name_of(simulation, deepest.block_a), name_of(simulation, deepest.block_b), deepest.depth, deepest.time,
      100 * deepest.share, remedy_of_depth(simulation.model(), deepest.block_a, deepest.block_b));
}

// What no contact knows of is in no force either.
std::string in_words(const Simulation& simulation, const char* verb, const SharedGroundOfStage& left) {
  const SharedGround& worst = left.worst;
  std::string words = fmt::format(
      "blocks \"{}\" and \"{}\" {} {:.3g} m deep in each other at {}, {:.2g} % of the smaller one, by "
      "more than contacts of theirs give way",
      name_of(simulation, worst.block_a), name_of(simulation, worst.block_b), verb, worst.depth,
      place_in_words(worst.place), 100 * worst.share);
  if (left.pairs > 1) words += fmt::format(", and {} other pairs by less", left.pairs - 1);
  return words;
}

// A static stage that ends the run has been looked at when it was over.
std::optional<SharedGroundOfStage> left_at_the_end(const Simulation& simulation) {
  const std::vector<Stage>& stages = simulation.model().stages;
  if (!stages.back().integrator.is_static) return shared_ground_of_stage(simulation.system());
  const std::vector<SharedGroundOfStage>& noted = simulation.results().shared_ground;
  const bool is_noted = !noted.empty() && static_cast<std::size_t>(noted.back().stage) + 1 == stages.size();
  return is_noted ? std::optional(noted.back()) : std::nullopt;
}

std::string shared_ground_warning(const Simulation& simulation) {
  const auto left = left_at_the_end(simulation);
  return left ? "warning: " + in_words(simulation, "end", *left) : "";
}

// What came right later was no equilibrium for whoever reads the settled state. The end of the run is told above.
std::string settled_in_each_other_warning(const Simulation& simulation) {
  const std::vector<Stage>& stages = simulation.model().stages;
  for (const SharedGroundOfStage& each : simulation.results().shared_ground) {
    const auto stage = static_cast<std::size_t>(each.stage);
    if (stage + 1 < stages.size())
      return fmt::format("warning: when static stage \"{}\" was over {}", stages[stage].name,
                         in_words(simulation, "were", each));
  }
  return "";
}

std::string loose_warning(const Simulation& simulation) {
  const auto& loose = simulation.results().loose;
  if (loose.empty()) return "";
  return fmt::format(
      "warning: nothing holds {}; in static stages they were held where half of their size of sinking and sliding "
      "had taken them, so that others settle",
      named_with_places(simulation.model(), loose));
}

// Only runs that were told to go on come to say this.
std::string balance_warning(const Simulation& simulation) {
  const auto& unbalanced = simulation.results().unbalanced;
  if (unbalanced.empty()) return "";
  const int first = unbalanced.front().stage;
  return fmt::format("warning: static stage \"{}\" left forces out of balance on {}, and the run went on",
                     simulation.model().stages[static_cast<std::size_t>(first)].name,
                     named_with_places(simulation.model(), of_stage(static_cast<std::size_t>(first), unbalanced)));
}

std::string air_warning(const Simulation& simulation, const ReinforcementInAir& each) {
  const Model& model = simulation.model();
  const auto number = static_cast<std::size_t>(each.number);
  const std::string what = each.is_lining ? fmt::format("lining \"{}\", sprayed", model.linings[number].name)
                                          : fmt::format("bolt \"{}\", put in", model.bolts[number].name);
  const int stage = each.is_lining ? model.linings[number].first_stage : model.bolts[number].first_stage;
  return fmt::format(
      "warning: {} when stage \"{}\" begins, crosses {:.3g} m of air that was not drawn, since blocks \"{}\" and "
      "\"{}\" have parted by then: nothing bonds it there",
      what, model.stages[static_cast<std::size_t>(stage)].name, each.way, name_of(simulation, each.block_a),
      name_of(simulation, each.block_b));
}

// Told once, of when it was seen first.
std::string water_warning(const Simulation& simulation) {
  const std::vector<WaterApart>& all = simulation.results().water_apart;
  if (all.empty()) return "";
  const WaterApart& first = all.front();
  const std::string others = first.pairs > 1 ? fmt::format(" ({} pairs in all)", first.pairs) : "";
  return fmt::format(
      "warning: blocks \"{}\" and \"{}\" were {:.3g} m apart at {:.6g} s, when stage \"{}\" was over, {:.3g} % of the "
      "smaller one{}, and the water in the joint between them still pushed them as if it were closed: let it end with "
      "the stage before they part (\"until_stage\")",
      name_of(simulation, first.block_a), name_of(simulation, first.block_b), first.way, first.time,
      simulation.model().stages[static_cast<std::size_t>(first.stage)].name, 100 * first.share, others);
}

}  // namespace

std::string remedy_of_depth(const Model& model, int block_a, int block_b) {
  if (model.is_held(block_a) && model.is_held(block_b))
    return "both are held, so that nothing keeps them apart but their motions: leave them room, as what acts between "
           "them, and its energy, mean nothing";
  return "take stiffer joints or a smaller dt";
}

std::vector<std::string> warnings_of(const Simulation& simulation) {
  std::vector<std::string> warnings = {
      penetration_warning(simulation), shared_ground_warning(simulation), settled_in_each_other_warning(simulation),
      loose_warning(simulation),       balance_warning(simulation),       water_warning(simulation)};
  for (const ReinforcementInAir& each : simulation.results().in_air) warnings.push_back(air_warning(simulation, each));
  const auto add = [&](const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences) warnings.push_back("warning: " + sentence);
  };
  add(unseen_loads(simulation.model()));
  add(spin_remarks(simulation.model(), simulation.contacts()));
  std::erase(warnings, "");
  return warnings;
}

}  // namespace dda
