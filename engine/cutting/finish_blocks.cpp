#include "engine/cutting/finish_blocks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "engine/cutting/block_order.h"
#include "engine/cutting/corners.h"
#include "engine/cutting/line_report.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

using NodeRing = std::vector<int>;
using NodeRings = std::vector<NodeRing>;  // of a block, the outer one first

// Where nodes are in the end: two that are nearer than the tolerance become one.
class Places {
 public:
  explicit Places(const Arrangement& arrangement) : same_as_(at(arrangement.nodes())) {
    std::iota(same_as_.begin(), same_as_.end(), 0);
    for (int node = 0; node < arrangement.nodes(); ++node) positions_.push_back(arrangement.position(node));
  }

  [[nodiscard]] int node(int drawn) const {
    while (same_as_[at(drawn)] != drawn) drawn = same_as_[at(drawn)];
    return drawn;
  }
  [[nodiscard]] const Vec2& position(int drawn) const { return positions_[at(node(drawn))]; }

  // Puts `node` where `into` is, and that at `position`. The answer undoes it.
  auto close(int node, int into, const Vec2& position) {
    auto undo = [this, node, into, old = positions_[at(into)]] {
      same_as_[at(node)] = node;
      positions_[at(into)] = old;
    };
    same_as_[at(node)] = into;
    positions_[at(into)] = position;
    return undo;
  }

 private:
  std::vector<int> same_as_;
  std::vector<Vec2> positions_;
};

NodeRing without_repeats(const NodeRing& ring) {
  NodeRing kept;
  for (const int node : ring) {
    if (kept.empty() || kept.back() != node) kept.push_back(node);
  }
  while (kept.size() > 1 && kept.front() == kept.back()) kept.pop_back();
  return kept;
}

NodeRing in_place(const NodeRing& ring, const Places& places) {
  NodeRing moved;
  for (const int node : ring) moved.push_back(places.node(node));
  return without_repeats(moved);
}

Ring ring_of(const NodeRing& nodes, const Places& places) {
  Ring ring;
  for (const int node : nodes) ring.push_back(places.position(node));
  return ring;
}

Polygon polygon_of(const NodeRings& rings, const Places& places) {
  Polygon polygon;
  polygon.outer = ring_of(in_place(rings.front(), places), places);
  for (std::size_t i = 1; i < rings.size(); ++i) polygon.holes.push_back(ring_of(in_place(rings[i], places), places));
  return polygon;
}

std::vector<NodeRings> rings_of(const Arrangement& arrangement, const std::vector<Outline>& outlines,
                                const Corners& corners) {
  const auto ring = [&](const std::vector<int>& walk) {
    NodeRing nodes;
    for (const int h : walk) {
      if (!corners.is_superfluous(arrangement.origin(h))) nodes.push_back(arrangement.origin(h));
    }
    return nodes;
  };
  std::vector<NodeRings> blocks;
  for (const Outline& outline : outlines) {
    NodeRings& rings = blocks.emplace_back();
    rings.push_back(ring(outline.outer));
    for (const auto& hole : outline.holes) rings.push_back(ring(hole));
  }
  return blocks;
}

// An edge of a block that is shorter than the tolerance.
struct ShortEdge {
  double length = 0;
  int a = 0, b = 0;

  bool operator==(const ShortEdge&) const = default;
};

bool operator<(const ShortEdge& a, const ShortEdge& b) {
  return std::tie(a.length, a.a, a.b) < std::tie(b.length, b.a, b.b);
}

class ShortEdges {
 public:
  ShortEdges(const Arrangement& arrangement, const Corners& corners, const std::vector<NodeRings>& blocks,
             double tolerance)
      : arrangement_(arrangement), corners_(corners), blocks_(blocks), tolerance_(tolerance) {}

  void close(Places& places, std::vector<Cleaned>& cleaned) {
    find();
    for (const ShortEdge& edge : edges_) {
      const auto goal = goal_of(places.node(edge.a), places.node(edge.b), places);
      if (!goal) continue;
      const auto undo = places.close(goal->node, goal->into, goal->position);
      if (!all_sound(edge, places)) {
        undo();
        continue;
      }
      cleaned.push_back(
          {Cleaning::short_edge_closed, arrangement_.position(edge.a), arrangement_.position(edge.b), edge.length, {}});
    }
  }

 private:
  struct Goal {
    int node = 0, into = 0;
    Vec2 position;
  };

