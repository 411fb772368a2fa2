#include "engine/record/frame_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>

#include "engine/geometry/segment.h"
#include "engine/geometry/triangulate.h"

namespace dda {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// The larger (sign = 1) or smaller (-1) principal stress.
double principal_stress(const Vec3& stress, double sign) {
  return (stress[0] + stress[1]) / 2 + sign * std::hypot((stress[0] - stress[1]) / 2, stress[2]);
}

struct ScalarOfBlock {
  const char* name;
  double (*value)(const State& state, std::size_t block);
};
constexpr std::array scalars_of_block = {
    ScalarOfBlock{"stress_xx [Pa]", [](const State& state, std::size_t i) { return state.stress[i][0]; }},
    ScalarOfBlock{"stress_yy [Pa]", [](const State& state, std::size_t i) { return state.stress[i][1]; }},
    ScalarOfBlock{"stress_xy [Pa]", [](const State& state, std::size_t i) { return state.stress[i][2]; }},
    ScalarOfBlock{"stress_1 [Pa]",
                  [](const State& state, std::size_t i) { return principal_stress(state.stress[i], 1); }},
    ScalarOfBlock{"stress_2 [Pa]",
                  [](const State& state, std::size_t i) { return principal_stress(state.stress[i], -1); }},
    ScalarOfBlock{"rotation [rad]", [](const State& state, std::size_t i) { return state.displacement[i][2]; }},
};

VtkArray doubles(std::string name, int components, std::size_t tuples) {
  return {std::move(name), components, std::vector<double>(static_cast<std::size_t>(components) * tuples)};
}
std::vector<double>& values_of(VtkArray& array) { return std::get<std::vector<double>>(array.values); }

// A vector in the plane; its third component stays zero.
void set_vector(std::vector<double>& values, std::size_t tuple, const Vec2& vector) {
  values[3 * tuple] = vector.x();
  values[3 * tuple + 1] = vector.y();
}

void add_cell(VtkCells& cells, int first_point, std::span<const int> corners) {
  for (const int corner : corners) cells.connectivity.push_back(first_point + corner);
  cells.offsets.push_back(static_cast<std::int64_t>(cells.connectivity.size()));
}

}  // namespace

// In a fan of as many triangles that all turn left, none overlaps another: their areas add up to that of the polygon.
std::optional<std::size_t> fan_apex(const Polygon& polygon) {
  if (!polygon.holes.empty()) return std::nullopt;
  const Ring& ring = polygon.outer;
  const std::size_t n = ring.size();
  for (std::size_t apex = 0; apex < n; ++apex) {
    bool covers = true;
    for (std::size_t i = 1; i + 1 < n && covers; ++i) {
      const Vec2 side = ring[(apex + i) % n] - ring[apex];
      covers = cross(side, ring[(apex + i + 1) % n] - ring[apex]) >= 0;
    }
    if (covers) return apex;
  }
  return std::nullopt;
}

FrameWriter::FrameWriter(const Model& model, std::filesystem::path index) : model_(model), series_(std::move(index)) {
  const int blocks = static_cast<int>(model.blocks.size());
  for (int block = 0; block < blocks; ++block) add_points(block);
  data_.points.assign(3 * vertices_.size(), 0);
  data_.point_data = {doubles("displacement [m]", 3, vertices_.size()), doubles("velocity [m/s]", 3, vertices_.size())};
  list_cells();
}

