#include "engine/contact/interface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "engine/contact/surface_joints.h"
#include "engine/geometry/box.h"
#include "engine/geometry/box_pairs.h"
#include "engine/geometry/edge_index.h"
#include "engine/geometry/nearness.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

// An edge of a block's outline or of one of its holes, material on its left.
struct Edge {
  Segment segment;
  Box box;
};

// The edges of all blocks, one block after the other.
class Edges {
 public:
  explicit Edges(const Model& model) {
    starts_.reserve(model.blocks.size() + 1);
    starts_.push_back(0);
    for (const Block& block : model.blocks) {
      for_each_edge(block.shape, [&](const Segment& edge) {
        edges_.push_back({edge, edge_box(edge, model.length_tolerance)});
      });
      starts_.push_back(edges_.size());
    }
  }

  [[nodiscard]] std::span<const Edge> of(int block) const {
    const auto i = static_cast<std::size_t>(block);
    return std::span(edges_).subspan(starts_[i], starts_[i + 1] - starts_[i]);
  }

 private:
  std::vector<Edge> edges_;
  std::vector<std::size_t> starts_;  // one a block, and the end
};

Vec2 outward_normal(const Segment& edge) {
  const Vec2 along = (edge.end - edge.start).normalized();
  return {along.y(), -along.x()};
}

// Collects the interfaces of one pair of blocks.
class PairSearch {
 public:
  PairSearch(const Model& model, int block_a, int block_b, const Edges& edges, const JointLines& lines)
      : model_(model),
        lines_(lines),
        a_(block_a),
        b_(block_b),
        edges_a_(edges.of(block_a)),
        edges_b_(edges.of(block_b)) {}

  std::vector<Interface> run() {
    find_stretches();
    find_vertices(a_, b_, edges_a_, edges_b_);
    find_vertices(b_, a_, edges_b_, edges_a_);
    return std::move(found_);
  }

 private:
  void add_stretch(const Vec2& from, const Vec2& to, const Vec2& normal) {
    const double length = (to - from).norm();
    found_.push_back({a_, b_, from, to, normal, length, lines_.joint_of_stretch(a_, b_, {from, to}), length / 2});
  }

  void add_point(int owner, int other, const Vec2& point, const Segment& edge) {
    found_.push_back({owner, other, point, point, outward_normal(edge), 0, lines_.joint_of_point(a_, b_, point, edge),
                      share_of_point()});
  }

  [[nodiscard]] double share_of_point() const {
    const auto area = [&](int block) { return model_.blocks[static_cast<std::size_t>(block)].moments.area; };
    return point_share * std::sqrt(std::min(area(a_), area(b_)));
  }

  void find_stretches() {
    for (const Edge& edge_a : edges_a_) {
      for (const Edge& edge_b : edges_b_) {
        if (!overlap(edge_a.box, edge_b.box)) continue;
        const Vec2 along_a = edge_a.segment.end - edge_a.segment.start;
        // Facing outlines run against each other, because each has its material on its left.
        if (along_a.dot(edge_b.segment.end - edge_b.segment.start) >= 0) continue;
        const auto common = collinear_overlap(edge_a.segment, edge_b.segment, model_.length_tolerance);
        if (common) add_stretch(common->first, common->second, outward_normal(edge_a.segment));
      }
    }
  }

  // Vertices of `other` inside an edge of `owner` that are not an end of a stretch found before.
  void find_vertices(int owner, int other, std::span<const Edge> owner_edges, std::span<const Edge> other_edges) {
    for (const Edge& edge : owner_edges) {
      for (const Edge& start_here : other_edges) {
        const Vec2& vertex = start_here.segment.start;
        if (!overlap(edge.box, expanded(Box{}, vertex)) || !inside(edge.segment, vertex)) continue;
        if (!on_a_stretch(vertex)) add_point(owner, other, vertex, edge.segment);
      }
    }
  }

  [[nodiscard]] bool inside(const Segment& edge, const Vec2& point) const {
    const double tolerance = model_.length_tolerance;
    return distance(edge, point) <= tolerance && (point - edge.start).norm() > tolerance &&
           (point - edge.end).norm() > tolerance;
  }

  [[nodiscard]] bool on_a_stretch(const Vec2& point) const {
    return std::any_of(found_.begin(), found_.end(), [&](const Interface& interface) {
      return distance(Segment{interface.from, interface.to}, point) <= model_.length_tolerance;
    });
  }

  const Model& model_;
  const JointLines& lines_;
  int a_;
  int b_;
  std::span<const Edge> edges_a_;
  std::span<const Edge> edges_b_;
  std::vector<Interface> found_;
};

}  // namespace

std::vector<Interface> find_interfaces(const Model& model) {
  const Edges edges(model);
  const JointLines lines(model);
  std::vector<Box> boxes;
  boxes.reserve(model.blocks.size());
  for (const Block& block : model.blocks) boxes.push_back(expanded(bounding_box(block.shape), model.length_tolerance));
  std::vector<Interface> interfaces;
  for (const auto& [a, b] : overlapping_pairs(boxes)) {
    const std::vector<Interface> found = PairSearch(model, a, b, edges, lines).run();
    interfaces.insert(interfaces.end(), found.begin(), found.end());
  }
  interfaces.shrink_to_fit();
  return interfaces;
}

}  // namespace dda
