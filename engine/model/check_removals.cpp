#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "engine/core/place_in_words.h"
#include "engine/model/check_parts.h"
#include "engine/model/checks.h"
#include "engine/model/quantity_names.h"

namespace dda::model_checks {
namespace {

// Follows blocks through the stages at whose start they come in and go, and refuses what contradicts itself.
class ComingAndGoing {
 public:
  explicit ComingAndGoing(const Model& model)
      : model_(model),
        none_(model.stages.size()),
        comes_(model.blocks.size(), none_),
        goes_(comes_),
        place_(comes_.size()) {}

  // To be called for one stage after the other.
  void follow(std::size_t stage) {
    for (const int block : model_.stages[stage].removal.blocks) go(stage, block);
    for (const int block : model_.stages[stage].rock.added) come(stage, block);
  }

  // Refuses `what`, as in "with a load", on a block that a stage removes, whether it is there then or comes later.
  void refuse_on(int block, const std::string& what) const {
    if (goes_[at(block)] != none_)
      fail(stage_of(block), "remove", block, what, "blocks on which nothing acts and nothing is measured to the end");
  }

  // Refuses `what`, as in "to which a bolt is anchored", from `stage` on where the block comes in later.
  void refuse_before(int block, int stage, const std::string& what) const {
    const std::size_t comes = comes_[at(block)];
    if (comes != none_ && static_cast<std::size_t>(stage) < comes)
      fail(comes, "add", block, what, "nothing on a block before it comes in");
  }

  // The stage at whose start the block goes, and one past the last where it never does.
  [[nodiscard]] std::size_t stage_of(int block) const { return goes_[at(block)]; }
  [[nodiscard]] Item item(std::size_t stage) const { return {"stages", stage, model_.stages[stage].name}; }

  [[noreturn]] void fail(std::size_t stage, const char* key, int block, const std::string& what,
                         const std::string& expected) const {
    item(stage).fail(key, fmt::format("\"{}\", {}", model_.blocks[at(block)].name, what), expected);
  }

 private:
  static std::size_t at(int block) { return static_cast<std::size_t>(block); }

  void go(std::size_t stage, int block) {
    item(stage).index("removed block", block, model_.blocks.size());
    expect_free(stage, "remove", block);
    if (place_[at(block)] == Place::away) fail(stage, "remove", block, "a second time", "each block once");
    place_[at(block)] = Place::away;
    if (goes_[at(block)] == none_) goes_[at(block)] = stage;
  }

  void come(std::size_t stage, int block) {
    item(stage).index("added block", block, model_.blocks.size());
    expect_free(stage, "add", block);
    const Block& own = model_.blocks[at(block)];
    if (goes_[at(block)] == none_ && (!own.initial_stress.isZero(0) || !own.starts_at_rest()))
      fail(stage, "add", block, "with a stress or a motion at the start", "blocks at rest and free of stress");
    if (place_[at(block)] == Place::there) fail(stage, "add", block, "a second time", "each block once");
    if (goes_[at(block)] == stage)
      fail(stage, "add", block, "which the stage removes as well", "blocks to come in, or to be removed");
    if (place_[at(block)] == Place::as_drawn) comes_[at(block)] = stage;
    place_[at(block)] = Place::there;
  }

  void expect_free(std::size_t stage, const char* key, int block) const {
    if (model_.is_held(block)) fail(stage, key, block, "which is held", "blocks that are not held as a whole");
  }

  enum class Place { as_drawn, there, away };  // as_drawn: there, unless it comes in later

  const Model& model_;
  std::size_t none_;
  std::vector<std::size_t> comes_, goes_;  // the first times
  std::vector<Place> place_;
};

void refuse_loads_and_supports(const Model& model, const ComingAndGoing& blocks) {
  const auto refuse_load = [&blocks](const auto& load, const Vec2& place) {
    if (!load.stages.is_over_in(blocks.stage_of(load.block)))
      blocks.refuse_on(load.block, "on which a load acts at " + place_in_words(place));
  };
  for (const PointLoad& load : model.point_loads) refuse_load(load, load.point);
  for (const EdgeLoad& load : model.edge_loads) refuse_load(load, (load.from + load.to) / 2);
  for (const ViscousEdge& edge : model.viscous_edges) {
    blocks.refuse_on(edge.block, "which has a viscous boundary");
    blocks.refuse_before(edge.block, edge.first_stage, "which has a viscous boundary before");
  }
  for (const PointSupport& support : model.supports) {
    const bool is_over = support.last_stage >= 0 && support.takes_force_along &&
                         static_cast<std::size_t>(support.last_stage) < blocks.stage_of(support.block);
    if (!is_over) blocks.refuse_on(support.block, "which a support holds, or the force that one has left");
    if (!support.amplitude.isZero(0)) blocks.refuse_before(support.block, 0, "which a support moves before");
    if (support.last_stage >= 0)
      blocks.refuse_before(support.block, support.last_stage, "of which a support has let go before");
  }
}

void refuse_reinforcement(const Model& model, const ComingAndGoing& blocks) {
  const auto refuse = [&blocks](int block, const auto& on_it, const std::string& what) {
    const bool leaves_nothing = !on_it.withdrawal.relaxation && on_it.withdrawal.is_over_in(blocks.stage_of(block));
    if (!leaves_nothing) blocks.refuse_on(block, what);
    blocks.refuse_before(block, on_it.first_stage, what + " before");
  };
  for (const Bolt& bolt : model.bolts)
    for (const BoltLink& link : bolt.links)
      for (const int block : {link.block_a, link.block_b})
        refuse(block, bolt, fmt::format("to which \"{}\" is anchored", bolt.name));
  for (const Lining& lining : model.linings)
    for (const LiningNode& node : lining.nodes)
      refuse(node.block, lining, fmt::format("on which \"{}\" is sprayed", lining.name));
}

void refuse_what_is_measured(const Model& model, const ComingAndGoing& blocks) {
  for (const Measurement& measurement : model.measurements) {
    const std::string what = fmt::format("on which \"{}\" is measured", measurement.name);
    if (is_at_point(measurement)) blocks.refuse_on(measurement.block, what);
    if (subject_of(measurement.quantity) == Subject::joint) blocks.refuse_on(measurement.other_block, what);
    if (subject_of(measurement.quantity) == Subject::contact_force) continue;  // what is gone exerts no force
    for (const int block : measurement.blocks) blocks.refuse_on(block, what);
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
  if (!model.removes_blocks() && !model.adds_blocks()) return;
  ComingAndGoing blocks(model);
  for (std::size_t i = 0; i < model.stages.size(); ++i) {
    const Stage& stage = model.stages[i];
    const Item item = blocks.item(i);
    if (i == 0 && !stage.removal.blocks.empty())
      item.fail("remove", "in the first stage", "a later one, or a scene without these blocks");
    if (i == 0 && !stage.rock.added.empty())
      item.fail("add", "in the first stage", "a later one: what no stage adds is there");
    check_relaxation(item, stage);
    blocks.follow(i);
  }
  for (std::size_t i = 0; i < model.stages.size(); ++i) {
    const std::vector<bool> absent = model.absent_in(i);
    if (!absent.empty() && std::ranges::count(absent, false) == 0)
      blocks.item(i).fail(model.stages[i].removal.blocks.empty() ? "blocks" : "remove", "all blocks that are left",
                          "some that are there");
  }
  refuse_loads_and_supports(model, blocks);
  refuse_reinforcement(model, blocks);
  refuse_what_is_measured(model, blocks);
}

}  // namespace dda::model_checks
