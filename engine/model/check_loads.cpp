#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "engine/geometry/segment.h"
#include "engine/model/check_parts.h"
#include "engine/model/checks.h"
#include "engine/model/held_motion.h"
#include "engine/model/tolerance.h"

namespace dda::model_checks {
namespace {

void check_history(const Item&, const Constant&) {}

void check_history(const Item& item, const PiecewiseLinear& table) {
  if (table.times.empty() || table.times.size() != table.values.size()) {
    item.fail("history", fmt::format("a table of {} times and {} values", table.times.size(), table.values.size()),
              "as many values as times, at least one");
  }
  for (std::size_t i = 0; i < table.times.size(); ++i) {
    item.finite("history time", table.times[i]);
    item.finite("history value", table.values[i]);
    if (i == 0 || table.times[i] > table.times[i - 1]) continue;
    item.fail("history", fmt::format("a table with time {} after {}", table.times[i], table.times[i - 1]),
              "increasing times");
  }
}

void check_history(const Item& item, const SineCycles& sine) {
  item.positive("history frequency", sine.frequency);
  item.finite("history start", sine.start);
  if (!(sine.cycles > 0)) item.fail("history cycles", fmt::format("{}", sine.cycles), "a positive number");
}

void check_history(const Item& item, const ExponentialDecay& decay) {
  item.positive("history decay time", decay.decay_time);
  item.finite("history start", decay.start);
  item.not_negative("history rise", decay.rise);
}

void check_history(const Item& item, const Recorded& recorded) {
  if (!recorded.recording) item.fail("history", "a recording without samples", "samples");
  item.finite("history start", recorded.start);
}

const Polygon& shape_of(const Model& model, int block) { return model.blocks[static_cast<std::size_t>(block)].shape; }

}  // namespace

void check_history(const Item& item, const TimeFunction& history) {
  std::visit([&item](const auto& f) { check_history(item, f); }, history);
}

void check_point(const Model& model, const Item& item, int block, const Vec2& point) {
  item.index("block", block, model.blocks.size());
  item.finite("point", point);
  if (locate(shape_of(model, block), point, point_tolerance(model)) != Location::outside) return;
  item.fail("point", fmt::format("({}, {}) m", point.x(), point.y()), "a point of its block");
}

namespace {

double distance_to_outline(const Ring& ring, const Vec2& point) {
  double least = distance(Segment{ring.back(), ring.front()}, point);
  for (std::size_t i = 1; i < ring.size(); ++i) least = std::min(least, distance(Segment{ring[i - 1], ring[i]}, point));
  return least;
}

double distance_to_outline(const Polygon& polygon, const Vec2& point) {
  double least = distance_to_outline(polygon.outer, point);
  for (const Ring& hole : polygon.holes) least = std::min(least, distance_to_outline(hole, point));
  return least;
}

void check_stretch(const Model& model, const Item& item, int block, const Vec2& from, const Vec2& to) {
  item.index("block", block, model.blocks.size());
  for (const Vec2& end : {from, to, Vec2((from + to) / 2)}) {
    item.finite("edge", end);
    if (distance_to_outline(shape_of(model, block), end) <= point_tolerance(model)) continue;
    item.fail("edge", fmt::format("through ({}, {}) m", end.x(), end.y()), "a stretch of its block's outline");
  }
  item.positive("edge length", (to - from).norm());
}

void check_support(const Model& model, const Item& item, const PointSupport& support) {
  check_point(model, item, support.block, support.point);
  item.positive("stiffness", support.stiffness);
  item.finite("amplitude", support.amplitude);
  if (!support.direction.isZero(0)) {
    item.finite("direction", support.direction);
    item.within("direction length", support.direction.norm(), 1 - 1e-9, 1 + 1e-9);
  }
  if (support.last_stage != -1) item.index("last stage", support.last_stage, model.stages.size());
  if (support.takes_force_along && support.last_stage == -1)
    item.fail("taking its force along", "asked for", "a last stage, at whose end it is let go");
  if (support.partner) check_point(model, item, support.block, *support.partner);
  if (support.partner && support.last_stage != -1)
    item.fail("last stage", fmt::format("{}", support.last_stage), "-1 for a spring between two points of a block");
  if (!support.holds_x && !support.holds_y) item.fail("hold", "neither x nor y", "at least one direction");
  check_history(item, support.history);
}

bool has_viscous_edge(const Model& model, int block) {
  return std::any_of(model.viscous_edges.begin(), model.viscous_edges.end(),
                     [block](const ViscousEdge& edge) { return edge.block == block; });
}

bool has_small_stage(const Model& model) {
  return std::any_of(model.stages.begin(), model.stages.end(),
                     [](const Stage& stage) { return stage.kinematics == Kinematics::small; });
}

// What a held block cannot have, as its motion is prescribed.
void check_held_block(const Model& model, const Item& item, const HeldBlock& held) {
  item.index("block", held.block, model.blocks.size());
  item.finite("amplitude", held.amplitude);
  item.finite("turn", held.turn);
  item.finite("about", held.about);
  check_history(item, held.history);
  const Block& block = model.blocks[static_cast<std::size_t>(held.block)];
  const std::string name = fmt::format("\"{}\"", block.name);
  if (!block.starts_at_rest())
    item.fail("block", name + " with an initial velocity or spin", "a block without, as its motion is prescribed");
  if (has_viscous_edge(model, held.block))
    item.fail("block", name + " with a viscous boundary", "a block without, as its motion is prescribed");
  if (held.turn != 0 && has_small_stage(model))
    item.fail("turn", fmt::format("{} rad", held.turn), "finite kinematics in all stages where a block is turned");
}

void check_stages_of(const Item& item, const StageSpan& stages, const Model& model) {
  if (stages.first != 0) item.index("first stage", stages.first, model.stages.size());
  if (stages.last == -1) return;
  item.index("last stage", stages.last, model.stages.size());
  if (stages.last < stages.first)
    item.fail("last stage", fmt::format("{}", stages.last), fmt::format("{} or later", stages.first));
}

}  // namespace

void check_loads(const Model& model) {
  for (std::size_t i = 0; i < model.point_loads.size(); ++i) {
    const PointLoad& load = model.point_loads[i];
    const Item item("point_loads", i);
    check_point(model, item, load.block, load.point);
    item.finite("force", load.force);
    check_history(item, load.history);
    check_stages_of(item, load.stages, model);
  }
  for (std::size_t i = 0; i < model.edge_loads.size(); ++i) {
    const EdgeLoad& load = model.edge_loads[i];
    const Item item("edge_loads", i);
    check_stretch(model, item, load.block, load.from, load.to);
    item.finite("traction", load.traction);
    item.finite("rise of the traction", load.rise);
    check_history(item, load.history);
    check_stages_of(item, load.stages, model);
  }
}

void check_supports(const Model& model) {
  for (std::size_t i = 0; i < model.supports.size(); ++i) check_support(model, Item("supports", i), model.supports[i]);
}

void check_held_blocks(const Model& model) {
  for (std::size_t i = 0; i < model.held_blocks.size(); ++i)
    check_held_block(model, Item("held_blocks", i), model.held_blocks[i]);
  std::vector<bool> seen(model.blocks.size(), false);
  std::size_t entry = 0;
  for_each_held_block(model, [&](const HeldMotions& motions) {
    const Item item("held_blocks", entry);
    entry += motions.size();
    const auto block = static_cast<std::size_t>(motions[0].block);
    if (seen[block] || !add_up(motions))
      item.fail("block", fmt::format("\"{}\"", model.blocks[block].name), "a block that is not held already");
    seen[block] = true;
  });
}

void check_viscous_edges(const Model& model) {
  for (std::size_t i = 0; i < model.viscous_edges.size(); ++i) {
    const ViscousEdge& edge = model.viscous_edges[i];
    const Item item("viscous_edges", i);
    check_stretch(model, item, edge.block, edge.from, edge.to);
    item.not_negative("normal impedance", edge.normal_impedance);
    item.not_negative("shear impedance", edge.shear_impedance);
    if (edge.first_stage != 0) item.index("first stage", edge.first_stage, model.stages.size());
  }
}

}  // namespace dda::model_checks
