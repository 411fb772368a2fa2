#include <fmt/format.h>

#include <algorithm>

#include "dda/geometry/segment.h"
#include "dda/model/check_parts.h"
#include "dda/model/checks.h"
#include "dda/model/tolerance.h"

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
}

void check_history(const Item& item, const TimeFunction& history) {
  std::visit([&item](const auto& f) { check_history(item, f); }, history);
}

const Polygon& shape_of(const Model& model, int block) { return model.blocks[static_cast<std::size_t>(block)].shape; }

void check_point(const Model& model, const Item& item, int block, const Vec2& point) {
  item.index("block", block, model.blocks.size());
  item.finite("point", point);
  if (locate(shape_of(model, block), point, point_tolerance(model)) != Location::outside) return;
  item.fail("point", fmt::format("({}, {}) m", point.x(), point.y()), "a point of its block");
}

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
  item.finite("displacement", support.displacement);
  if (!support.holds_x && !support.holds_y) item.fail("hold", "neither x nor y", "at least one direction");
  check_history(item, support.history);
}

}  // namespace

void check_loads(const Model& model) {
  for (std::size_t i = 0; i < model.point_loads.size(); ++i) {
    const PointLoad& load = model.point_loads[i];
    const Item item("point_loads", i);
    check_point(model, item, load.block, load.point);
    item.finite("force", load.force);
    check_history(item, load.history);
  }
  for (std::size_t i = 0; i < model.edge_loads.size(); ++i) {
    const EdgeLoad& load = model.edge_loads[i];
    const Item item("edge_loads", i);
    check_stretch(model, item, load.block, load.from, load.to);
    item.finite("traction", load.traction);
    check_history(item, load.history);
  }
}

void check_supports(const Model& model) {
  for (std::size_t i = 0; i < model.supports.size(); ++i) check_support(model, Item("supports", i), model.supports[i]);
}

void check_viscous_edges(const Model& model) {
  for (std::size_t i = 0; i < model.viscous_edges.size(); ++i) {
    const ViscousEdge& edge = model.viscous_edges[i];
    const Item item("viscous_edges", i);
    check_stretch(model, item, edge.block, edge.from, edge.to);
    item.not_negative("normal impedance", edge.normal_impedance);
    item.not_negative("shear impedance", edge.shear_impedance);
  }
}

}  // namespace dda::model_checks
