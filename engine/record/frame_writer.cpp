#include "dda/record/frame_writer.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "dda/geometry/triangulate.h"
#include "dda/record/atomic_file.h"

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

VtkArray indices(std::string name) { return {std::move(name), 1, std::vector<std::int32_t>{}}; }
VtkArray doubles(std::string name, int components, std::size_t tuples) {
  return {std::move(name), components, std::vector<double>(static_cast<std::size_t>(components) * tuples)};
}
std::vector<double>& values_of(VtkArray& array) { return std::get<std::vector<double>>(array.values); }

// A vector in the plane; its third component stays zero.
void set_vector(std::vector<double>& values, std::size_t tuple, const Vec2& vector) {
  values[3 * tuple] = vector.x();
  values[3 * tuple + 1] = vector.y();
}

void create_folder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directory(path, error);
  if (error) throw std::runtime_error("cannot create folder " + path.string() + ": " + error.message());
}

}  // namespace

FrameWriter::FrameWriter(const Model& model, std::filesystem::path index) : model_(model), index_(std::move(index)) {
  create_folder(index_.parent_path() / index_.stem());
  data_.cell_data = {indices("block"), indices("material")};
  for (int block = 0; block < static_cast<int>(model.blocks.size()); ++block) add_block(block);

  const std::size_t cells = cell_block_.size();
  for (const ScalarOfBlock& scalar : scalars_of_block) data_.cell_data.push_back(doubles(scalar.name, 1, cells));
  data_.cell_data.push_back(doubles("velocity [m/s]", 3, cells));
  data_.cell_data.push_back(doubles("displacement [m]", 3, cells));
  data_.points.assign(3 * vertices_.size(), 0);
  data_.point_data = {doubles("displacement [m]", 3, vertices_.size()), doubles("velocity [m/s]", 3, vertices_.size())};
}

void FrameWriter::add_block(int block) {
  const Polygon& shape = model_.blocks[at(block)].shape;
  const int first = static_cast<int>(vertices_.size());
  vertices_.insert(vertices_.end(), shape.outer.begin(), shape.outer.end());
  for (const Ring& hole : shape.holes) vertices_.insert(vertices_.end(), hole.begin(), hole.end());
  vertex_block_.resize(vertices_.size(), block);

  if (is_convex(shape)) {
    std::vector<int> corners(shape.outer.size());
    std::iota(corners.begin(), corners.end(), 0);
    add_cell(block, first, corners);
  } else {
    for (const Triangle& triangle : triangulate(shape)) add_cell(block, first, triangle);
  }
}

void FrameWriter::add_cell(int block, int first_vertex, std::span<const int> corners) {
  for (const int corner : corners) data_.connectivity.push_back(first_vertex + corner);
  data_.offsets.push_back(static_cast<std::int64_t>(data_.connectivity.size()));
  cell_block_.push_back(block);
  std::get<std::vector<std::int32_t>>(data_.cell_data[0].values).push_back(block);
  std::get<std::vector<std::int32_t>>(data_.cell_data[1].values).push_back(model_.blocks[at(block)].material);
}

void FrameWriter::write(const State& state) {
  data_.time = state.time;
  fill_points(state);
  fill_cells(state);
  write_vtp(index_.parent_path() / frame_path(), data_);
  const std::string latest = entry(state.time);
  write_file(index_, "<VTKFile type=\"Collection\" version=\"1.0\">\n  <Collection>\n" + entries_ + latest +
                         "  </Collection>\n</VTKFile>\n");
  entries_ += latest;
  ++frames_;
}

void FrameWriter::go_on_after(std::span<const double> times) {
  for (const double time : times) {
    entries_ += entry(time);
    ++frames_;
  }
}

// Of the next frame, from the folder of the index.
std::filesystem::path FrameWriter::frame_path() const { return index_.stem() / fmt::format("{:06}.vtp", frames_); }

std::string FrameWriter::entry(double time) const {
  return fmt::format("    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", time,
                     xml_escaped(frame_path().generic_string()));
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
  std::size_t array = 2;  // after block and material
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