  void find() {
    for (const NodeRings& rings : blocks_) {
      for (const NodeRing& ring : rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const auto [a, b] = std::minmax(ring[i], ring[(i + 1) % ring.size()]);
          const double length = (arrangement_.position(a) - arrangement_.position(b)).norm();
          if (length < tolerance_) edges_.push_back({length, a, b});
        }
      }
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    if (edges_.empty()) return;
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

  // Corners of the boundary stay, and so does what lies on it; inside, two nodes meet half-way.
  [[nodiscard]] std::optional<Goal> goal_of(int a, int b, const Places& places) const {
    if (a == b) return std::nullopt;
    const bool both_on_boundary = corners_.on_boundary(a) && corners_.on_boundary(b);
    if (both_on_boundary && !corners_.on_same_boundary(a, b)) return std::nullopt;
    if (corners_.is_boundary_corner(a) && corners_.is_boundary_corner(b)) return std::nullopt;
    const auto rank = [&](int node) { return corners_.on_boundary(node) + corners_.is_boundary_corner(node); };
    if (rank(a) < rank(b)) std::swap(a, b);
    const Vec2 middle = (places.position(a) + places.position(b)) / 2;
    return Goal{b, a, rank(a) > 0 ? places.position(a) : middle};
  }

  // Most blocks at one end of a short edge are at the other too; each is asked once.
  [[nodiscard]] bool all_sound(const ShortEdge& edge, const Places& places) const {
    std::vector<std::size_t> around = blocks_at_.at(edge.a);
    const std::vector<std::size_t>& more = blocks_at_.at(edge.b);
    around.insert(around.end(), more.begin(), more.end());
    std::ranges::sort(around);
    around.erase(std::unique(around.begin(), around.end()), around.end());
    return std::ranges::none_of(
        around, [&](std::size_t block) { return defect(polygon_of(blocks_[block], places)).has_value(); });
  }

  const Arrangement& arrangement_;
  const Corners& corners_;
  const std::vector<NodeRings>& blocks_;
  double tolerance_;
  std::vector<ShortEdge> edges_;
  std::map<int, std::vector<std::size_t>> blocks_at_;
};

void fill_blocks(const std::vector<NodeRings>& rings, const Places& places, const std::vector<Outline>& outlines,
                 const std::vector<FacePlace>& face_places, CutRock& rock) {
  for (std::size_t i = 0; i < rings.size(); ++i) {
    CutBlock block;
    block.shape = polygon_of(rings[i], places);
    block.opening = face_places[at(outlines[i].group)].opening;
    rock.blocks.push_back(std::move(block));
  }
  put_in_order(rock.blocks);
}

// An edge between blocks, along a straight.
struct Contact {
  int straight = 0;
  double way = 0;
  int from = 0, to = 0;
};

std::vector<Contact> contacts_of(const Arrangement& arrangement, const FaceGroups& groups, const PlanPieces& pieces,
                                 const RockPlan& plan) {
  std::vector<Contact> contacts;
  for (int edge = 0; edge < arrangement.edges(); ++edge) {
    const int left = groups.of(arrangement.face(2 * edge));
    const int right = groups.of(arrangement.face(2 * edge + 1));
    if (left == right || left == FaceGroups::outside || right == FaceGroups::outside) continue;
    const int straight = counting_straight(arrangement, edge, pieces, plan);
    const Straight& line = pieces.straights[at(straight)];
    const auto way = [&](int node) { return (line.to - line.from).dot(arrangement.position(node) - line.from); };
    int from = arrangement.origin(2 * edge);
    int to = arrangement.target(2 * edge);
    if (way(from) > way(to)) std::swap(from, to);
    contacts.push_back({straight, way(from), from, to});
  }
  std::sort(contacts.begin(), contacts.end(), [](const Contact& a, const Contact& b) {
    return std::tuple(a.straight, a.way, a.from) < std::tuple(b.straight, b.way, b.from);
  });
  return contacts;
}

// Those that no corner of a block parts are one.
std::vector<Contact> along_edges(const std::vector<Contact>& contacts, const Corners& corners) {
  std::vector<Contact> edges;
  for (const Contact& contact : contacts) {
    const bool goes_on = !edges.empty() && edges.back().straight == contact.straight &&
                         edges.back().to == contact.from && corners.is_superfluous(contact.from);
    if (goes_on)
      edges.back().to = contact.to;
    else
      edges.push_back(contact);
  }
  return edges;
}

// m, by which nodes of a run may lie beside its straight: twice what welding moves them with the default tolerance, and
// a fifth of what scenes allow a joint line to leave the blocks along it (point_tolerance).
double aside_allowed(const RockPlan& plan) {
  constexpr double of_diagonal = 2e-8;
  const Box box = bounding_box(plan.boundary);
  return of_diagonal * (box.upper - box.lower).norm();
}

// Contacts that follow each other on a straight make one run, unless a node of theirs is not quite on it any more: a
// run from a node that moved aside to one far away would pass those between.
void fill_joints(const std::vector<Contact>& contacts, const Places& places, const PlanPieces& pieces,
                 const RockPlan& plan, CutRock& rock) {
  const double aside = aside_allowed(plan);
  const auto is_on_straight = [&](int node, int straight) {
    const Straight& line = pieces.straights[at(straight)];
    const Vec2 along = (line.to - line.from).normalized();
    return std::abs(cross(along, places.position(node) - line.from)) <= aside;
  };
  for (std::size_t first = 0, last = 0; first < contacts.size(); first = last + 1) {
    last = first;
    const auto goes_on = [&](const Contact& each, const Contact& next) {
      return next.straight == each.straight && next.from == each.to && is_on_straight(each.from, each.straight) &&
             is_on_straight(each.to, each.straight) && is_on_straight(next.to, each.straight);
    };
    while (last + 1 < contacts.size() && goes_on(contacts[last], contacts[last + 1])) ++last;
    const int from = places.node(contacts[first].from);
    const int to = places.node(contacts[last].to);
    if (from == to) continue;  // a short edge that was closed
    rock.joints.push_back(
        {places.position(from), places.position(to), joint_of(pieces.sources[at(contacts[first].straight)], plan)});
  }
}

}  // namespace

void finish_blocks(const Arrangement& arrangement, const FaceGroups& groups, const std::vector<FacePlace>& face_places,
                   const std::vector<Outline>& outlines, const PlanPieces& pieces, const RockPlan& plan,
                   CutRock& rock) {
  const Corners corners(arrangement, groups, pieces, plan);
  const std::vector<NodeRings> rings = rings_of(arrangement, outlines, corners);
  Places places(arrangement);
  ShortEdges(arrangement, corners, rings, rock.tolerance).close(places, rock.cleaned);
  fill_blocks(rings, places, outlines, face_places, rock);
  fill_joints(along_edges(contacts_of(arrangement, groups, pieces, plan), corners), places, pieces, plan, rock);
}

}  // namespace dda
