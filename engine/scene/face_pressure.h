// Pressure on faces as a function of height: the same everywhere, that of a liquid with a surface, or a table.
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
  void read_table(const Field& rows);
  [[nodiscard]] double at(double height) const;

  Field field_;
  double uniform_ = 0;         // Pa
  double surface_ = 0;         // m
  double gradient_ = 0;        // Pa/m, below the surface
  PiecewiseLinear table_;      // Pa over m
  std::vector<double> bends_;  // m, heights at which the straight line has a corner
};

}  // namespace dda
