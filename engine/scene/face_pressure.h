// Pressure on faces as a function of place: the same everywhere, that of a liquid below its surface, which may fall
// and rise along x as a water table does, or a table over heights.
#pragma once

#include <vector>

#include "engine/builder/ground_plan.h"
#include "engine/core/types.h"
#include "engine/model/time_function.h"
#include "engine/scene/field.h"

namespace dda {

// A part of a stretch along which the pressure goes in a straight line.
struct PressedPart {
  Vec2 from, to;
  double at_from = 0, at_to = 0;  // Pa
};

class FacePressure {
 public:
  explicit FacePressure(const Field& field);

  // Those parts on which there is any, and the whole where it is the same everywhere.
  [[nodiscard]] std::vector<PressedPart> on(const Stretch& stretch) const;

 private:
  void read_surface(const Field& surface);
  void read_table(const Field& rows);
  void check_reach(const Stretch& stretch) const;
  [[nodiscard]] double depth(const Vec2& place) const;
  [[nodiscard]] double at(const Vec2& place) const;
  [[nodiscard]] std::vector<double> corners_on(const Stretch& stretch) const;
  [[nodiscard]] bool presses(const PressedPart& part) const;

  Field field_;
  double uniform_ = 0;       // Pa
  double gradient_ = 0;      // Pa/m, below the surface
  PiecewiseLinear surface_;  // m, its height over x; none where empty
  PiecewiseLinear table_;    // Pa over heights, m; none where empty
};

}  // namespace dda
