// The thesis' bar as a Model of the engine.
#pragma once

#include "engine/model/model.h"
#include "verification/thesis/reference.h"
#include "verification/thesis/schemes.h"

namespace verify {

struct BarRun {
  double dt = 0;            // s
  double block_length = 0;  // m
  double bar_length = 0;    // m
  double duration = 0;      // s
};

// Finished model: bar along x from 0, the load spread over its left face, plane stress, no gravity; its one measurement
// is scheme.quantity at the measuring point.
[[nodiscard]] dda::Model bar_scene(const ThesisBar& bar, const SchemeSettings& scheme, const BarRun& run);

// Index of the block to the right of the measuring point, which must be a joint: std::invalid_argument if not.
[[nodiscard]] int block_right_of_point(const ThesisBar& bar, double block_length);

// Where a scheme's quantity is taken, m from the loaded end: the measuring point, or for the stress of a block, which
// is its mean, the middle of the block beside it. The analytic solution it is compared with is that of this place.
[[nodiscard]] double measured_place(const ThesisBar& bar, const SchemeSettings& scheme, double block_length);

}  // namespace verify
