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
