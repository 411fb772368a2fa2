#include "engine/cutting/merging.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "engine/geometry/segment.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

struct Shape {
  double area = 0;
  double perimeter = 0;
  double sharpest = std::numeric_limits<double>::infinity();  // rad, between two edges
};

// Adds a ring of an outline; areas of holes count negative because they run clockwise.
void add_ring(const Arrangement& arrangement, const std::vector<int>& ring, Shape& shape) {
  const Vec2& reference = arrangement.position(arrangement.origin(ring.front()));
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 from = arrangement.position(arrangement.origin(ring[i])) - reference;
    const Vec2 to = arrangement.position(arrangement.target(ring[i])) - reference;
    const int following = ring[(i + 1) % ring.size()];
    const Vec2 back = from - to;
    const Vec2 on = arrangement.position(arrangement.target(following)) - reference - to;
    shape.area += cross(from, to) / 2;
    shape.perimeter += back.norm();
    double angle = std::atan2(cross(on, back), on.dot(back));
    if (angle < 0) angle = std::numeric_limits<double>::infinity();  // more than half a turn
    shape.sharpest = std::min(shape.sharpest, angle);
  }
}

Shape shape_of(const Arrangement& arrangement, const Outline& outline) {
  Shape shape;
  add_ring(arrangement, outline.outer, shape);
  for (const auto& hole : outline.holes) add_ring(arrangement, hole, shape);
  return shape;
}

std::optional<Cleaning> fault(const Shape& shape, const MergeLimits& limits) {
  if (2 * shape.area <= limits.width * shape.perimeter) return Cleaning::sliver_merged;  // also without extent
  if (shape.area < limits.area) return Cleaning::small_block_merged;
  if (shape.sharpest < limits.angle) return Cleaning::sharp_block_merged;
  return std::nullopt;
}

struct Faulty {
  const Outline* outline = nullptr;
  double area = 0;
  Cleaning why = Cleaning::sliver_merged;
};

class Merger {
 public:
  Merger(const Arrangement& arrangement, const std::vector<FacePlace>& places, const MergeLimits& limits,
         FaceGroups& groups)
      : arrangement_(arrangement), places_(places), limits_(limits), groups_(groups) {}

  // After the first round only outlines of blocks that took part in a merger are traced again, at once where they could
  // have a fault.
  Merging run() {
    OutlineTracer tracer(arrangement_, groups_);
    std::vector<int> all(at(arrangement_.half_edges()));
    std::iota(all.begin(), all.end(), 0);
    blocks_ = traced(tracer, all);
    std::vector<bool> touched(at(arrangement_.faces()), false);
    while (merge_once(touched)) {
      trace_again(tracer, touched);
      touched.assign(touched.size(), false);
    }
    trace_grown(tracer);
    for (Block& block : blocks_) {
      if (!block.is_gone) result_.outlines.push_back(std::move(block.outline));
    }
    return std::move(result_);
  }

 private:
  struct Block {
    Outline outline;
    double area = 0;
    double perimeter = 0;  // m; of a block that grew, at most
    std::optional<Cleaning> fault;
    std::vector<int> grown;  // half-edges, of a block that grew and is traced at the end: its outline is among them
    bool is_gone = false;

    // The first of its half-edges: walks begin with theirs, and are traced in that order.
    [[nodiscard]] int first() const {
      return outline.holes.empty() ? outline.outer.front()
                                   : std::min(outline.outer.front(), outline.holes.front().front());
    }
  };

  std::vector<Block> traced(OutlineTracer& tracer, const std::vector<int>& half_edges) {
    std::vector<Block> blocks;
    for (Outline& outline : tracer.trace(half_edges)) {
      const Shape shape = shape_of(arrangement_, outline);
      blocks.push_back({std::move(outline), shape.area, shape.perimeter, fault(shape, limits_), {}, false});
      ++result_.traced;
    }
    return blocks;
  }

  static void append_outline(const Outline& outline, std::vector<int>& half_edges) {
    half_edges.insert(half_edges.end(), outline.outer.begin(), outline.outer.end());
    for (const auto& hole : outline.holes) half_edges.insert(half_edges.end(), hole.begin(), hole.end());
  }

  static void append_half_edges(const Block& block, std::vector<int>& half_edges) {
    if (block.grown.empty())
      append_outline(block.outline, half_edges);
    else
      half_edges.insert(half_edges.end(), block.grown.begin(), block.grown.end());
  }

  // Whether the two together have no fault, whatever the outline of both is: its length is no more than that of the
  // two. Twice the limits leaves room for round-off. Corners are known only when they are traced.
  [[nodiscard]] bool are_sound_together(const Block& a, const Block& b) const {
    const double area = (a.area + b.area) / 2;
    return limits_.angle <= 0 && area >= limits_.area && 2 * area > limits_.width * (a.perimeter + b.perimeter);
  }

  // A large block takes in one sliver after the other, a round each; its outline is needed at the end only.
  static void grow(Block& block, const Block& taken) {
    if (block.grown.empty()) append_outline(block.outline, block.grown);
    append_half_edges(taken, block.grown);
    block.area += taken.area;
    block.perimeter += taken.perimeter;
    block.fault.reset();
  }

