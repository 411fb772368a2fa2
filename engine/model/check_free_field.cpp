#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/core/error.h"
#include "engine/geometry/segment.h"
#include "engine/model/check_parts.h"
#include "engine/model/checks.h"
#include "engine/model/free_field_side.h"
#include "engine/model/held_motion.h"
#include "engine/model/tolerance.h"

namespace dda::model_checks {
namespace {

const ViscousEdge& edge_of(const Model& model, int index) {
  return model.viscous_edges[static_cast<std::size_t>(index)];
}

void check_edges(const Model& model, const Item& item, const FreeFieldSide& side) {
  if (side.viscous_edges.empty()) item.fail("edges", "none", "at least one viscous edge");
  for (const int index : side.viscous_edges) item.index("edge", index, model.viscous_edges.size());
  const double tolerance = point_tolerance(model);
  const Segment first = upwards(edge_of(model, side.viscous_edges.front()));
  Vec2 reached = first.start;
  for (const int index : side.viscous_edges) {
    const ViscousEdge& edge = edge_of(model, index);
    const Segment segment = upwards(edge);
    for (const Vec2& end : {segment.start, segment.end})
      if (std::abs(end.x() - first.start.x()) > tolerance)
        item.fail("edge", "through " + written(end), fmt::format("a vertical side, at x = {:.9g} m", first.start.x()));
    if ((segment.start - reached).norm() > tolerance)
      item.fail("edge", fmt::format("without blocks between {} and {}", written(reached), written(segment.start)),
                "a side without gaps, from below");
    if (edge.first_stage != edge_of(model, side.viscous_edges.front()).first_stage)
      item.fail("edge", fmt::format("acting from stage {} on in a part", edge.first_stage), "one stage for all of it");
    reached = segment.end;
  }
}

bool lies_on(const Model& model, const FreeFieldSide& side, const Vec2& point) {
  return distance(Segment{foot_of(model, side), head_of(model, side)}, point) <= point_tolerance(model);
}

// Such a load would be there twice: the column has it in its stress.
void check_no_loads(const Model& model, const Item& item, const FreeFieldSide& side) {
  if (edge_of(model, side.viscous_edges.front()).first_stage > 0) return;
  for (const EdgeLoad& load : model.edge_loads)
    if (lies_on(model, side, load.from) && lies_on(model, side, load.to))
      item.fail("edge", "loaded at " + written((load.from + load.to) / 2),
                "a side without loads, as the free field brings its own stress");
}

void check_no_supports(const Model& model, const Item& item, const FreeFieldSide& side) {
  const int first_stage = edge_of(model, side.viscous_edges.front()).first_stage;
  const Vec2 foot = foot_of(model, side);
  for (const PointSupport& support : model.supports) {
    if (support.last_stage >= 0 && support.last_stage < first_stage) continue;
    if (!lies_on(model, side, support.point) || (support.point - foot).norm() <= point_tolerance(model)) continue;
    item.fail("edge", "held at " + written(support.point),
              "supports that are let go before the free field begins, or none");
  }
}

// Dashpots to the ground at rest would hold the side back, those of a second free field would double its load.
void check_no_other_dashpots(const Model& model, const Item& item, const FreeFieldSide& side) {
  for (std::size_t i = 0; i < model.viscous_edges.size(); ++i) {
    if (std::count(side.viscous_edges.begin(), side.viscous_edges.end(), static_cast<int>(i)) > 0) continue;
    const ViscousEdge& edge = model.viscous_edges[i];
    if (lies_on(model, side, (edge.from + edge.to) / 2))
      item.fail("edge", "with another viscous boundary at " + written((edge.from + edge.to) / 2),
                "one viscous boundary along a free-field side");
  }
}

void check_base(const Model& model, const Item& item, const FreeFieldSide& side) {
  const int held = held_base_of(model, side);
  if (held >= 0) {
    const HeldMotions motions = motions_from(model, static_cast<std::size_t>(held));
    if (std::ranges::any_of(motions, [](const HeldBlock& each) { return each.turn != 0; }))
      item.fail("edge", "on a held block that turns", "one that moves without turning");
    return;
  }
  const bool absorbs =
      std::any_of(model.viscous_edges.begin(), model.viscous_edges.end(),
                  [&](const ViscousEdge& edge) { return is_at_foot(model, side, edge.block, edge.from, edge.to); });
  if (!absorbs && supports_at_foot(model, side).empty())
    item.fail("edge", "on nothing at " + written(foot_of(model, side)),
              "a held block, supports or a viscous boundary under the lowest block of the side");
}

}  // namespace

void check_free_field_side(const Model& model, std::size_t index) {
  const FreeFieldSide& side = model.free_field_sides[index];
  const Item item("free_field_sides", index);
  check_edges(model, item, side);
  if (side.outward != 1 && side.outward != -1)
    item.fail("outward", fmt::format("{}", side.outward), "-1 for a left or 1 for a right side");
  check_no_loads(model, item, side);
  check_no_supports(model, item, side);
  check_no_other_dashpots(model, item, side);
  check_base(model, item, side);
}

void check_free_field_sides(const Model& model) {
  for (std::size_t i = 0; i < model.free_field_sides.size(); ++i) check_free_field_side(model, i);
}

}  // namespace dda::model_checks
