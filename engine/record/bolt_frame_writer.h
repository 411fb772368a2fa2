// Rock bolts of a run for ParaView, a series beside the frames of its blocks.
#pragma once

#include <filesystem>
#include <span>

#include "engine/core/types.h"
#include "engine/model/model.h"
#include "engine/model/state.h"
#include "engine/record/material_lines.h"
#include "engine/record/vtp_series.h"

namespace dda {

// yielded: along or across, now or before; waiting: to be put in by a later stage
enum class BoltCondition { elastic, yielded, broken, waiting };

// What a link of a bolt bears.
struct BoltLinkValues {
  Vec2 force = Vec2::Zero();  // N in one bolt: axial (tension positive), shear
  double elongation = 0;      // m, since the start
  BoltCondition condition = BoltCondition::elastic;
};

// Every link is a line: from anchor to anchor, or through a joint and the bolt's length in rock on both sides that
// belongs to the link. Its points are material points of the two blocks. Point data:
//   displacement [m] since the start
// Cell data:
//   bolt, link (indices, links of a bolt from 0), bolt_name, block_a, block_b, status (0 elastic, 1 yielded, 2 broken,
//   3 not yet put in) axial_force [N] (tension positive), shear_force [N]: of one bolt; elongation [m]
class BoltFrameWriter {
 public:
  // `index` is DIR/NAME.pvd, as for VtpSeries. The model must outlive the writer.
  BoltFrameWriter(const Model& model, std::filesystem::path index);

  // Adds the bolts as they are. `links`: those of all bolts, one bolt after the other.
  void write(const State& state, std::span<const BoltLinkValues> links);

  void go_on_after(std::span<const double> times) { series_.go_on_after(times); }

 private:
  void add_line(const BoltLink& link, const Vec2& direction);

  const Model& model_;
  VtpSeries series_;
  MaterialLines lines_;
  PolyData data_;  // what stays from frame to frame is filled in once
};

}  // namespace dda
