#include "dda/contact/vertex_contact.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// One block's vertices against another's edges.
class Side {
 public:
  Side(const Outlines& outlines, int vertex_block, int edge_block, double reach, double depth)
      : outlines_(outlines), vertex_block_(vertex_block), edge_block_(edge_block), reach_(reach), depth_(depth) {}

  void collect(std::vector<VertexContact>& found) const {
    const Box near = expanded(outlines_.boxes[at(edge_block_)], reach_);
    for (int vertex = first(vertex_block_); vertex < last(vertex_block_); ++vertex) {
      const Vec2& point = outlines_.current[at(vertex)];
      if ((point.array() < near.lower.array()).any() || (point.array() > near.upper.array()).any()) continue;
      for (int edge = first(edge_block_); edge < last(edge_block_); ++edge) try_pair(vertex, edge, found);
    }
  }

 private:
  [[nodiscard]] int first(int block) const { return outlines_.starts[at(block)]; }
  [[nodiscard]] int last(int block) const { return outlines_.starts[at(block) + 1]; }

  void try_pair(int vertex, int edge, std::vector<VertexContact>& found) const {
    const Vec2& start = outlines_.current[at(edge)];
    const Vec2 along = outlines_.current[at(outlines_.next[at(edge)])] - start;
    const Vec2 offset = outlines_.current[at(vertex)] - start;
    const double length = along.norm();
    const double place = offset.dot(along) / length;
    if (place < 0 || place > length) return;
    const Vec2 normal = Vec2(along.y(), -along.x()) / length;
    const double gap = offset.dot(normal);
    if (gap > reach_ || gap < -depth_ || !enters(vertex, normal)) return;
    found.push_back({edge_block_, vertex_block_, edge, vertex, normal, gap});
  }

  [[nodiscard]] bool enters(int vertex, const Vec2& normal) const {
    const Vec2& point = outlines_.current[at(vertex)];
    const auto stays_outside = [&](int neighbour) {
      const Vec2 edge = outlines_.current[at(neighbour)] - point;
      return normal.dot(edge) >= -entrance_slack * edge.norm();
    };
    return stays_outside(outlines_.next[at(vertex)]) && stays_outside(outlines_.previous[at(vertex)]);
  }

  const Outlines& outlines_;
  int vertex_block_;
  int edge_block_;
  double reach_;
  double depth_;
};

// The vertex of the edge's block at which this contact lies, or -1 when it is away from both ends.
int corner_met(const Outlines& outlines, const VertexContact& contact, double corner) {
  const Vec2& point = outlines.current[at(contact.vertex)];
  for (const int end : {contact.edge, outlines.next[at(contact.edge)]})
    if ((outlines.current[at(end)] - point).squaredNorm() <= corner * corner) return end;
  return -1;
}

// Among contacts of the same two corners, keeps the first with the largest gap.
void keep_one_a_corner(const Outlines& outlines, double corner, std::size_t first, std::vector<VertexContact>& found) {
  const auto corners = [&](const VertexContact& contact) {
    const int other = corner_met(outlines, contact, corner);
    return std::pair(std::min(contact.vertex, other), std::max(contact.vertex, other));
  };
  for (std::size_t i = first; i < found.size(); ++i) {
    if (corner_met(outlines, found[i], corner) < 0) continue;
    for (std::size_t j = found.size() - 1; j > i; --j) {
      if (corners(found[j]) != corners(found[i])) continue;
      if (found[j].gap > found[i].gap) std::swap(found[i], found[j]);
      found.erase(found.begin() + static_cast<std::ptrdiff_t>(j));
    }
  }
}

}  // namespace

void find_vertex_contacts(const Outlines& outlines, int a, int b, double reach, double depth, double corner,
                          std::vector<VertexContact>& found) {
  const std::size_t first = found.size();
  Side(outlines, a, b, reach, depth).collect(found);
  Side(outlines, b, a, reach, depth).collect(found);
  if (found.size() - first > 1) keep_one_a_corner(outlines, corner, first, found);
}

}  // namespace dda
