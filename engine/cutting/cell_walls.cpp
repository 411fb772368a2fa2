#include "engine/cutting/cell_walls.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

#include "engine/cutting/cell_size.h"
#include "engine/cutting/delaunay.h"
#include "engine/geometry/segment_crossing.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr int nowhere = -1;

// Where walls end. `edges` are those of the outline on which the node has to stay: none, one, or the two at a corner.
struct Node {
  Vec2 place;
  std::pair<int, int> edges{nowhere, nowhere};

  [[nodiscard]] bool is_corner() const { return edges.second != nowhere; }
  [[nodiscard]] bool is_free() const { return edges.first == nowhere; }
  [[nodiscard]] bool is_on(int edge) const { return edge != nowhere && (edges.first == edge || edges.second == edge); }
};

struct Link {
  int from = 0;
  int to = 0;
};

bool on_one_edge(const Node& a, const Node& b) { return b.is_on(a.edges.first) || b.is_on(a.edges.second); }

class WallGraph {
 public:
  WallGraph(const Polygon& block, const PlanFill& fill) : block_(block), fill_(fill) {
    add_ring(block.outer);
    for (const Ring& hole : block.holes) add_ring(hole);
  }

  int add_node(const Node& node) {
    const int number = static_cast<int>(nodes_.size());
    nodes_.push_back(node);
    same_as_.push_back(number);
    return number;
  }

  // The parts of a wall inside the block. `from` and `to` are nodes at its ends.
  void add_wall(int from, int to) {
    const Segment wall{node(from).place, node(to).place};
    std::vector<std::pair<double, int>> stops{{0, from}, {1, to}};
    for (int edge = 0; edge < static_cast<int>(outline_.size()); ++edge) {
      const auto share = share_at_inner_crossing(wall, outline_[at(edge)]);
      if (!share) continue;
      stops.emplace_back(*share, add_node({point_at(wall, *share), {edge, nowhere}}));
      on_edge_[at(edge)].push_back(stops.back().second);
    }
    std::sort(stops.begin(), stops.end());
    for (std::size_t i = 1; i < stops.size(); ++i) {
      const Vec2 middle = point_at(wall, (stops[i - 1].first + stops[i].first) / 2);
      if (locate(block_, middle) == Location::inside) walls_.push_back({stops[i - 1].second, stops[i].second});
    }
  }

  void close_short_edges(std::vector<Cleaned>& closed) {
    std::vector<Link> edges = stretches();
    edges.insert(edges.end(), walls_.begin(), walls_.end());
    const double longest = fill_.short_edge * fill_.size;
    std::erase_if(edges, [&](const Link& edge) { return length(edge) >= 2 * longest; });
    std::stable_sort(edges.begin(), edges.end(), [&](const Link& a, const Link& b) { return length(a) < length(b); });
    for (bool any = true; any;) {
      any = false;
      for (const Link& edge : edges) any = close_if_short(edge, closed) || any;
    }
  }

  [[nodiscard]] std::vector<Segment> walls() const {
    std::vector<Segment> left;
    std::set<std::pair<int, int>> seen;
    for (const Link& wall : walls_) {
      const auto ends = std::minmax({root(wall.from), root(wall.to)});
      if (ends.first == ends.second || on_one_edge(node(ends.first), node(ends.second))) continue;
      const Segment closed{node(ends.first).place, node(ends.second).place};
      // Ends that were closed at corners of a hole may have drawn the wall into it.
      if (locate(block_, point_at(closed, 0.5)) != Location::inside) continue;
      if (seen.insert(ends).second) left.push_back(closed);
    }
    return left;
  }

 private:
  void add_ring(const Ring& ring) {
    const int first = static_cast<int>(outline_.size());
    const int count = static_cast<int>(ring.size());
    for (int i = 0; i < count; ++i) {
      outline_.push_back({ring[at(i)], ring[at((i + 1) % count)]});
      corners_.push_back(add_node({ring[at(i)], {first + i, first + (i + count - 1) % count}}));
      following_.push_back(first + (i + 1) % count);
    }
    on_edge_.resize(outline_.size());
  }

