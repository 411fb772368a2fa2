// The cubic law: a bonded interface between two equal blocks of a chain (a bar or column with free sides) sees, between
// their centroids, not two straight lines with a gap but the cubic that has both blocks' centroid displacements and
// strains along the chain (Hermite interpolation). Energies of the cubic replace those of the two half blocks beside
// the interface, so the chain is a C1 cubic finite-element line: phase errors of order (2 pi L/wavelength)^6 instead of
// (..)^2, with the same six unknowns a block.
//
// With h half the centroids' distance, l the interface length, g the normal gap at mid-interface, [e] the jump of the
// normal strain, J = h [e], Q the modulus of a bar with free sides, t = sigma_nn - (D12/D22) sigma_tt of a block, that
// is Q e when its sides are free (the strain that the cubic adds contracts sideways freely), the potential per m of
// thickness is
//   l {t} g + l/4 (t_a - t_b) J + Q l/(2 h) (3/5 g^2 + J^2/6),     {}: means,
// the integral over the cubic minus that over the two halves. Derived with w' - e_a = 3/2 (1 - s^2) g/(2h) + [e] (1 +
// s)/2 on block a's half, s = x/h in [-1, 0], and its mirror image on b's. The same of the kinetic energy is an inertia
// between the blocks: engine/waves/cubic_inertia.h.
#pragma once

#include <vector>

#include "engine/contact/interface.h"
#include "engine/contact/interface_element.h"
#include "engine/core/types.h"
#include "engine/model/model.h"

namespace dda {

namespace cubic {

inline constexpr double jump_traction = 0.25;
inline constexpr double gap_stiffness = 0.6;          // of Q l/h
inline constexpr double jump_stiffness = 1.0 / 6;     // of Q l/h
inline constexpr double bending_stiffness = 1.0 / 6;  // of Q l/h: E I/(2 h) turned by 2 (half difference)/l
inline constexpr double gap_at_interface = 0.75;      // of Q g/h: stress at mid-interface above the mean of both blocks

}  // namespace cubic

// Modulus along a bar whose sides are free, Pa: E in plane stress, E/(1 - nu^2) in plane strain.
double side_free_modulus(const Material& material);

// Half the distance between the blocks' centroids, m.
double cubic_half_distance(const Model& model, const Interface& interface);

// Lateral strain by axial strain in a bar whose sides are free: D12/D22.
double side_free_ratio(const Material& material);

// Which of `interfaces` can be cubic: equal halves of one material, the interface across their centroid line, without
// an interface on the sides of either block, in a chain that has no edge load and no viscous edge on its sides, and no
// point load or support that acts across it but on its axis and on its end faces, nor ends at a held block unless its
// Poisson's ratio is 0. Where sides are held, and where a rigid end keeps blocks from swelling, t above is not
// the stress along the chain: a confined row of nu = 0.25 carried 0.64 of the load on its end.
std::vector<bool> cubic_candidates(const Model& model, const std::vector<Interface>& interfaces);

// Strain along the unit vector `direction`, over the six unknowns of a block.
Vec6 strain_along(const Vec2& direction);

}  // namespace dda
