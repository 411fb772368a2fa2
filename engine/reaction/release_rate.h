// Energy release rates of excavation (N. G. W. Cook et al. 1966, Rock mechanics applied to the study of rockbursts, J.
// S. Afr. Inst. Min. Metall. 66, 435-528; M. D. G. Salamon 1984, see model/energy_release.h).
//
// The energy released in the stage that takes rock out, positive when released, by its fate: motion, damping,
// radiation, and what the rock taken out had stored. Over the area taken out in the plane it is per volume mined, J/m3;
// times a stoping width it is the rate per area mined, J/m2, of tabular mining. Over the length along which blocks
// taken out touched blocks that stay it is per area of wall laid free, J/m2.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/simulation/simulation.h"

namespace dda {

struct ReleaseRate {
  std::size_t stage = 0;
  double released = 0;  // J per m of thickness
  double area = 0;      // m2, of the blocks taken out
  double wall = 0;      // m, laid free, as drawn; 0 where all neighbours had gone before

  [[nodiscard]] double per_volume() const { return released / area; }  // J/m3
  [[nodiscard]] std::optional<double> per_wall() const;                // J/m2
};

// Returns the rates of all stages that have taken blocks out and are over, in their order.
[[nodiscard]] std::vector<ReleaseRate> release_rates(const Simulation& simulation);

}  // namespace dda
