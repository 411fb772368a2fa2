#include "engine/contact/covered_corners.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "engine/contact/pair_motion.h"
#include "engine/geometry/segment.h"

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

// Whether they are sorted in.
bool contains(const std::vector<std::pair<int, int>>& pairs, const std::pair<int, int>& pair) {
  return std::binary_search(pairs.begin(), pairs.end(), pair);
}

// The least distance (m) of a vertex from another one on the way that is foreseen for the step.
double least_distance(const Outlines& outlines, int vertex, int other) {
  const Vec2 apart = outlines.current[at(vertex)] - outlines.current[at(other)];
  const Vec2 way = outlines.coming[at(vertex)] - outlines.coming[at(other)];
  const double squared = way.squaredNorm();
  const double share = squared > 0 ? std::clamp(-apart.dot(way) / squared, 0.0, 1.0) : 0;
  return (apart + share * way).norm();
}

// The end of the contact's edge that its vertex is at, or comes past, where the blocks share no more than corners; else
// -1.
int shared_corner(const Outlines& outlines, const VertexContact& contact, double near) {
  const int end = outlines.next[at(contact.edge)];
  for (const int corner : {contact.edge, end})
    if (least_distance(outlines, contact.vertex, corner) <= near && common_length(outlines, contact) <= near)
      return corner;
  return -1;
}

// A corner of a block and the edges that meet there, as increments of the blocks move them.
class MovedCorner {
 public:
  MovedCorner(const Outlines& outlines, int block, int corner, const Vec2& centroid, const Eigen::VectorXd& d) {
    const Vec6 increments = d.segment<6>(6 * block);
    const auto moved = [&](int vertex) -> Vec2 {
      const Vec2& place = outlines.current[at(vertex)];
      return place + displacement_of(increments, place - centroid);
    };
    before_ = moved(outlines.previous[at(corner)]);
    place_ = moved(corner);
    after_ = moved(outlines.next[at(corner)]);
  }

  [[nodiscard]] const Vec2& place() const { return place_; }

  // How deep a point near the corner is in the block, m; negative outside.
  [[nodiscard]] double depth_of(const Vec2& point) const {
    const Vec2 in = place_ - before_, out = after_ - place_;
    const double behind_in = cross(in, point - place_) / in.norm(),
                 behind_out = cross(out, point - place_) / out.norm();
    return cross(in, out) > 0 ? std::min(behind_in, behind_out) : std::max(behind_in, behind_out);
  }

 private:
  Vec2 before_, place_, after_;
};

}  // namespace

std::vector<VertexContact> take_out_covered(const Outlines& outlines, const std::vector<double>& size,
                                            const std::vector<Carrier>& joints,
                                            const std::vector<std::pair<int, int>>& uncovered,
                                            std::vector<VertexContact>& found) {
  std::vector<std::pair<std::size_t, int>> corners;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (contains(uncovered, blocks_of(found[i]))) continue;
    const double near = in_line * std::min(size[at(found[i].edge_block)], size[at(found[i].vertex_block)]);
    const int corner = shared_corner(outlines, found[i], near);
    if (corner >= 0) corners.emplace_back(i, corner);
  }
  std::vector<VertexContact> taken;
  if (corners.empty()) return taken;
  const CoveredCorners covered(outlines, size, joints, found);
  std::vector<char> out(found.size(), 0);
  for (const auto& [i, corner] : corners) {
    if (!covered.cover(found[i], corner)) continue;
    out[i] = 1;
    taken.push_back(found[i]);
  }
  take_out(out, found);
  return taken;
}

std::vector<std::pair<int, int>> pressed_into_each_other(const Outlines& outlines, const std::vector<double>& size,
                                                         const std::vector<VertexContact>& covered, const Model& model,
                                                         const State& state, const Eigen::VectorXd& d) {
  const auto corner_of = [&](int block, int corner) {
    return MovedCorner(outlines, block, corner, current_centroid(model, state, block), d);
  };
  std::vector<std::pair<int, int>> pairs;
  for (const VertexContact& contact : covered) {
    const double near = in_line * std::min(size[at(contact.edge_block)], size[at(contact.vertex_block)]);
    const MovedCorner of_vertex = corner_of(contact.vertex_block, contact.vertex);
    const MovedCorner of_edge = corner_of(contact.edge_block, nearer_end(outlines, contact));
    if (std::max(of_edge.depth_of(of_vertex.place()), of_vertex.depth_of(of_edge.place())) > near)
      pairs.push_back(blocks_of(contact));
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace dda
