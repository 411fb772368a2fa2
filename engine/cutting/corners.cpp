#include "engine/cutting/corners.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "engine/geometry/segment.h"

namespace dda {

Corners::Corners(const Arrangement& arrangement, const FaceGroups& groups, const PlanPieces& pieces,
                 const RockPlan& plan)
    : arrangement_(arrangement),
      boundary_edges_(at(arrangement.nodes()), {-1, -1, -1}),
      superfluous_(at(arrangement.nodes()), false) {
  std::vector<std::array<int, 3>> borders(at(arrangement.nodes()), {-1, -1, -1});
  for (int edge = 0; edge < arrangement.edges(); ++edge) {
    const int left = groups.of(arrangement.face(2 * edge));
    const int right = groups.of(arrangement.face(2 * edge + 1));
    if (left == right) continue;
    for (const int node : {arrangement.origin(2 * edge), arrangement.target(2 * edge)}) {
      note(borders[at(node)], edge);
      if (left == FaceGroups::outside || right == FaceGroups::outside) note(boundary_edges_[at(node)], edge);
    }
  }
  const auto joint = [&](int edge) -> const std::string& {
    return joint_of(pieces.sources[at(counting_straight(arrangement, edge, pieces, plan))], plan);
  };
  for (int node = 0; node < arrangement.nodes(); ++node) {
    const auto& [one, other, third] = borders[at(node)];
    if (other < 0 || third >= 0 || arrangement.is_parted(node)) continue;
    const auto straight = common_straight(one, other);
    if (!straight) continue;
    superfluous_[at(node)] = on_boundary(node) ? is_bound(pieces, *straight, plan) || is_in_line(node, one, other)
                                               : joint(one) == joint(other);
  }
  keep_turns(borders);
}

// Two edges may share one straight and the next two another, where a line that ends beside one that goes on runs along
// it for a little: a border that had no corner there would leave both of them, by as much as they part further on.
void Corners::keep_turns(const std::vector<std::array<int, 3>>& borders) {
  std::vector<bool> seen(at(arrangement_.edges()), false);
  const auto is_border = [&](int edge, int node) {
    const auto& around = borders[at(node)];
    return std::find(around.begin(), around.end(), edge) != around.end();
  };
  for (int edge = 0; edge < arrangement_.edges(); ++edge) {
    const int from = arrangement_.origin(2 * edge);
    const int to = arrangement_.target(2 * edge);
    if (superfluous_[at(from)] != superfluous_[at(to)]) {
      const int first = superfluous_[at(from)] ? from : to;
      if (is_border(edge, first)) follow(edge, first, borders, seen);
    }
  }
}

// Walks along a border from `edge`, which goes from a corner to `node`.
void Corners::follow(int edge, int node, const std::vector<std::array<int, 3>>& borders, std::vector<bool>& seen) {
  if (seen[at(edge)]) return;
  std::vector<int> common = straights_of(edge);
  while (superfluous_[at(node)]) {
    const auto& [one, other, third] = borders[at(node)];
    edge = edge == one ? other : one;
    seen[at(edge)] = true;
    const std::vector<int> here = straights_of(edge);
    std::erase_if(common, [&](int each) { return std::find(here.begin(), here.end(), each) == here.end(); });
    if (common.empty()) {
      superfluous_[at(node)] = false;
      common = here;
    }
    const int from = arrangement_.origin(2 * edge);
    node = from == node ? arrangement_.target(2 * edge) : from;
  }
}

std::vector<int> Corners::straights_of(int edge) const {
  const auto straights = arrangement_.straights(edge);
  return {straights.begin(), straights.end()};
}

// Beside openings that are left out, whose outlines may turn a little where they were led through a node.
bool Corners::is_in_line(int node, int edge_a, int edge_b) const {
  constexpr double few_ulps = 16 * std::numeric_limits<double>::epsilon();
  const auto other_end = [&](int edge) {
    const int origin = arrangement_.origin(2 * edge);
    return arrangement_.position(origin == node ? arrangement_.target(2 * edge) : origin);
  };
  const Vec2& place = arrangement_.position(node);
  return distance({other_end(edge_a), other_end(edge_b)}, place) <= few_ulps * place.cwiseAbs().maxCoeff();
}

void Corners::note(std::array<int, 3>& edges, int edge) {
  const auto free = std::find(edges.begin(), edges.end(), -1);
  if (free != edges.end()) *free = edge;
}

std::optional<int> Corners::common_straight(int edge_a, int edge_b) const {
  const auto a = arrangement_.straights(edge_a);
  const auto b = arrangement_.straights(edge_b);
  const auto found = std::find_first_of(a.begin(), a.end(), b.begin(), b.end());
  return found == a.end() ? std::nullopt : std::optional(*found);
}

bool Corners::is_boundary_corner(int node) const {
  const auto& [one, other, third] = boundary_edges_[at(node)];
  return one >= 0 && (other < 0 || third >= 0 || !common_straight(one, other));
}

bool Corners::on_same_boundary(int a, int b) const {
  for (const int one : boundary_edges_[at(a)]) {
    for (const int other : boundary_edges_[at(b)]) {
      if (one >= 0 && other >= 0 && common_straight(one, other)) return true;
    }
  }
  return false;
}

}  // namespace dda
