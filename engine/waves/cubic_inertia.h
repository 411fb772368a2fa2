// Inertia in chains of cubic interfaces (engine/contact/cubic_law.h).
//
// Blocks count their mass as if displacements were straight lines in each; the cubic between two centroids moves
// otherwise. What it adds to the kinetic energy of the two halves is, with the symbols of cubic_law.h, u the mean of
// both blocks' displacements at mid-interface, {} means and ' rates, per m of thickness
//   rho l h ((33/560 - 3/16) g'^2 + (1/48 + 1/80) J'^2 + J' u'/6 - g' h {e'}/10).
// It couples the two blocks, and with it phase errors are of order (2 pi L/wavelength)^6.
#pragma once

#include "engine/contact/interface.h"
#include "engine/contact/interface_element.h"
#include "engine/core/types.h"
#include "engine/model/model.h"

namespace dda {

namespace cubic {

inline constexpr double most_correction = 0.1;        // of the mass between the centroids: cap on the lowered inertia
inline constexpr double most_jump_correction = 0.05;  // the same in the jump of the strains

}  // namespace cubic

// The part of the kinetic energy 1/2 v M v that couples the two blocks of a cubic interface.
// `period_error`: epsilon of the integrator (wave_corrections.h), or 0. Inertia of relative motion is lowered by
// cubic_inertia_share() to make up for it: the kinetic energy by that share of
//   rho l h (u_b'^2 - 2 u_a' u_b' + u_a'^2 + J'^2/3),   u at the centroids,
// which is 2h rho l/2 times (2h w_x')^2 of a wave w up to the sixth power of 2h over the wavelength; the share of J'^2
// is capped by itself.
InterfaceMatrices cubic_inertia(const Model& model, const Interface& interface, double period_error, double dt);

// The share of the mass between the centroids by which the inertia of relative motion is lowered: epsilon (c dt/2h)^2,
// at most a tenth. At 17/140 the inertia of waves two blocks long would vanish; at 0.1 and 0.05 for the jump, the least
// inertia of any wave is 0.09 times what it was (determinant of the chain's 2x2 inertia, all wavelengths).
double cubic_inertia_share(const Model& model, const Interface& interface, double period_error, double dt);

// By how much loads beside the interface are sharpened (see LoadFilter): the share above over (c dt/2h)^2, which is
// epsilon where that is not capped.
double cubic_load_sharpening(const Model& model, const Interface& interface, double period_error, double dt);

// What the sideways strain of a block adds to its inertia (6x6), for a chain that runs along `normal`.
Mat6 lateral_inertia(double mass, const AreaMoments& moments, const Vec2& normal);

}  // namespace dda
