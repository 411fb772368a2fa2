// The endless half of a row of blocks, or of a mesh in layers, pushed at its end: what arrives at a joint.
#pragma once

#include <optional>

#include "engine/advice/plane_wave.h"

namespace dda {

class HalfRow {
 public:
  // Returns nothing where no layers of the mesh across `direction` (unit) touch only the next one: it has no flat end.
  static std::optional<HalfRow> make(const Lattice& lattice, const Stage& stage, WaveKind kind, const Vec2& direction);

  [[nodiscard]] double step() const { return step_; }  // m, thickness of a layer

  // The filter through which a run puts loads on the end.
  [[nodiscard]] const LoadFilter& load_filter() const { return load_filter_; }

  // Traction along the wave's motion at joint number `joint` (1: between the first two layers) over that on the end,
  // for s^2 = `square`; exp(-s x/c) in the continuum. `square` must not be that of a wave that runs without loss.
  [[nodiscard]] Complex traction(Complex square, int joint) const;

 private:
  HalfRow() = default;

  // Equations of a layer: own x_j + next x_(j+1) + last x_(j-1) = 0, and of the end: end x_0 + next x_1 = push.
  struct Layers {
    Mat6 own = Mat6::Zero(), next = Mat6::Zero(), last = Mat6::Zero(), end = Mat6::Zero();
  };
  Layers stiffness_, inertia_;
  Vec6 push_ = Vec6::Zero();
  Vec6 traction_here_ = Vec6::Zero(), traction_last_ = Vec6::Zero();
  double step_ = 0;
  LoadFilter load_filter_;
};

}  // namespace dda
