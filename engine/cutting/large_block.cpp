#include "engine/cutting/large_block.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/geometry/nearness.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Rings with fewer corners are looked at as a whole.
constexpr std::size_t short_ring = 64;

// A share of areas and second moments that is far above the round-off of a sum over many edges.
constexpr double round_off = 1e-9;

std::vector<int> firsts_of(const NodeRings& rings) {
  std::vector<int> first{0};
  for (const NodeRing& ring : rings) first.push_back(first.back() + static_cast<int>(ring.size()));
  return first;
}

// Least height of a triangle of three corners: the first, the one farthest from it, the one farthest from their line.
double thickness_of(const NodeRing& ring, const CornerPlaces& places) {
  const auto corner = [&](int node) { return places.drawn_position(node); };
  const Vec2 first = corner(ring.front());
  const auto farthest = [&](const auto& measure) {
    return corner(*std::ranges::max_element(ring, {}, [&](int node) { return measure(corner(node)); }));
  };
  const Vec2 second = farthest([&](const Vec2& p) { return (p - first).squaredNorm(); });
  const auto double_area = [&](const Vec2& p) { return std::abs(cross(Vec2(second - first), Vec2(p - first))); };
  const Vec2 third = farthest(double_area);
  const double longest = std::max({(second - first).norm(), (third - first).norm(), (third - second).norm()});
  return longest > 0 ? double_area(third) / longest : 0;
}

}  // namespace

LargeBlock::LargeBlock(const NodeRings& rings, const CornerPlaces& places)
    : rings_(rings), places_(places), edges_(edges_of(rings)), first_(firsts_of(rings)), index_(drawn_boxes()) {
  for (const NodeRing& ring : rings) thickness_.push_back(ring.size() < short_ring ? 0 : thickness_of(ring, places));
  largest_ = largest_coordinate_of(ring_of(rings.front(), places));
  tolerance_ = coordinate_tolerance(largest_);
  is_looked_at_whole_ = !is_sound_as_whole(0);
}

std::vector<LargeBlock::Edge> LargeBlock::edges_of(const NodeRings& rings) {
  std::vector<Edge> edges;
  for (std::size_t ring = 0; ring < rings.size(); ++ring) {
    for (const int node : rings[ring]) edges.push_back({static_cast<int>(ring), node});
  }
  return edges;
}

std::vector<Box> LargeBlock::drawn_boxes() const {
  std::vector<Box> boxes;
  const auto drawn = [&](int edge) { return places_.drawn_position(edges_[at(edge)].node); };
  for (int edge = 0; edge < first_.back(); ++edge) boxes.push_back(edge_box({drawn(edge), drawn(following(edge))}, 0));
  return boxes;
}

bool LargeBlock::is_sound_after(const CornerMove& move) {
  if (is_looked_at_whole_ || !keeps_tolerance(move)) return is_sound_as_whole(0);
  const std::vector<int> corners = corners_at(move);
  if (corners.empty()) return true;
  const auto run = run_of(corners);
  if (!run || repeats_corner(*run, move) || meets_edge(run->in) || meets_edge(run->out)) return false;
  const double swept = swept_by(*run, move.way());
  swept_ += swept;
  if (is_fat(run->ring) && !passes_island(*run, move.way()) && keeps_area()) return true;
  return is_sound_as_whole(swept);
}

// Remembers what is as a whole for the moves that follow. The last one, in which edges swept over `swept` (m2), may
// yet be undone.
bool LargeBlock::is_sound_as_whole(double swept) {
  ++looked_at_whole_;
  const Polygon polygon = polygon_of(rings_, places_);
  if (defect(polygon)) return false;
  const AreaMoments moments = area_moments(polygon);
  const Box box = bounding_box(polygon);
  area_ = moments.area;
  least_moment_ = std::min(moments.xx, moments.yy);
  diagonal_ = (box.upper - box.lower).norm();
  swept_ = swept;
  return true;
}

// Edges that may be there by now, wherever they were drawn.
std::vector<int> LargeBlock::near(const Box& box) const {
  constexpr double round_off_of_ways = 1.001;
  return index_.overlapping(expanded(box, round_off_of_ways * places_.farthest() + tolerance_));
}

std::vector<int> LargeBlock::corners_at(const CornerMove& move) const {
  std::vector<int> corners = near({move.position, move.position});
  std::erase_if(corners, [&](int corner) { return place(corner) != move.into; });
  return corners;
}

