#include "engine/contact/entrance_cover.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/geometry/segment.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Tries one block's vertices against another's edges.
class Side {
 public:
  Side(const Outlines& outlines, int vertex_block, int edge_block, const CoverRange& range)
      : outlines_(outlines),
        vertex_block_(vertex_block),
        edge_block_(edge_block),
        reach_(range.reach),
        round_off_(range.round_off),
        farthest_squared_(std::max(range.reach * range.reach, range.depth * range.depth)),
        depth_(range.depth) {}

  void collect(std::vector<Cover>& found) const {
    // Behind one edge of a corner a vertex may be as far past the other one: boxes that end nearer would make contacts
    // depend on the axes.
    const Box near = expanded(outlines_.boxes[at(edge_block_)], std::max(reach_, depth_));
    for (int vertex = outlines_.starts[at(vertex_block_)]; vertex < outlines_.starts[at(vertex_block_) + 1]; ++vertex) {
      const Vec2& point = outlines_.current[at(vertex)];
      if ((point.array() < near.lower.array()).any() || (point.array() > near.upper.array()).any()) continue;
      for (int edge = outlines_.starts[at(edge_block_)]; edge < outlines_.starts[at(edge_block_) + 1]; ++edge)
        try_pair(vertex, edge, found);
    }
  }

 private:
  void try_pair(int vertex, int edge, std::vector<Cover>& found) const {
    const Vec2 along = outlines_.along(edge);
    const Vec2 offset = outlines_.current[at(vertex)] - outlines_.current[at(edge)];
    const double squared = along.squaredNorm();
    const double gap_by_length = cross(offset, along);
    if (gap_by_length * gap_by_length > squared * farthest_squared_) return;
    const double length = outlines_.length_of(edge);
    const double gap = gap_by_length / length;
    const double place = offset.dot(along) / length;
    const double beyond = std::max(-place, place - length);
    if (gap > reach_ || gap < -depth_ || (beyond > 0 && beyond * beyond + gap * gap > reach_ * reach_)) return;
    const Vec2 normal = Vec2(along.y(), -along.x()) / length;
    if (!faces(vertex, normal)) return;
    const bool at_end = beyond >= -round_off_ && beyond <= std::max(round_off_, entrance_slack * std::abs(gap));
    const Vec2 motion = outlines_.coming[at(vertex)] - coming_of(edge, place / length);
    Cover cover{.contact = {edge_block_, vertex_block_, edge, vertex, normal, gap},
                .beyond = at_end ? 0 : beyond,
                .corner = place < length / 2 ? edge : outlines_.next[at(edge)],
                .coming_gap = gap + normal.dot(motion),
                .past = beyond};
    if (gap > 0 && cover.coming_gap < 0) {
      const double met = place + gap / (gap - cover.coming_gap) * motion.dot(along) / length;
      cover.met_past = {-met, met - length};
    }
    found.push_back(cover);
  }

  // The displacement to come of the point at this share of the edge's length, or of the end beyond which it lies, m.
  [[nodiscard]] Vec2 coming_of(int edge, double share) const {
    const Vec2& first = outlines_.coming[at(edge)];
    return first + std::clamp(share, 0.0, 1.0) * (outlines_.coming[at(outlines_.next[at(edge)])] - first);
  }

  // Whether both edges of the vertex leave on the normal's side, but for the slack, and do not face the same way as the
  // edge: a needle's tip passes the first test on both of its sides.
  [[nodiscard]] bool faces(int vertex, const Vec2& normal) const {
    const int before = outlines_.previous[at(vertex)];
    const Vec2 out = outlines_.along(vertex), in = outlines_.along(before);
    const double out_length = outlines_.length_of(vertex), in_length = outlines_.length_of(before);
    if (normal.dot(out) < -entrance_slack * out_length) return false;
    if (normal.dot(in) > entrance_slack * in_length) return false;
    return cross(normal, out) * in_length + cross(normal, in) * out_length < 0;
  }

  const Outlines& outlines_;
  int vertex_block_;
  int edge_block_;
  double reach_;
  double round_off_;
  double farthest_squared_;
  double depth_;
};

}  // namespace

Vec2 normal_of(const Outlines& outlines, int edge) {
  const Vec2 along = outlines.along(edge);
  return Vec2(along.y(), -along.x()).normalized();
}

void find_covers(const Outlines& outlines, int a, int b, const CoverRange& range, std::vector<Cover>& found) {
  found.clear();
  Side(outlines, a, b, range).collect(found);
  Side(outlines, b, a, range).collect(found);
}

}  // namespace dda
