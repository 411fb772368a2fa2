#include "engine/cutting/plan_pieces.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "engine/core/parallel_sort.h"
#include "engine/cutting/lonely_ends.h"
#include "engine/geometry/diameter.h"

namespace dda {
namespace {

constexpr double default_tolerance = 1e-6;  // of the diameter of the boundary
constexpr double room_around = 0.01;        // of the diagonal, between the boundary and where lines are cut off

// The part of a segment inside a box (Liang and Barsky), computed from left to right: its bits do not depend on
// which way the line was drawn.
std::optional<Straight> clipped(const Straight& given, const Box& box) {
  const bool is_reversed = std::tuple(given.to.x(), given.to.y()) < std::tuple(given.from.x(), given.from.y());
  const Straight straight = is_reversed ? Straight{given.to, given.from} : given;
  const Vec2 along = straight.to - straight.from;
  double from = 0;
  double to = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const double low = box.lower(axis) - straight.from(axis);
    const double high = box.upper(axis) - straight.from(axis);
    if (along(axis) == 0) {
      if (low > 0 || high < 0) return std::nullopt;
      continue;
    }
    const auto [enter, leave] = std::minmax({low / along(axis), high / along(axis)});
    from = std::max(from, enter);
    to = std::min(to, leave);
  }
  if (!(from < to)) return std::nullopt;
  Straight part = straight;
  if (to < 1) part.to = straight.from + to * along;
  if (from > 0) part.from = straight.from + from * along;
  if (is_reversed) std::swap(part.from, part.to);
  return part;
}

class Collector {
 public:
  Collector(const RockPlan& plan, const Box& box, double tolerance)
      : plan_(plan), box_(box), pieces_{PixelGrid(box), tolerance, {}, {}, {}, {}, {}, {}, {}} {
    std::size_t straights = 0;
    for (const PlanLine& line : plan.lines) straights += line.points.size() - 1;
    pieces_.straights.reserve(straights);
    pieces_.sources.reserve(straights);
    pieces_.pieces.reserve(3 * straights);  // two ends of each may be prolonged
    pieces_.ends.reserve(2 * straights);
  }

  void add_ring(const Ring& ring, int curve) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      add_straight({ring[i], ring[(i + 1) % ring.size()]}, {curve, no_line}, false, false);
  }

  void add_line(int number) {
    const PlanLine& line = plan_.lines[static_cast<std::size_t>(number)];
    const std::size_t last = line.points.size() - 1;
    const bool closed = line.points.front() == line.points.back();
    for (std::size_t i = 0; i < last; ++i)
      add_straight({line.points[i], line.points[i + 1]}, {no_curve, number}, i == 0 && !closed,
                   i + 1 == last && !closed);
  }

  PlanPieces take() {
    parallel_sort(pieces_.ends, [](const KnownNode& a, const KnownNode& b) {
      return std::tuple(a.pixel, a.position.x(), a.position.y()) < std::tuple(b.pixel, b.position.x(), b.position.y());
    });
    drop_lonely_prolongations();
    return std::move(pieces_);
  }

 private:
  void add_straight(const Straight& given, const Source& source, bool prolonged_back, bool prolonged_on) {
    const auto straight = clipped(given, box_);
    if (!straight) {
      if (given.from == given.to) note_no_length(given, source);
      return;
    }
    const Pixel from = pieces_.grid.pixel_of(straight->from);
    const Pixel to = pieces_.grid.pixel_of(straight->to);
    if (from == to) return note_no_length(given, source);
    const int number = static_cast<int>(pieces_.straights.size());
    pieces_.straights.push_back(*straight);
    pieces_.sources.push_back(source);
    pieces_.pieces.push_back({{from, to}, number});
    const bool from_kept = straight->from == given.from;
    const bool to_kept = straight->to == given.to;
    if (from_kept) pieces_.ends.push_back({from, given.from});
    if (to_kept) pieces_.ends.push_back({to, given.to});
    const Vec2 way = pieces_.tolerance * (straight->to - straight->from).normalized();
    if (prolonged_back && from_kept) add_prolongation(from, {given.from, given.from - way}, number);
    if (prolonged_on && to_kept) add_prolongation(to, {given.to, given.to + way}, number);
  }

