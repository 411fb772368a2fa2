#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "engine/model/check_parts.h"
#include "engine/model/checks.h"
#include "engine/model/quantity_names.h"

namespace dda::model_checks {
namespace {

// For each block the stage from whose start on it is absent.
class Removals {
 public:
  explicit Removals(const Model& model) : model_(model), stages_(model.blocks.size(), model.stages.size()) {}

  void add(std::size_t stage) {
    for (const int block : model_.stages[stage].removal.blocks) {
      item(stage).index("removed block", block, model_.blocks.size());
      if (model_.is_held(block)) fail(stage, block, "which is held", "blocks that are not held as a whole");
      if (is_removed(block)) fail(stage, block, "a second time", "each block once");
      stages_[at(block)] = stage;
    }
  }

  // `what`, as in "with a load", is on the block when it is removed, or comes later.
  void refuse_on(int block, const std::string& what) const {
    if (is_removed(block))
      fail(stages_[at(block)], block, what, "blocks on which nothing acts and nothing is measured to the end");
  }

  [[nodiscard]] bool is_removed(int block) const { return stages_[at(block)] < model_.stages.size(); }
  [[nodiscard]] std::size_t stage_of(int block) const { return stages_[at(block)]; }
  [[nodiscard]] bool removes_all() const {
    return std::ranges::all_of(stages_, [this](std::size_t stage) { return stage < model_.stages.size(); });
  }
  [[nodiscard]] Item item(std::size_t stage) const { return {"stages", stage, model_.stages[stage].name}; }

 private:
  static std::size_t at(int block) { return static_cast<std::size_t>(block); }

  [[noreturn]] void fail(std::size_t stage, int block, const std::string& what, const std::string& expected) const {
    item(stage).fail("remove", fmt::format("\"{}\", {}", model_.blocks[at(block)].name, what), expected);
  }

  const Model& model_;
  std::vector<std::size_t> stages_;
};

void refuse_what_acts(const Model& model, const Removals& removals) {
  for (const PointLoad& load : model.point_loads) removals.refuse_on(load.block, "on which a load acts");
  for (const EdgeLoad& load : model.edge_loads) removals.refuse_on(load.block, "on which a load acts");
  for (const ViscousEdge& edge : model.viscous_edges) removals.refuse_on(edge.block, "which has a viscous boundary");
  for (const PointSupport& support : model.supports) {
    const bool is_over = support.last_stage >= 0 && support.takes_force_along &&
                         static_cast<std::size_t>(support.last_stage) < removals.stage_of(support.block);
    if (!is_over) removals.refuse_on(support.block, "which a support holds, or the force that one has left");
  }
  for (const Bolt& bolt : model.bolts)
    for (const BoltLink& link : bolt.links)
      for (const int block : {link.block_a, link.block_b})
        removals.refuse_on(block, fmt::format("to which \"{}\" is anchored", bolt.name));
  for (const Lining& lining : model.linings)
    for (const LiningNode& node : lining.nodes)
      removals.refuse_on(node.block, fmt::format("on which \"{}\" is sprayed", lining.name));
}

void refuse_what_is_measured(const Model& model, const Removals& removals) {
  for (const Measurement& measurement : model.measurements) {
    const std::string what = fmt::format("on which \"{}\" is measured", measurement.name);
    if (is_at_point(measurement)) removals.refuse_on(measurement.block, what);
    if (subject_of(measurement.quantity) == Subject::joint) removals.refuse_on(measurement.other_block, what);
    if (subject_of(measurement.quantity) == Subject::contact_force) continue;  // what is gone exerts no force
    for (const int block : measurement.blocks) removals.refuse_on(block, what);
  }
}

void check_relaxation(const Item& item, const Stage& stage) {
  if (!stage.removal.relaxation) return;
  if (stage.paces_itself() && stage.duration == 0)
    item.fail("relaxation", "in a stage that takes no time", "a stage with a dt or a duration, or none");
  check_history(item, *stage.removal.relaxation);
  const double first = evaluate(*stage.removal.relaxation, 0);
  if (std::abs(first - 1) > 1e-12) item.fail("relaxation", fmt::format("{} at its start", first), "1 there");
  const auto* rows = std::get_if<PiecewiseLinear>(&*stage.removal.relaxation);
  if (rows == nullptr) return;
  for (const double factor : rows->values)
    if (!(factor >= 0 && factor <= 1)) item.fail("relaxation", fmt::format("{}", factor), "factors from 0 to 1");
}

}  // namespace

void check_removals(const Model& model) {
  if (!model.removes_blocks()) return;
  Removals removals(model);
  for (std::size_t i = 0; i < model.stages.size(); ++i) {
    const Stage& stage = model.stages[i];
    const Item item = removals.item(i);
    if (i == 0 && !stage.removal.blocks.empty())
      item.fail("remove", "in the first stage", "a later one, or a scene without these blocks");
    check_relaxation(item, stage);
    removals.add(i);
    if (removals.removes_all()) item.fail("remove", "all blocks that are left", "some that stay");
  }
  refuse_what_acts(model, removals);
  refuse_what_is_measured(model, removals);
}

}  // namespace dda::model_checks
