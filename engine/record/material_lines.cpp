#include "engine/record/material_lines.h"

#include <cstdint>
#include <utility>

namespace dda {
namespace {

void append(std::vector<double>& values, const Vec2& vector) {
  values.insert(values.end(), {vector.x(), vector.y(), 0});
}

}  // namespace

void MaterialLines::add_point(int block, const Vec2& reference, PolyData& data) {
  data.lines.connectivity.push_back(static_cast<std::int64_t>(points_.size()));
  points_.push_back({block, reference});
}

void MaterialLines::end_line(PolyData& data) const {
  data.lines.offsets.push_back(static_cast<std::int64_t>(points_.size()));
}

void MaterialLines::place(const Model& model, const State& state, PolyData& data) const {
  std::vector<double> moved;
  for (const MaterialPoint& point : points_) {
    append(data.points, current_position(model, state, point.block, point.reference));
    append(moved, point_displacement(model, state, point.block, point.reference));
  }
  data.point_data = {{"displacement [m]", 3, std::move(moved)}};
}

}  // namespace dda
