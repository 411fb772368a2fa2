// Frames of a run for ParaView.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "dda/model/model.h"
#include "dda/model/state.h"
#include "dda/record/vtp_file.h"

namespace dda {

// Writes DIR/NAME/000000.vtp, 000001.vtp, ... and the index DIR/NAME.pvd with their times, rewritten with each frame,
// so that a run that is going on or was broken off can be looked at. Blocks are drawn where they are; convex ones as
// one polygon, others as triangles. Each block has its own points: edges between blocks stay visible.
//   cell data: block, material (indices), stress_xx, _yy, _xy and principal stresses stress_1 >= stress_2 [Pa, tension
//     positive], velocity [m/s] and displacement [m] of the centroid, rotation [rad]
//   point data: displacement [m] and velocity [m/s] of the material point, e.g. to exaggerate by "Warp By Vector"
class FrameWriter {
 public:
  // `index` is DIR/NAME.pvd; DIR must exist. `model` must outlive the writer. std::runtime_error naming path and
  // reason.
  FrameWriter(const Model& model, std::filesystem::path index);

  // Adds a frame; std::runtime_error naming path and reason, with all earlier frames and their index left as they were.
  void write(const State& state);

  // Goes on behind the frames that an earlier run wrote at these times (s), which stay as they are.
  void go_on_after(std::span<const double> times);

  [[nodiscard]] int frames() const { return frames_; }

 private:
  [[nodiscard]] std::filesystem::path frame_path() const;
  [[nodiscard]] std::string entry(double time) const;
  void add_block(int block);
  void add_cell(int block, int first_vertex, std::span<const int> corners);
  void fill_points(const State& state);
  void fill_cells(const State& state);

  const Model& model_;
  std::filesystem::path index_;
  std::vector<Vec2> vertices_;     // reference positions of all points
  std::vector<int> vertex_block_;  // block of each point
  std::vector<int> cell_block_;
  PolyData data_;  // topology fixed, values of the latest frame
  std::string entries_;
  int frames_ = 0;
};

}  // namespace dda
