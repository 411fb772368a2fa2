// Contacts of a run for ParaView, a series beside the frames of its blocks.
#pragma once

#include <filesystem>
#include <span>

#include "engine/contact/contact_points.h"
#include "engine/record/vtp_series.h"

namespace dda {

// Every contact is a point, where its material point of block b is now. Point data:
//   block_a, block_b (indices), status (0 locked, 1 sliding, 2 open)
//   force [N/m]: what block a exerts on block b, per m of thickness; normal_force [N/m] (tension positive) and
//     shear_force [N/m] are its parts
//   displacement [m] of the material point of block b since the start
class ContactFrameWriter {
 public:
  // `index` is DIR/NAME.pvd, as for VtpSeries.
  explicit ContactFrameWriter(std::filesystem::path index);

  // Adds the contacts at `time` (s).
  void write(double time, std::span<const ContactPoint> contacts);

  void go_on_after(std::span<const double> times) { series_.go_on_after(times); }

 private:
  VtpSeries series_;
};

}  // namespace dda
