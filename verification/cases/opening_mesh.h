// A circular opening of radius 1 m in a ring mesh under far stresses along the axes, and what Kirsch's solution makes
// of its blocks' stresses.
#pragma once

#include <array>
#include <cstddef>

#include "engine/model/model.h"
#include "engine/simulation/simulation.h"

namespace verify {

struct FarStress {
  double xx = 0, yy = 0;  // Pa
  // The largest, which errors are measured by.
  [[nodiscard]] double size() const;
};

// Rock with the opening, under the far stress; outside act the tractions of Kirsch's stresses, so that the mesh may end
// there.
[[nodiscard]] dda::Model opened(int sectors, const FarStress& far);

// Rock in whose opening there is one block, the last. Nothing acts yet.
[[nodiscard]] dda::Model filled(int sectors, double outer_radius);

// Tractions on the outside: of Kirsch's stresses, and of one stress (xx, yy, xy) everywhere.
void hold_outside(dda::Model& model, const FarStress& far);
void hold_outside(dda::Model& model, const dda::Vec3& stress);

// Root mean square of the errors of all stress components of the blocks from 1.2 to 4 m, of the far stress.
[[nodiscard]] double mean_error(const dda::Simulation& simulation, const FarStress& far);

// The value at the wall on the x axis of `values` in the centroids of the first three rings there: a parabola.
[[nodiscard]] double at_wall(const dda::Model& model, std::size_t sectors, const std::array<double, 3>& values);

// Hoop stress there.
[[nodiscard]] double wall_stress(const dda::Simulation& simulation, std::size_t sectors);

}  // namespace verify
