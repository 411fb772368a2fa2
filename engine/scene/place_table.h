// A function of place given by a table on a rectangular grid, bilinear between its points.
#pragma once

#include <optional>
#include <vector>

#include "engine/core/types.h"
#include "engine/scene/field.h"

namespace dda {

// The coordinates of a grid along one axis, m. A single one: the function does not depend on it.
class GridAxis {
 public:
  // Takes numbers that increase, and refuses others.
  explicit GridAxis(const Field& field);

  struct Place {
    std::size_t index;  // of the coordinate below
    double share;       // of the way to the next
  };

  // Returns nothing for a coordinate outside of the axis by more than `slack` (m); nearer than that it is the end.
  [[nodiscard]] std::optional<Place> find(double coordinate, double slack) const;
  [[nodiscard]] std::size_t size() const { return coordinates_.size(); }

 private:
  std::vector<double> coordinates_;
};

class PlaceTable {
 public:
  // `field`: a row of values for each coordinate of `y`, in each a value for each of `x`.
  PlaceTable(const Field& field, const GridAxis& x, const GridAxis& y, Dimension dimension);

  [[nodiscard]] double at(const GridAxis::Place& x, const GridAxis::Place& y) const;

 private:
  std::vector<std::vector<double>> rows_;
};

}  // namespace dda
