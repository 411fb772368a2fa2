#include "engine/cutting/short_edges.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>

#include "engine/cutting/large_block.h"

namespace dda {
namespace {

// An edge of a block that is shorter than the tolerance.
struct ShortEdge {
  double length = 0;
  int a = 0, b = 0;

  bool operator==(const ShortEdge&) const = default;
};

bool operator<(const ShortEdge& a, const ShortEdge& b) {
  return std::tie(a.length, a.a, a.b) < std::tie(b.length, b.a, b.b);
}

// Corners of a block from which on looking only at what is near a move is quicker than looking at all of the block.
constexpr std::size_t large = 64;

bool is_large(const NodeRings& rings) {
  std::size_t corners = 0;
  for (const NodeRing& ring : rings) corners += ring.size();
  return corners >= large;
}

class ShortEdges {
 public:
  ShortEdges(const Arrangement& arrangement, const Corners& corners, const std::vector<NodeRings>& blocks,
             CornerPlaces& places)
      : arrangement_(arrangement), corners_(corners), blocks_(blocks), places_(places) {}

  void close(double tolerance, std::vector<Cleaned>& cleaned) {
    find(tolerance);
    for (const ShortEdge& edge : edges_) {
      if (is_closed(edge))
        cleaned.push_back({Cleaning::short_edge_closed,
                           arrangement_.position(edge.a),
                           arrangement_.position(edge.b),
                           edge.length,
                           {}});
    }
  }

 private:
  struct Goal {
    int node = 0, into = 0;
    Vec2 position;
  };

  void find(double tolerance) {
    for (const NodeRings& rings : blocks_) {
      for (const NodeRing& ring : rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const auto [a, b] = std::minmax(ring[i], ring[(i + 1) % ring.size()]);
          const double length = (arrangement_.position(a) - arrangement_.position(b)).norm();
          if (length < tolerance) edges_.push_back({length, a, b});
        }
      }
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    if (!edges_.empty()) find_blocks();
  }

  void find_blocks() {
    for (const ShortEdge& edge : edges_) {
      blocks_at_[edge.a];
      blocks_at_[edge.b];
    }
    for (std::size_t block = 0; block < blocks_.size(); ++block) {
      for (const NodeRing& ring : blocks_[block]) {
        for (const int node : ring) {
          const auto found = blocks_at_.find(node);
          if (found != blocks_at_.end()) found->second.push_back(block);
        }
      }
    }
  }

  // Whether the edge could be closed; if not, all is as it was.
  bool is_closed(const ShortEdge& edge) {
    const auto goal = goal_of(places_.node(edge.a), places_.node(edge.b));
    if (!goal) return false;
    std::vector<std::size_t> around = blocks_around(goal->node, goal->into);
    for (const std::size_t block : around) look_at_large(block);
    const CornerMove move{goal->into, goal->position, places_.position(goal->node), places_.position(goal->into)};
    const auto undo = places_.close(goal->node, goal->into, goal->position);
    if (!std::ranges::all_of(around, [&](std::size_t block) { return is_sound(block, move); })) {
      undo();
      return false;
    }
    blocks_at_.at(goal->into) = std::move(around);
    return true;
  }

  // Corners of the boundary stay, and so does what lies on it; inside, two nodes meet half-way.
  [[nodiscard]] std::optional<Goal> goal_of(int a, int b) const {
    if (a == b) return std::nullopt;
    const bool both_on_boundary = corners_.on_boundary(a) && corners_.on_boundary(b);
    if (both_on_boundary && !corners_.on_same_boundary(a, b)) return std::nullopt;
    if (corners_.is_boundary_corner(a) && corners_.is_boundary_corner(b)) return std::nullopt;
    const auto rank = [&](int node) { return corners_.on_boundary(node) + corners_.is_boundary_corner(node); };
    if (rank(a) < rank(b)) std::swap(a, b);
    const Vec2 middle = (places_.position(a) + places_.position(b)) / 2;
    return Goal{b, a, rank(a) > 0 ? places_.position(a) : middle};
  }

  // Lists the blocks at one or both of two nodes, each block once; neither node has become another by now.
  [[nodiscard]] std::vector<std::size_t> blocks_around(int a, int b) const {
    std::vector<std::size_t> around = blocks_at_.at(a);
    const std::vector<std::size_t>& more = blocks_at_.at(b);
    around.insert(around.end(), more.begin(), more.end());
    std::ranges::sort(around);
    around.erase(std::unique(around.begin(), around.end()), around.end());
    return around;
  }

  // To be called before the first of the block's corners moves, so that it is known whether it was sound then.
  void look_at_large(std::size_t block) {
    if (large_.contains(block) || !is_large(blocks_[block])) return;
    large_.emplace(block, std::make_unique<LargeBlock>(blocks_[block], places_));
  }

  [[nodiscard]] bool is_sound(std::size_t block, const CornerMove& move) {
    const auto found = large_.find(block);
    if (found != large_.end()) return found->second->is_sound_after(move);
    return !defect(polygon_of(blocks_[block], places_)).has_value();
  }

  const Arrangement& arrangement_;
  const Corners& corners_;
  const std::vector<NodeRings>& blocks_;
  CornerPlaces& places_;
  std::vector<ShortEdge> edges_;
  std::map<int, std::vector<std::size_t>> blocks_at_;  // by node, with those at nodes that became it
  std::map<std::size_t, std::unique_ptr<LargeBlock>> large_;
};

}  // namespace

void close_short_edges(const Arrangement& arrangement, const Corners& corners, const std::vector<NodeRings>& blocks,
                       double tolerance, CornerPlaces& places, std::vector<Cleaned>& cleaned) {
  ShortEdges(arrangement, corners, blocks, places).close(tolerance, cleaned);
}

}  // namespace dda