  // Parts the outline at its corners and where walls end on it.
  [[nodiscard]] std::vector<Link> stretches() const {
    std::vector<Link> links;
    for (std::size_t edge = 0; edge < outline_.size(); ++edge) {
      const Vec2& start = outline_[edge].start;
      std::vector<int> stops{corners_[edge]};
      stops.insert(stops.end(), on_edge_[edge].begin(), on_edge_[edge].end());
      stops.push_back(corners_[at(following_[edge])]);
      std::stable_sort(stops.begin(), stops.end(), [&](int a, int b) {
        return (node(a).place - start).squaredNorm() < (node(b).place - start).squaredNorm();
      });
      for (std::size_t i = 1; i < stops.size(); ++i) links.push_back({stops[i - 1], stops[i]});
    }
    return links;
  }

  bool close_if_short(const Link& edge, std::vector<Cleaned>& closed) {
    int kept = root(edge.from);
    int gone = root(edge.to);
    if (kept == gone) return false;
    const Vec2 from = node(kept).place;
    const Vec2 to = node(gone).place;
    const double size = (to - from).norm();
    if (size >= fill_.short_edge * cell_size(fill_, (from + to) / 2)) return false;
    if (node(gone).is_corner() || node(kept).is_free()) std::swap(kept, gone);
    if (!node(gone).is_free() && !(on_one_edge(node(kept), node(gone)) && !node(gone).is_corner())) return false;
    const bool alike = node(kept).is_free() == node(gone).is_free() && !node(kept).is_corner();
    if (alike) nodes_[at(kept)].place = (from + to) / 2;
    same_as_[at(gone)] = kept;
    closed.push_back({Cleaning::short_edge_closed, from, to, size, fill_.origin});
    return true;
  }

  [[nodiscard]] const Node& node(int i) const { return nodes_[at(i)]; }
  [[nodiscard]] double length(const Link& link) const { return (node(link.from).place - node(link.to).place).norm(); }
  [[nodiscard]] int root(int i) const {
    while (same_as_[at(i)] != i) i = same_as_[at(i)];
    return i;
  }

  const Polygon& block_;
  const PlanFill& fill_;
  std::vector<Node> nodes_;
  std::vector<int> same_as_;
  std::vector<Segment> outline_;
  std::vector<int> corners_;               // by edge of the outline: the node at its start
  std::vector<int> following_;             // by edge: the one after it
  std::vector<std::vector<int>> on_edge_;  // by edge: nodes where walls cross it
  std::vector<Link> walls_;
};

}  // namespace

CellWalls walls_between(const std::vector<Pixel>& sites, const SiteGrid& grid, const Polygon& block,
                        const PlanFill& fill) {
  const Delaunay delaunay(sites);
  WallGraph graph(block, fill);
  std::vector<int> node_of;
  for (const DelaunayTriangle& triangle : delaunay.triangles())
    node_of.push_back(graph.add_node({grid.place_of(delaunay.circumcentre(triangle))}));
  for (int t = 0; t < static_cast<int>(node_of.size()); ++t) {
    const DelaunayTriangle& triangle = delaunay.triangles()[at(t)];
    for (std::size_t i = 0; i < 3; ++i) {
      const bool between_sites =
          delaunay.is_site(triangle.corners[(i + 1) % 3]) && delaunay.is_site(triangle.corners[(i + 2) % 3]);
      if (triangle.beside[i] > t && between_sites) graph.add_wall(node_of[at(t)], node_of[at(triangle.beside[i])]);
    }
  }
  CellWalls result;
  graph.close_short_edges(result.closed);
  result.walls = graph.walls();
  return result;
}

}  // namespace dda
