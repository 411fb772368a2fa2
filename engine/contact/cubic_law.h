// The cubic law: a bonded interface between two equal blocks of a chain (a bar or column with free sides) sees, between
// their centroids, not two straight lines with a gap but the cubic that has both blocks' centroid displacements and
// strains along the chain (Hermite interpolation). Energies of the cubic replace those of the two half blocks beside
// the interface, so the chain is a C1 cubic finite-element line: phase errors of order (2 pi L/wavelength)^6 instead of
// (..)^2, with the same six unknowns a block.
//
// With h half the centroids' distance, l the interface length, g the normal gap at mid-interface, [e] the jump of the
// normal strain, J = h [e], Q the modulus of a bar with free sides, t = sigma_nn - (D12/D22) sigma_tt of a block, that
// is Q e when its sides are free (the strain that the cubic adds contracts sideways freely), all per m of thickness:
//   potential  l {t} g + l/4 (t_a - t_b) J + Q l/(2 h) (3/5 g^2 + J^2/6)
//   kinetic    rho l h ((33/560 - 3/16) g'^2 + (1/48 + 1/80) J'^2 + J' u'/6 - g' h {e'}/10)
// both being the integral over the cubic minus that over the two halves; u the mean of both blocks' displacements at
// mid-interface, {} means, ' rates. Derived with w' - e_a = 3/2 (1 - s^2) g/(2h) + [e] (1 + s)/2 on block a's half,
// s = x/h in [-1, 0], and its mirror image on b's.
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
inline constexpr double most_correction = 0.1;        // of the mass between the centroids: cap on the lowered inertia
inline constexpr double most_jump_correction = 0.05;  // the same in the jump of the strains

}  // namespace cubic

// Modulus along a bar whose sides are free, Pa: E in plane stress, E/(1 - nu^2) in plane strain.
double side_free_modulus(const Material& material);

// Half the distance between the blocks' centroids, m.
double cubic_half_distance(const Model& model, const Interface& interface);

// Lateral strain by axial strain in a bar whose sides are free: D12/D22.
double side_free_ratio(const Material& material);

// Which of `interfaces` can be cubic: equal halves of one material, the interface across their centroid line, and
// neither an interface nor an edge load nor a viscous edge on the sides of either block.
std::vector<bool> cubic_candidates(const Model& model, const std::vector<Interface>& interfaces);

// The part of the kinetic energy 1/2 v M v that couples the two blocks of a cubic interface.
// `period_error`: epsilon of the integrator, whose oscillators run at omega^2 (1 - epsilon omega^2 dt^2), or 0. Inertia
// of relative motion is lowered by inertia_reduction() to make up for it: the kinetic energy by that share of
//   rho l h (u_b'^2 - 2 u_a' u_b' + u_a'^2 + J'^2/3),   u at the centroids,
// which is 2h rho l/2 times (2h w_x')^2 of a wave w up to the sixth power of 2h over the wavelength; the share of J'^2
// is capped by itself.
InterfaceMatrices interface_inertia(const Model& model, const Interface& interface, double period_error, double dt);

// The share of the mass between the centroids by which the inertia of relative motion is lowered: epsilon (c dt/2h)^2,
// at most a tenth. At 17/140 the inertia of waves two blocks long would vanish; at 0.1 and 0.05 for the jump, the least
// inertia of any wave is 0.09 times what it was (determinant of the chain's 2x2 inertia, all wavelengths).
double inertia_reduction(const Model& model, const Interface& interface, double period_error, double dt);

// Lowered inertia M - s dt^2 K with steps that take omega^2 (1 + s omega^2 dt^2) for omega^2 is the exact equation
// times 1 + s omega^2 dt^2: waves keep their speed, but loads have to be multiplied by that factor too, or all they
// cause is too small by it. The factor is 1 - s times the second difference of the load over dt. s: inertia_reduction()
// over (c dt/2h)^2, epsilon where that is not capped.
double load_sharpening(const Model& model, const Interface& interface, double period_error, double dt);

// Strain along the unit vector `direction`, over the six unknowns of a block.
Vec6 strain_along(const Vec2& direction);

// What the sideways strain of a block adds to its inertia (6x6), for a chain that runs along `normal`.
Mat6 lateral_inertia(double mass, const AreaMoments& moments, const Vec2& normal);

// epsilon of an integrator, from its characteristic equation at small omega dt: waves driven at the frequency omega run
// slower by the share epsilon (omega dt)^2/2. 1/6 for the trapezoidal rule, -1/48 for Eq. 5.
double period_error(const Integrator& integrator);

}  // namespace dda