  // A block that took in another. Without neighbour a sliver goes outside, where nothing is traced.
  struct Pair {
    Block* whole = nullptr;
    Block* part = nullptr;
  };

  [[nodiscard]] std::map<int, Pair> pairs_of(const std::vector<bool>& touched) {
    std::map<int, Pair> pairs;  // by group
    for (Block& block : blocks_) {
      const int own = block.outline.group;
      if (!touched[at(own)]) continue;
      const int now = groups_.of(own);
      block.is_gone = now != own;
      if (block.is_gone) block.fault.reset();
      if (now != FaceGroups::outside) (block.is_gone ? pairs[now].part : pairs[now].whole) = &block;
    }
    return pairs;
  }

  void trace_again(OutlineTracer& tracer, const std::vector<bool>& touched) {
    std::vector<int> half_edges;
    for (auto& [group, pair] : pairs_of(touched)) {
      if (are_sound_together(*pair.whole, *pair.part)) {
        grow(*pair.whole, *pair.part);
        continue;
      }
      pair.whole->is_gone = true;
      append_half_edges(*pair.whole, half_edges);
      append_half_edges(*pair.part, half_edges);
    }
    put_in(tracer, std::move(half_edges));
  }

  void trace_grown(OutlineTracer& tracer) {
    std::vector<int> half_edges;
    for (Block& block : blocks_) {
      if (block.is_gone || block.grown.empty()) continue;
      block.is_gone = true;
      append_half_edges(block, half_edges);
    }
    put_in(tracer, std::move(half_edges));
  }

  // Those traced from the half-edges, in place of what is gone.
  void put_in(OutlineTracer& tracer, std::vector<int> half_edges) {
    if (half_edges.empty()) return;
    std::erase_if(blocks_, [](const Block& block) { return block.is_gone; });
    std::sort(half_edges.begin(), half_edges.end());
    std::vector<Block> again = traced(tracer, half_edges);
    std::vector<Block> kept = std::exchange(blocks_, {});
    std::merge(std::move_iterator(kept.begin()), std::move_iterator(kept.end()), std::move_iterator(again.begin()),
               std::move_iterator(again.end()), std::back_inserter(blocks_),
               [](const Block& a, const Block& b) { return a.first() < b.first(); });
  }

  bool merge_once(std::vector<bool>& touched) {
    std::vector<Faulty> faulty;
    for (const Block& block : blocks_) {
      if (block.fault) faulty.push_back({&block.outline, block.area, *block.fault});
    }
    std::stable_sort(faulty.begin(), faulty.end(), [](const Faulty& a, const Faulty& b) { return a.area < b.area; });
    bool changed = false;
    for (const Faulty& each : faulty) changed = merge(each, touched) || changed;
    return changed;
  }

  // One block takes part in one merger at a time: its outline is known only before.
  bool merge(const Faulty& faulty, std::vector<bool>& touched) {
    const int group = faulty.outline->group;
    if (touched[at(group)]) return true;
    const auto neighbour = best_neighbour(*faulty.outline);
    if (neighbour && touched[at(*neighbour)]) return true;
    if (!neighbour && faulty.why != Cleaning::sliver_merged) return false;
    note(faulty, neighbour.has_value());
    const int into = neighbour.value_or(FaceGroups::outside);
    touched[at(group)] = true;
    if (neighbour) touched[at(into)] = true;
    groups_.merge(into, group);
    return true;
  }

  void note(const Faulty& faulty, bool has_neighbour) {
    const Vec2 place = arrangement_.position(arrangement_.origin(faulty.outline->outer.front()));
    const Cleaning what = has_neighbour ? faulty.why : Cleaning::sliver_dropped;
    result_.cleaned.push_back({what, place, place, faulty.area, {}});
    if (has_neighbour)
      ++result_.merged;
    else
      result_.dropped_area += faulty.area;
  }

  [[nodiscard]] std::optional<int> best_neighbour(const Outline& outline) const {
    std::map<int, double> shared;
    const auto add = [&](const std::vector<int>& ring) {
      for (const int h : ring) shared[groups_.of(arrangement_.face(twin(h)))] += arrangement_.length(h);
    };
    add(outline.outer);
    for (const auto& hole : outline.holes) add(hole);
    shared.erase(FaceGroups::outside);
    if (shared.empty()) return std::nullopt;
    const int opening = places_[at(outline.group)].opening;
    const auto rank = [&](const auto& each) {
      return std::tuple(places_[at(each.first)].opening == opening, each.second);
    };
    return std::max_element(shared.begin(), shared.end(),
                            [&](const auto& a, const auto& b) { return rank(a) < rank(b); })
        ->first;
  }

  const Arrangement& arrangement_;
  const std::vector<FacePlace>& places_;
  const MergeLimits& limits_;
  FaceGroups& groups_;
  std::vector<Block> blocks_;  // by the first of their half-edges
  Merging result_;
};

}  // namespace

Merging merge_blocks(const Arrangement& arrangement, const std::vector<FacePlace>& places, const MergeLimits& limits,
                     FaceGroups& groups) {
  return Merger(arrangement, places, limits, groups).run();
}

}  // namespace dda