// Lists the cells of the blocks that are there, rings before surfaces, as VTK numbers lines before polygons.
void FrameWriter::list_cells() {
  const int blocks = static_cast<int>(model_.blocks.size());
  data_.lines = data_.polygons = {};
  cell_block_.clear();
  for (int block = 0; block < blocks; ++block)
    if (!is_absent(block)) add_rings(block, first_point_[at(block)]);
  for (int block = 0; block < blocks; ++block)
    if (!is_absent(block)) add_surface(block, first_point_[at(block)]);

  const std::size_t cells = cell_block_.size();
  std::vector<std::int32_t> materials;
  for (const int block : cell_block_) materials.push_back(model_.blocks[at(block)].material);
  std::vector<std::string> names;
  for (const int block : cell_block_) names.push_back(model_.blocks[at(block)].name);
  data_.cell_data = {
      {"block", 1, cell_block_}, {"material", 1, std::move(materials)}, {"block_name", 1, std::move(names)}};
  for (const ScalarOfBlock& scalar : scalars_of_block) data_.cell_data.push_back(doubles(scalar.name, 1, cells));
  data_.cell_data.push_back(doubles("velocity [m/s]", 3, cells));
  data_.cell_data.push_back(doubles("displacement [m]", 3, cells));
}

void FrameWriter::add_points(int block) {
  const Polygon& shape = model_.blocks[at(block)].shape;
  first_point_.push_back(static_cast<int>(vertices_.size()));
  vertices_.insert(vertices_.end(), shape.outer.begin(), shape.outer.end());
  for (const Ring& hole : shape.holes) vertices_.insert(vertices_.end(), hole.begin(), hole.end());
  vertex_block_.resize(vertices_.size(), block);
}

void FrameWriter::add_rings(int block, int first_point) {
  const Polygon& shape = model_.blocks[at(block)].shape;
  if (fan_apex(shape)) return;
  const auto add = [&](const Ring& ring) {
    std::vector<int> corners(ring.size() + 1);
    std::iota(corners.begin(), corners.end(), 0);
    corners.back() = 0;
    add_cell(data_.lines, first_point, corners);
    cell_block_.push_back(block);
    first_point += static_cast<int>(ring.size());
  };
  add(shape.outer);
  for (const Ring& hole : shape.holes) add(hole);
}

void FrameWriter::add_surface(int block, int first_point) {
  const Polygon& shape = model_.blocks[at(block)].shape;
  if (const auto apex = fan_apex(shape)) {
    std::vector<int> corners(shape.outer.size());
    std::iota(corners.begin(), corners.end(), 0);
    std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(*apex), corners.end());
    add_cell(data_.polygons, first_point, corners);
    cell_block_.push_back(block);
    return;
  }
  for (const Triangle& triangle : triangulate(shape)) {
    add_cell(data_.polygons, first_point, triangle);
    cell_block_.push_back(block);
  }
}

void FrameWriter::write(const State& state, const std::vector<bool>& absent) {
  if (absent != absent_) {
    absent_ = absent;
    list_cells();
  }
  data_.time = state.time;
  fill_points(state);
  fill_cells(state);
  series_.add(data_);
}

void FrameWriter::fill_points(const State& state) {
  std::vector<double>& displacement = values_of(data_.point_data[0]);
  std::vector<double>& velocity = values_of(data_.point_data[1]);
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const Vec2 moved = point_displacement(model_, state, vertex_block_[i], vertices_[i]);
    set_vector(data_.points, i, vertices_[i] + moved);
    set_vector(displacement, i, moved);
    set_vector(velocity, i, point_velocity(model_, state, vertex_block_[i], vertices_[i]));
  }
}

void FrameWriter::fill_cells(const State& state) {
  std::size_t array = 3;  // after block, material and name
  for (const ScalarOfBlock& scalar : scalars_of_block) {
    std::vector<double>& values = values_of(data_.cell_data[array++]);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = scalar.value(state, at(cell_block_[i]));
  }
  std::vector<double>& velocity = values_of(data_.cell_data[array++]);
  std::vector<double>& displacement = values_of(data_.cell_data[array]);
  for (std::size_t i = 0; i < cell_block_.size(); ++i) {
    const std::size_t block = at(cell_block_[i]);
    set_vector(velocity, i, state.velocity[block].head<2>());
    set_vector(displacement, i, state.displacement[block].head<2>());
  }
}

}  // namespace dda