  // No further than lines are cut off, whatever the tolerance: there the grid ends.
  void add_prolongation(const Pixel& from, const Straight& way, int straight) {
    const auto part = clipped(way, box_);
    if (!part) return;
    pieces_.pieces.push_back({{from, pieces_.grid.pixel_of(part->to)}, straight});
  }

  void drop_lonely_prolongations() {
    const std::vector<bool> is_lonely = lonely_prolongations(pieces_.pieces, pieces_.grid, pieces_.tolerance, plan_);
    pieces_.prolonged.assign(pieces_.straights.size(), false);
    pieces_.ends_alone.assign(pieces_.straights.size(), false);
    std::vector<Piece> kept;
    kept.reserve(pieces_.pieces.size());
    for (std::size_t i = 0; i < is_lonely.size(); ++i) {
      const Piece& piece = pieces_.pieces[i];
      const auto straight = static_cast<std::size_t>(piece.straight);
      if (!is_lonely[i])
        kept.push_back(piece);
      else if (piece.segment.from == pieces_.grid.pixel_of(pieces_.straights[straight].to))
        pieces_.ends_alone[straight] = true;
      if (!is_lonely[i] && i > 0 && pieces_.pieces[i - 1].straight == piece.straight)
        pieces_.prolonged[straight] = true;
    }
    pieces_.pieces = std::move(kept);
  }

  void note_no_length(const Straight& given, const Source& source) {
    if (source.line == no_line) return;
    pieces_.cleaned.push_back({Cleaning::line_without_length, given.from, given.to, (given.to - given.from).norm(),
                               plan_.lines[static_cast<std::size_t>(source.line)].origin});
  }

  const RockPlan& plan_;
  Box box_;
  PlanPieces pieces_;
};

// Lines are cut off beyond it. Closed curves must stay closed, or they would no longer say what lies in them: an
// opening may reach out of the rock as far as it likes.
Box box_of_curves(const RockPlan& plan, const Box& boundary) {
  Box box = boundary;
  const auto take_in = [&box](const Ring& ring) {
    for (const Vec2& corner : ring) box = expanded(box, corner);
  };
  for (const Ring& hole : plan.holes) take_in(hole);
  for (const PlanOpening& opening : plan.openings) take_in(opening.outline);
  return box;
}

}  // namespace

PlanPieces pieces_of(const RockPlan& plan, double tolerance) {
  const Box boundary = bounding_box(plan.boundary);
  const double diagonal = (boundary.upper - boundary.lower).norm();
  Collector collector(plan, expanded(box_of_curves(plan, boundary), room_around * diagonal),
                      tolerance > 0 ? tolerance : default_tolerance * diameter(plan.boundary));
  collector.add_ring(plan.boundary, boundary_curve);
  for (std::size_t i = 0; i < plan.holes.size(); ++i) collector.add_ring(plan.holes[i], curve_of_hole(i));
  for (std::size_t i = 0; i < plan.openings.size(); ++i)
    collector.add_ring(plan.openings[i].outline, curve_of_opening(plan, i));
  for (std::size_t i = 0; i < plan.lines.size(); ++i) collector.add_line(static_cast<int>(i));
  return collector.take();
}

std::vector<bool> drawn_nodes(const std::vector<Pixel>& nodes, const PlanPieces& pieces) {
  std::vector<bool> is_drawn(nodes.size(), false);
  auto end = pieces.ends.begin();
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    while (end != pieces.ends.end() && end->pixel < nodes[node]) ++end;
    is_drawn[node] = end != pieces.ends.end() && end->pixel == nodes[node];
  }
  return is_drawn;
}

}  // namespace dda
