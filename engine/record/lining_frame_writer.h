// Linings of a run for ParaView, a series beside the frames of its blocks.
#pragma once

#include <filesystem>
#include <span>

#include "engine/model/model.h"
#include "engine/model/state.h"
#include "engine/record/material_lines.h"
#include "engine/record/vtp_series.h"

namespace dda {

// yielded: now or before; waiting: to be sprayed by a later stage
enum class LiningCondition { elastic, yielded, waiting };

// What an element of a lining bears, per m of thickness out of the plane.
struct LiningValues {
  double thrust = 0;       // N, compression positive
  double moment = 0;       // N m, in its middle; positive where it pulls the free face
  double shear = 0;        // N
  double utilisation = 0;  // of the moment that its ends can carry beside the thrust; 0 where it does not yield
  LiningCondition condition = LiningCondition::elastic;
};

// Every element is a line from face to face. Its points are material points of the two blocks. Point data:
//   displacement [m] since the start
// Cell data:
//   lining, element (indices from 0), lining_name, block_a, block_b, status (0 elastic, 1 yielded, 2 not yet sprayed),
//   thrust [N], moment [N m], shear [N], utilisation
class LiningFrameWriter {
 public:
  // `index` is DIR/NAME.pvd, as for VtpSeries. The model must outlive the writer.
  LiningFrameWriter(const Model& model, std::filesystem::path index);

  // Adds the linings as they are. `elements`: those of all linings, one lining after the other.
  void write(const State& state, std::span<const LiningValues> elements);

  void go_on_after(std::span<const double> times) { series_.go_on_after(times); }

 private:
  const Model& model_;
  VtpSeries series_;
  MaterialLines lines_;
  PolyData data_;  // what stays from frame to frame is filled in once
};

}  // namespace dda
