#include "engine/contact/surface_joints.h"

#include <algorithm>
#include <cstddef>

#include "engine/geometry/nearness.h"
#include "engine/model/tolerance.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Segment segment_of(const JointLine& line) { return {line.from, line.to}; }

std::vector<Box> boxes_of(const std::vector<JointLine>& lines) {
  std::vector<Box> boxes;
  boxes.reserve(lines.size());
  for (const JointLine& line : lines) boxes.push_back(edge_box(segment_of(line), 0));
  return boxes;
}

std::vector<Box> drawn_boxes(const Model& model) {
  std::vector<Box> boxes;
  boxes.reserve(model.blocks.size());
  for (const Block& block : model.blocks) boxes.push_back(bounding_box(block.shape));
  return boxes;
}

bool lies_on(const Segment& stretch, const Segment& line, double tolerance) {
  const auto common = collinear_overlap(stretch, line, tolerance);
  return common && (common->second - common->first).norm() > (stretch.end - stretch.start).norm() / 2;
}

bool runs_along_at(const Vec2& point, const Segment& edge, const Segment& line, double tolerance) {
  const auto common = collinear_overlap(edge, line, tolerance);
  return common && distance(Segment{common->first, common->second}, point) <= tolerance;
}

Segment drawn_edge(const Model& model, const Outlines& outlines, int block, int edge) {
  const Vec2& centroid = model.blocks[at(block)].moments.centroid;
  return {centroid + outlines.reference[at(edge)], centroid + outlines.reference[at(outlines.next[at(edge)])]};
}

bool is_bonded(const Model& model, int joint) { return joint >= 0 && model.joints[at(joint)].bonded; }

}  // namespace

JointLines::JointLines(const Model& model)
    : model_(model), tolerance_(point_tolerance(model)), boxes_(boxes_of(model.joint_lines)) {}

// What runs along a stretch within the tolerance may end that far beside its box; twice that is not near to round-off.
std::vector<int> JointLines::near(const Segment& stretch) const {
  return boxes_.overlapping(edge_box(stretch, 2 * tolerance_));
}

template <typename LiesThere>
int JointLines::joint_at(int block_a, int block_b, const Segment& place, const LiesThere& lies_there) const {
  const std::vector<int> lines = near(place);
  const auto line = std::find_if(lines.rbegin(), lines.rend(),
                                 [&](int each) { return lies_there(segment_of(model_.joint_lines[at(each)])); });
  return line == lines.rend() ? model_.joint_index(block_a, block_b) : model_.joint_lines[at(*line)].joint;
}

int JointLines::joint_of_stretch(int block_a, int block_b, const Segment& stretch) const {
  return joint_at(block_a, block_b, stretch, [&](const Segment& line) { return lies_on(stretch, line, tolerance_); });
}

int JointLines::joint_of_point(int block_a, int block_b, const Vec2& point, const Segment& edge) const {
  return joint_at(block_a, block_b, {point, point},
                  [&](const Segment& line) { return runs_along_at(point, edge, line, tolerance_); });
}

SurfaceJoints::SurfaceJoints(const Model& model, const Outlines& outlines) {
  if (model.joint_lines.empty()) return;
  const double tolerance = point_tolerance(model);
  const BoxIndex blocks(drawn_boxes(model));
  for (const JointLine& line : model.joint_lines) {
    for (const int block : blocks.overlapping(edge_box(segment_of(line), tolerance))) {
      for (int edge = outlines.starts[at(block)]; edge < outlines.starts[at(block) + 1]; ++edge) {
        const Segment drawn = drawn_edge(model, outlines, block, edge);
        const auto common = collinear_overlap(drawn, segment_of(line), tolerance);
        if (!common) continue;
        const double slack = tolerance / (drawn.end - drawn.start).norm();
        parts_.push_back({edge, closest_parameter(drawn, common->first) - slack,
                          closest_parameter(drawn, common->second) + slack, line.joint});
      }
    }
  }
  std::stable_sort(parts_.begin(), parts_.end(), [](const Part& a, const Part& b) { return a.edge < b.edge; });
}

int SurfaceJoints::joint_at(int edge, double place) const {
  const auto after = std::upper_bound(parts_.begin(), parts_.end(), edge,
                                      [](int wanted, const Part& part) { return wanted < part.edge; });
  for (auto part = after; part != parts_.begin() && (--part)->edge == edge;)
    if (part->from <= place && place <= part->to) return part->joint;
  return -1;
}

int SurfaceJoints::joint_of(const Model& model, const Outlines& outlines, const VertexContact& contact) const {
  const int of_pair = model.joint_index(contact.edge_block, contact.vertex_block);
  if (parts_.empty()) return of_pair;
  const Segment edge{outlines.current[at(contact.edge)], outlines.current[at(outlines.next[at(contact.edge)])]};
  int of_edge = joint_at(contact.edge, closest_parameter(edge, outlines.current[at(contact.vertex)]));
  const int facing = facing_edge(outlines, contact);
  int of_vertex = joint_at(facing, facing == contact.vertex ? 0 : 1);
  if (of_edge != of_vertex) {
    if (is_bonded(model, of_edge)) of_edge = -1;
    if (is_bonded(model, of_vertex)) of_vertex = -1;
  }
  if (of_edge < 0 && of_vertex < 0) return of_pair;
  if (of_edge < 0 || of_vertex < 0) return std::max(of_edge, of_vertex);
  return of_edge == of_vertex ? of_edge : of_pair;
}

}  // namespace dda
