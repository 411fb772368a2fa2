// Frames of a run for ParaView.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "engine/model/model.h"
#include "engine/model/state.h"
#include "engine/record/vtp_series.h"

namespace dda {

// A series of the blocks as they are, drawn where they are. A block is one polygon if a fan of triangles from one of
// its vertices covers it (all convex blocks, and e.g. L-shaped ones), because that is how VTK draws polygons. Any other
// block is triangles, and its rings are closed lines, the outer one first: only those are its edges. Each block has its
// own points: edges between blocks stay visible.
//   cell data: block, material (indices), block_name (text), stress_xx, _yy, _xy and principal stresses stress_1 >=
//   stress_2 [Pa, tension
//     positive], velocity [m/s] and displacement [m] of the centroid, rotation [rad]
//   point data: displacement [m] and velocity [m/s] of the material point, e.g. to exaggerate by "Warp By Vector"
class FrameWriter {
 public:
  // `index` is DIR/NAME.pvd, as for VtpSeries. `model` must outlive the writer.
  FrameWriter(const Model& model, std::filesystem::path index);

  // Adds a frame; errors as of VtpSeries. Blocks that are absent, `absent` saying so of each where any is, have points
  // and no cells.
  void write(const State& state, const std::vector<bool>& absent = {});

  // Goes on behind the frames that an earlier run wrote at these times (s), which stay as they are.
  void go_on_after(std::span<const double> times) { series_.go_on_after(times); }

  [[nodiscard]] int frames() const { return series_.size(); }

 private:
  void add_points(int block);
  void list_cells();
  [[nodiscard]] bool is_absent(int block) const { return !absent_.empty() && absent_[static_cast<std::size_t>(block)]; }
  void add_rings(int block, int first_point);
  void add_surface(int block, int first_point);
  void fill_points(const State& state);
  void fill_cells(const State& state);

  const Model& model_;
  VtpSeries series_;
  std::vector<Vec2> vertices_;     // reference positions of all points
  std::vector<int> vertex_block_;  // block of each point
  std::vector<int> first_point_;   // of each block
  std::vector<int> cell_block_;
  std::vector<bool> absent_;  // of the latest frame
  PolyData data_;             // of the latest frame
};

// The vertex (of a polygon without holes, counter-clockwise) from which a fan of triangles covers the polygon; nothing
// when there is none or the polygon has holes.
std::optional<std::size_t> fan_apex(const Polygon& polygon);

}  // namespace dda
