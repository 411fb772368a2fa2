#include "engine/cutting/trace.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <utility>

#include "engine/geometry/segment.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr double share_of_edges = 0.25;  // that a parted corner may move by, of the edges there

Wide double_area(const Arrangement& arrangement, const std::vector<int>& walk) {
  const Pixel& reference = arrangement.pixel(arrangement.origin(walk.front()));
  Wide sum = 0;
  for (const int h : walk)
    sum += cross(arrangement.pixel(arrangement.origin(h)) - reference,
                 arrangement.pixel(arrangement.target(h)) - reference);
  return sum;
}

std::vector<int> walk_from(const Arrangement& arrangement, const FaceGroups& groups, int start) {
  std::vector<int> walk;
  int half_edge = start;
  do {
    walk.push_back(half_edge);
    half_edge = arrangement.next(half_edge);
    while (!is_border(arrangement, groups, half_edge)) half_edge = arrangement.clockwise(half_edge);
  } while (half_edge != start);
  return walk;
}

// Part of a walk that leaves a node with `first` and comes back to it with `last`.
struct Loop {
  int first = 0;
  int last = 0;
};

// Takes walks apart where they come back to a node.
class LoopFinder {
 public:
  explicit LoopFinder(const Arrangement& arrangement)
      : arrangement_(arrangement), place_(at(arrangement.nodes()), -1) {}

  // Appends the loops of `walk` that hang at it, which all go clockwise: around what lies in the loop.
  void append_loops(const std::vector<int>& walk, bool is_outer, std::vector<Loop>& loops) {
    std::vector<int> stack;
    bool any = false;
    for (const int h : walk) {
      place_[at(arrangement_.origin(h))] = static_cast<int>(stack.size());
      stack.push_back(h);
      const int place = place_[at(arrangement_.target(h))];
      if (place < 0 || (place == 0 && h == walk.back())) continue;
      any = true;
      take(std::vector<int>(stack.begin() + place, stack.end()), is_outer, loops);
      for (auto gone = stack.begin() + place; gone != stack.end(); ++gone) place_[at(arrangement_.origin(*gone))] = -1;
      stack.resize(at(place));
    }
    if (any && is_outer && !stack.empty()) take(stack, is_outer, loops);
    for (const int h : walk) place_[at(arrangement_.origin(h))] = -1;
  }

 private:
  // An outer walk has one loop around the block, which stays.
  void take(const std::vector<int>& loop, bool is_outer, std::vector<Loop>& loops) const {
    if (!is_outer || double_area(arrangement_, loop) < 0) loops.push_back({loop.front(), loop.back()});
  }

  const Arrangement& arrangement_;
  std::vector<int> place_;  // of a node on the stack, by node
};

// Into the loop, half-way between its two edges; how far, at most `distance`.
Vec2 way_inside(const Arrangement& arrangement, const Loop& loop, double distance) {
  const int node = arrangement.origin(loop.first);
  const auto away = [&](int half_edge) {
    return Vec2(arrangement.position(arrangement.target(half_edge)) - arrangement.position(node));
  };
  const Vec2 first = away(loop.first);
  const Vec2 last = away(twin(loop.last));
  double clockwise = std::atan2(-cross(first, last), first.dot(last));
  if (clockwise <= 0) clockwise += 2 * std::numbers::pi;
  const double angle = -clockwise / 2;
  const Vec2 unit = first.normalized();
  const double size = std::min(distance, share_of_edges * std::min(first.norm(), last.norm()));
  return size * Vec2(std::cos(angle) * unit.x() - std::sin(angle) * unit.y(),
                     std::sin(angle) * unit.x() + std::cos(angle) * unit.y());
}

}  // namespace

OutlineTracer::OutlineTracer(const Arrangement& arrangement, const FaceGroups& groups)
    : arrangement_(arrangement),
      groups_(groups),
      outline_of_(at(arrangement.faces()), -1),
      seen_(at(arrangement.half_edges()), false) {}

std::vector<Outline> OutlineTracer::trace(const std::vector<int>& half_edges) {
  for (const int h : half_edges) {
    seen_[at(h)] = false;
    outline_of_[at(groups_.of(arrangement_.face(h)))] = -1;
  }
  std::vector<Outline> outlines;
  for (const int h : half_edges) trace_from(h, outlines);
  return outlines;
}

void OutlineTracer::trace_from(int start, std::vector<Outline>& outlines) {
  const int group = groups_.of(arrangement_.face(start));
  if (seen_[at(start)] || group == FaceGroups::outside || !is_border(arrangement_, groups_, start)) return;
  std::vector<int> walk = walk_from(arrangement_, groups_, start);
  for (const int h : walk) seen_[at(h)] = true;
  int& number = outline_of_[at(group)];
  if (number < 0) {
    number = static_cast<int>(outlines.size());
    outlines.push_back({group, {}, {}});
  }
  if (double_area(arrangement_, walk) > 0)
    outlines[at(number)].outer = std::move(walk);
  else
    outlines[at(number)].holes.push_back(std::move(walk));
}

std::vector<Outline> trace_outlines(const Arrangement& arrangement, const FaceGroups& groups) {
  std::vector<int> all(at(arrangement.half_edges()));
  std::iota(all.begin(), all.end(), 0);
  return OutlineTracer(arrangement, groups).trace(all);
}

bool part_touching(Arrangement& arrangement, const std::vector<Outline>& outlines, const PixelGrid& grid,
                   double distance, std::vector<Cleaned>& cleaned) {
  std::vector<Loop> loops;
  LoopFinder finder(arrangement);
  for (const Outline& outline : outlines) {
    finder.append_loops(outline.outer, true, loops);
    for (const auto& hole : outline.holes) finder.append_loops(hole, false, loops);
  }
  for (const Loop& loop : loops) {
    const Vec2 old = arrangement.position(arrangement.origin(loop.first));
    const Vec2 place = old + way_inside(arrangement, loop, distance);
    arrangement.part_node(loop.first, twin(loop.last), place, grid.pixel_of(place));
    cleaned.push_back({Cleaning::touching_parted, old, place, (place - old).norm(), {}});
  }
  return !loops.empty();
}

}  // namespace dda
