// The plane divided by links: half-edges, the faces left of them, and which face lies in which.
//
// Half-edges 2 e and 2 e + 1 are the two directions of edge e; the face of a half-edge is on its left. Every edge
// stays, also one that ends inside a face and has it on both sides: who asks for outlines leaves out edges between
// faces that belong together (trace.h).
#pragma once

#include <span>
#include <vector>

#include "engine/cutting/noding.h"

namespace dda {

inline int twin(int half_edge) { return half_edge ^ 1; }

class Arrangement {
 public:
  explicit Arrangement(Noding noding);

  [[nodiscard]] int edges() const { return static_cast<int>(origin_.size() / 2); }
  [[nodiscard]] int half_edges() const { return static_cast<int>(origin_.size()); }
  [[nodiscard]] int nodes() const { return static_cast<int>(pixels_.size()); }
  [[nodiscard]] int faces() const { return faces_; }  // face 0 is that without end

  [[nodiscard]] int origin(int half_edge) const { return origin_[at(half_edge)]; }
  [[nodiscard]] int target(int half_edge) const { return origin_[at(twin(half_edge))]; }
  [[nodiscard]] int face(int half_edge) const { return face_[at(half_edge)]; }
  // The next half-edge that leaves the same node, turning clockwise.
  [[nodiscard]] int clockwise(int half_edge) const { return clockwise_[at(half_edge)]; }
  // The next half-edge of the face's outline.
  [[nodiscard]] int next(int half_edge) const { return clockwise(twin(half_edge)); }

  [[nodiscard]] const Pixel& pixel(int node) const { return pixels_[at(node)]; }
  [[nodiscard]] const Vec2& position(int node) const { return positions_[at(node)]; }
  [[nodiscard]] double length(int half_edge) const {
    return (position(target(half_edge)) - position(origin(half_edge))).norm();
  }

  // Whether part_node made it; all others lie where they were drawn.
  [[nodiscard]] bool is_parted(int node) const { return node >= drawn_nodes_; }

  // Numbers of the straights along an edge.
  [[nodiscard]] std::span<const int> straights(int edge) const {
    return {straights_.data() + straight_starts_[at(edge)], straights_.data() + straight_starts_[at(edge + 1)]};
  }

  // Gives the half-edges of a node from `first` clockwise to `last` a node of their own at `position`.
  void part_node(int first, int last, const Vec2& position, const Pixel& pixel);

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  void make_edges(const std::vector<Link>& links);
  void sort_around_nodes();
  void find_faces();

  std::vector<Pixel> pixels_;
  std::vector<Vec2> positions_;
  std::vector<int> straights_, straight_starts_;
  std::vector<int> origin_, clockwise_, face_;
  int faces_ = 0;
  int drawn_nodes_ = 0;
};

}  // namespace dda