// Returns nothing where the outline has the place more than once, or no three corners are left of the ring.
std::optional<LargeBlock::Run> LargeBlock::run_of(const std::vector<int>& corners) const {
  const auto is_there = [&](int corner) { return place(corner) == place(corners.front()); };
  std::size_t size = 1;
  Run run{ring(corners.front()), preceding(corners.front()), corners.front()};
  for (; is_there(run.in) && size <= corners.size(); ++size) run.in = preceding(run.in);
  for (; is_there(following(run.out)) && size <= corners.size(); ++size) run.out = following(run.out);
  if (size != corners.size() || next_of_length(run.out) == run.in) return std::nullopt;
  return run;
}

bool LargeBlock::repeats_corner(const Run& run, const CornerMove& move) const {
  const Box box = vertex_box(move.position, tolerance_);
  return std::ranges::any_of(near(box), [&](int corner) {
    return ring(corner) == run.ring && place(corner) != move.into &&
           overlap(box, vertex_box(segment(corner).start, tolerance_));
  });
}

bool LargeBlock::meets_edge(int edge) const {
  const Box box = edge_box(segment(edge), tolerance_);
  return std::ranges::any_of(near(box), [&](int other) {
    return other != edge && has_length(other) && overlap(box, edge_box(segment(other), tolerance_)) &&
           conflict(std::min(edge, other), std::max(edge, other));
  });
}

bool LargeBlock::conflict(int a, int b) const {
  if (ring(a) == ring(b)) {
    if (next_of_length(a) == b) return folds_back(segment(a), segment(b), tolerance_);
    if (next_of_length(b) == a) return folds_back(segment(b), segment(a), tolerance_);
  }
  return touch(segment(a), segment(b), tolerance_);
}

// What touches is told by the largest coordinate. Where that changes, all of the block counts, from then on.
bool LargeBlock::keeps_tolerance(const CornerMove& move) {
  const auto largest = [](const Vec2& p) { return p.lpNorm<Eigen::Infinity>(); };
  const double now = largest(move.position);
  const double before = std::max(largest(move.one), largest(move.other));
  if (now > largest_ || (now < largest_ && before >= largest_)) is_looked_at_whole_ = true;
  return !is_looked_at_whole_;
}

// Corners within d of a line are corners of triangles no thicker than 2 d.
bool LargeBlock::is_fat(int ring) const {
  if (rings_[at(ring)].size() < short_ring) return !is_flat(ring_of(rings_[at(ring)], places_), tolerance_);
  constexpr double margin = 1.1;
  return thickness_[at(ring)] > margin * 2 * (tolerance_ + places_.farthest());
}

// All that the edges swept over is within `way` of where they are. An island that they did not come by lies inside or
// outside of the other rings as it did.
bool LargeBlock::passes_island(const Run& run, double way) const {
  const double reach = 2 * way + tolerance_;
  const auto is_passed = [&](int edge) {
    const Segment line = segment(edge);
    return std::ranges::any_of(near(edge_box(line, reach)), [&](int other) {
      const int island = ring(other);
      return island > 0 && island != run.ring && other == first_[at(island)] &&
             distance(line, segment(other).start) <= reach;
    });
  };
  return is_passed(run.in) || is_passed(run.out);
}

// m2, at most: the way of each point times the length of the edges, which were longer by no more than their ends moved.
double LargeBlock::swept_by(const Run& run, double way) const {
  const auto length = [&](int edge) { return (segment(edge).end - segment(edge).start).norm(); };
  return way * (length(run.in) + length(run.out) + 4 * way);
}

// No point is farther than the diagonal from the centroid, so the moments about where it was change by no more than
// swept_ diagonal^2, and its own way takes less than as much again where not half of the area is gone.
bool LargeBlock::keeps_area() const {
  const double diagonal = diagonal_ + 2 * places_.farthest();
  const double needed = std::max(4 * swept_, round_off * area_) * diagonal * diagonal;
  return swept_ < area_ / 2 && least_moment_ > needed;
}

int LargeBlock::following(int edge) const {
  return edge + 1 == first_[at(ring(edge)) + 1] ? first_[at(ring(edge))] : edge + 1;
}

int LargeBlock::preceding(int edge) const {
  return edge == first_[at(ring(edge))] ? first_[at(ring(edge)) + 1] - 1 : edge - 1;
}

// Returns the next edge that has a length, and `edge` itself where no other edge of the ring has any.
int LargeBlock::next_of_length(int edge) const {
  int next = following(edge);
  while (next != edge && !has_length(next)) next = following(next);
  return next;
}

Segment LargeBlock::segment(int edge) const {
  return {places_.position(edges_[at(edge)].node), places_.position(edges_[at(following(edge))].node)};
}

}  // namespace dda
