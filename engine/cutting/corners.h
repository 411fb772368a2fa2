// Which nodes are corners of blocks, and which may move.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "engine/cutting/face_groups.h"
#include "engine/cutting/line_report.h"

namespace dda {

class Corners {
 public:
  Corners(const Arrangement& arrangement, const FaceGroups& groups, const PlanPieces& pieces, const RockPlan& plan);

  // Nothing but two edges meets in the node, and one straight runs along both and on to the next corners on either
  // side: no block has a corner there.
  [[nodiscard]] bool is_superfluous(int node) const { return superfluous_[at(node)]; }
  [[nodiscard]] bool on_boundary(int node) const { return boundary_edges_[at(node)][0] >= 0; }
  // A corner of the boundary, which stays where it is.
  [[nodiscard]] bool is_boundary_corner(int node) const;
  // Whether both lie on one straight of the boundary.
  [[nodiscard]] bool on_same_boundary(int a, int b) const;

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] bool is_in_line(int node, int edge_a, int edge_b) const;
  [[nodiscard]] std::optional<int> common_straight(int edge_a, int edge_b) const;
  static void note(std::array<int, 3>& edges, int edge);
  void keep_turns(const std::vector<std::array<int, 3>>& borders);
  void follow(int edge, int node, const std::vector<std::array<int, 3>>& borders, std::vector<bool>& seen);
  [[nodiscard]] std::vector<int> straights_of(int edge) const;

  const Arrangement& arrangement_;
  std::vector<std::array<int, 3>> boundary_edges_;  // by node, the first three between rock and outside; -1: none
  std::vector<bool> superfluous_;
};

}  // namespace dda
