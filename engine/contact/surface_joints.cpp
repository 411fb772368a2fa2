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

bool lies_on(const Segment& stretch, const Segment& line, double tolerance) {
  const double length = (stretch.end - stretch.start).norm();
  if (length == 0) return distance(line, stretch.start) <= tolerance;
  const auto common = collinear_overlap(stretch, line, tolerance);
  return common && (common->second - common->first).norm() > length / 2;
}

Segment drawn_edge(const Model& model, const Outlines& outlines, int block, int edge) {
  const Vec2& centroid = model.blocks[at(block)].moments.centroid;
  return {centroid + outlines.reference[at(edge)], centroid + outlines.reference[at(outlines.next[at(edge)])]};
}

}  // namespace

JointLines::JointLines(const Model& model)
    : model_(model), tolerance_(point_tolerance(model)), boxes_(boxes_of(model.joint_lines)) {}

// What runs along a stretch within the tolerance may end that far beside its box; twice that is not near to round-off.
std::vector<int> JointLines::near(const Segment& stretch) const {
  return boxes_.overlapping(edge_box(stretch, 2 * tolerance_));
}

int JointLines::joint_of_stretch(int block_a, int block_b, const Segment& stretch) const {
  const std::vector<int> lines = near(stretch);
  const auto line = std::find_if(lines.rbegin(), lines.rend(), [&](int each) {
    return lies_on(stretch, segment_of(model_.joint_lines[at(each)]), tolerance_);
  });
  return line == lines.rend() ? model_.joint_index(block_a, block_b) : model_.joint_lines[at(*line)].joint;
}

SurfaceJoints::SurfaceJoints(const Model& model, const Outlines& outlines) {
  if (model.joint_lines.empty()) return;
  const double tolerance = point_tolerance(model);
  const BoxIndex blocks(outlines.boxes);
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
  const int of_edge = joint_at(contact.edge, closest_parameter(edge, outlines.current[at(contact.vertex)]));
  const int facing = facing_edge(outlines, contact);
  const int of_vertex = joint_at(facing, facing == contact.vertex ? 0 : 1);
  if (of_edge < 0 && of_vertex < 0) return of_pair;
  if (of_edge < 0 || of_vertex < 0) return std::max(of_edge, of_vertex);
  return of_edge == of_vertex ? of_edge : of_pair;
}

}  // namespace dda
