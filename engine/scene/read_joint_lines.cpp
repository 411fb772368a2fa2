#include <fmt/format.h>

#include <algorithm>

#include "engine/model/tolerance.h"
#include "engine/scene/places.h"
#include "engine/scene/sections.h"

namespace dda {
namespace {

// Outlines of two blocks run along the same part of the line, one on each side of it.
bool touch(const Stretch& a, const Stretch& b, double tolerance) {
  return a.block != b.block && a.inward.dot(b.inward) < 0 &&
         collinear_overlap({a.from, a.to}, {b.from, b.to}, tolerance).has_value();
}

bool is_joint(const std::vector<Stretch>& stretches, double tolerance) {
  for (auto a = stretches.begin(); a != stretches.end(); ++a) {
    if (std::any_of(a + 1, stretches.end(), [&](const Stretch& b) { return touch(*a, b, tolerance); })) return true;
  }
  return false;
}

// Two blocks around the middle are enough where they touch; the box of a long line holds many.
bool is_joint(const GroundPlan& plan, const Segment& line, double tolerance) {
  return is_joint(plan.stretches_at(line, (line.start + line.end) / 2), tolerance) ||
         is_joint(plan.stretches_along(line), tolerance);
}

void read_joint_line(const Field& field, const GroundPlan& plan, Model& model) {
  const int joint = read_joint_reference(field.at("joint"), model);
  const std::vector<Field> points = field.at("points").items();
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Segment part{points[i - 1].vector(Dimension::length), points[i].vector(Dimension::length)};
    if (!is_joint(plan, part, point_tolerance(model))) {
      field.at("points").fail(fmt::format("without blocks that touch from [{}, {}] to [{}, {}]", part.start.x(),
                                          part.start.y(), part.end.x(), part.end.y()),
                              "a line along which blocks touch");
    }
    model.joint_lines.push_back({part.start, part.end, joint});
  }
}

}  // namespace

void read_joint_lines(const Field& scene, const GroundPlan& plan, Model& model) {
  const auto lines = scene.find("joint_lines");
  if (!lines) return;
  for (const Field& line : lines->items()) read_joint_line(line, plan, model);
}

}  // namespace dda
