#include "engine/contact/covered_corners.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// A corner of a block, and its edge that the contact in question does not have to do with.
struct Corner {
  int block;
  Vec2 point;
  Vec2 side_normal;  // unit, outwards
};

class CoveredCorners {
 public:
  CoveredCorners(const Outlines& outlines, const std::vector<double>& size, const std::vector<Carrier>& joints,
                 const std::vector<VertexContact>& found)
      : outlines_(outlines), size_(size), carriers_(joints) {
    for (const VertexContact& contact : found)
      carriers_.push_back({contact.edge_block, contact.vertex_block, outlines.current[at(contact.vertex)],
                           contact.normal, contact.gap});
    for (std::size_t i = 0; i < carriers_.size(); ++i) {
      by_block_.emplace_back(carriers_[i].block_a, i);
      by_block_.emplace_back(carriers_[i].block_b, i);
    }
    std::sort(by_block_.begin(), by_block_.end());
  }

  // `end`: vertex of the contact's edge that the contact's vertex is near.
  [[nodiscard]] bool cover(const VertexContact& contact, int end) const {
    const Corner of_edge{contact.edge_block, outlines_.current[at(end)],
                         normal_of(end == contact.edge ? outlines_.previous[at(end)] : end)};
    const int facing = facing_edge(outlines_, contact);
    const Corner of_vertex{
        contact.vertex_block, outlines_.current[at(contact.vertex)],
        normal_of(facing == contact.vertex ? outlines_.previous[at(contact.vertex)] : contact.vertex)};
    return is_carried_in_line(of_vertex, of_edge) || is_carried_in_line(of_edge, of_vertex);
  }

 private:
  [[nodiscard]] Vec2 normal_of(int edge) const {
    const Vec2 along = outlines_.along(edge);
    return Vec2(along.y(), -along.x()).normalized();
  }

  // Whether a third block carries the first corner's one there, on a surface in line with the other corner's side.
  [[nodiscard]] bool is_carried_in_line(const Corner& corner, const Corner& other) const {
    const double depth = (corner.point - other.point).dot(other.side_normal);
    const double near = in_line * std::min(size_[at(corner.block)], size_[at(other.block)]);
    const auto first = std::lower_bound(by_block_.begin(), by_block_.end(), std::pair{corner.block, std::size_t{0}});
    for (auto each = first; each != by_block_.end() && each->first == corner.block; ++each) {
      const Carrier& carrier = carriers_[each->second];
      const bool is_b = carrier.block_b == corner.block;
      if ((is_b ? carrier.block_a : carrier.block_b) == other.block) continue;
      if ((is_b ? 1 : -1) * carrier.normal.dot(other.side_normal) < same_direction) continue;
      if (std::abs(depth - carrier.gap) <= near && (carrier.point - corner.point).norm() <= 2 * near) return true;
    }
    return false;
  }

  const Outlines& outlines_;
  const std::vector<double>& size_;
  std::vector<Carrier> carriers_;
  std::vector<std::pair<int, std::size_t>> by_block_;
};

// The end of the contact's edge that its vertex is at, where the blocks share no more than corners; else -1.
int shared_corner(const Outlines& outlines, const VertexContact& contact, double near) {
  const int end = outlines.next[at(contact.edge)];
  const Vec2& vertex = outlines.current[at(contact.vertex)];
  for (const int corner : {contact.edge, end})
    if ((outlines.current[at(corner)] - vertex).norm() <= near && common_length(outlines, contact) <= near)
      return corner;
  return -1;
}

}  // namespace

void take_out_covered(const Outlines& outlines, const std::vector<double>& size, const std::vector<Carrier>& joints,
                      std::vector<VertexContact>& found) {
  std::vector<std::pair<std::size_t, int>> corners;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double near = in_line * std::min(size[at(found[i].edge_block)], size[at(found[i].vertex_block)]);
    const int corner = shared_corner(outlines, found[i], near);
    if (corner >= 0) corners.emplace_back(i, corner);
  }
  if (corners.empty()) return;
  const CoveredCorners covered(outlines, size, joints, found);
  std::vector<char> out(found.size(), 0);
  for (const auto& [i, corner] : corners) out[i] = covered.cover(found[i], corner) ? 1 : 0;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < found.size(); ++i)
    if (out[i] == 0) found[kept++] = found[i];
  found.resize(kept);
}

}  // namespace dda
