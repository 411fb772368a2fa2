#include "engine/contact/surface_joints.h"

#include <algorithm>
#include <cstddef>

#include "engine/model/tolerance.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

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

int joint_of_stretch(const Model& model, int block_a, int block_b, const Segment& stretch) {
  const double tolerance = point_tolerance(model);
  const auto line = std::find_if(model.joint_lines.rbegin(), model.joint_lines.rend(), [&](const JointLine& each) {
    return lies_on(stretch, {each.from, each.to}, tolerance);
  });
  return line == model.joint_lines.rend() ? model.joint_index(block_a, block_b) : line->joint;
}

SurfaceJoints::SurfaceJoints(const Model& model, const Outlines& outlines) {
  const double tolerance = point_tolerance(model);
  for (const JointLine& line : model.joint_lines) {
    const Box box = expanded(expanded(expanded(Box{}, line.from), line.to), tolerance);
    for (int block = 0; block < outlines.blocks(); ++block) {
      if (!overlap(box, outlines.boxes[at(block)])) continue;
      for (int edge = outlines.starts[at(block)]; edge < outlines.starts[at(block) + 1]; ++edge) {
        const Segment drawn = drawn_edge(model, outlines, block, edge);
        const auto common = collinear_overlap(drawn, {line.from, line.to}, tolerance);
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
