#include "engine/cutting/drawn_traces.h"

#include <algorithm>
#include <cstddef>

#include "engine/geometry/box_pairs.h"

namespace dda {
namespace {

// The outlines between rock and what is none.
class Ground {
 public:
  explicit Ground(const RockPlan& plan) : rock_{plan.boundary, plan.holes}, edges_(boxes_of_edges(plan)) {}

  // The parts of a straight line that lie in rock: between two crossings all of it does, or nothing.
  [[nodiscard]] std::vector<Segment> inside(const Segment& line) const {
    std::vector<double> ends{0, 1};
    for (const int i : edges_.overlapping(expanded(expanded(Box{}, line.start), line.end)))
      append_crossing(line, outlines_[static_cast<std::size_t>(i)], ends);
    std::sort(ends.begin(), ends.end());
    std::vector<Segment> parts;
    for (std::size_t i = 1; i < ends.size(); ++i) {
      if (ends[i] > ends[i - 1] && is_rock(point_at(line, (ends[i] + ends[i - 1]) / 2)))
        parts.push_back({point_at(line, ends[i - 1]), point_at(line, ends[i])});
    }
    return parts;
  }

 private:
  void add(const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) outlines_.push_back({ring[i], ring[(i + 1) % ring.size()]});
  }

  std::vector<Box> boxes_of_edges(const RockPlan& plan) {
    add(plan.boundary);
    for (const Ring& hole : plan.holes) add(hole);
    for (const PlanOpening& opening : plan.openings) {
      if (!opening.left_out) continue;
      add(opening.outline);
      left_out_.push_back({opening.outline, {}});
    }
    std::vector<Box> boxes;
    for (const Segment& edge : outlines_) boxes.push_back(expanded(expanded(Box{}, edge.start), edge.end));
    return boxes;
  }

  static void append_crossing(const Segment& line, const Segment& edge, std::vector<double>& ends) {
    const Vec2 along = line.end - line.start;
    const Vec2 way = edge.end - edge.start;
    const double across = cross(along, way);
    if (across == 0) return;  // along an edge nothing changes sides
    const Vec2 between = edge.start - line.start;
    const double at = cross(between, way) / across;
    const double on_edge = cross(between, along) / across;
    if (at > 0 && at < 1 && on_edge >= 0 && on_edge <= 1) ends.push_back(at);
  }

  [[nodiscard]] bool is_rock(const Vec2& place) const {
    return locate(rock_, place) == Location::inside &&
           std::ranges::none_of(left_out_, [&](const Polygon& opening) { return contains(opening, place); });
  }

  Polygon rock_;
  std::vector<Polygon> left_out_;
  std::vector<Segment> outlines_;
  BoxIndex edges_;  // after what it is made from
};

}  // namespace

DrawnTraces traces_in_rock(const RockPlan& plan) {
  DrawnTraces drawn;
  if (plan.boundary.empty()) return drawn;
  const Ground ground(plan);
  for (const PlanLine& line : plan.lines) {
    if (line.construction) continue;
    const std::size_t before = drawn.pieces.size();
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      for (const Segment& part : ground.inside({line.points[i - 1], line.points[i]})) drawn.pieces.push_back(part);
    }
    if (drawn.pieces.size() > before) ++drawn.traces;
  }
  return drawn;
}

}  // namespace dda
