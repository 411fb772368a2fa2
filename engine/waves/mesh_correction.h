// What lets waves run at their speed in a mesh of finite blocks that consistent joints hold, under finite time steps
// (ADR 24). Bonded blocks in small kinematics only.
//
// Blocks. With P modulus D, shear modulus G and s = `stabilisation`, a long wave of wavenumber k and direction theta in
// squares of side L has (rho omega^2)/k^2 = c^2 rho + (k L)^2 times
//   P: D cos^2(2 theta)/12 + s D sin^2(2 theta)/8,        S: G cos^2(2 theta)/12 + s D sin^2(2 theta)/8.
// Both are taken away, in all directions, by the energy
//   V = -1/2 sum over interfaces of l d [e] Q [e],
// [e]: jump of the strains normal, along, shear (n, t, nt) in the axes of the interface, l: its length, d: twice the
// smaller distance of a centroid from it, and
//   Q_nn = D/12, Q_nt = -G/12 (twice), Q_tt = s D/2 - D/12 - G/6, Q_shear = G/12
// (but with s D/2 at most G/3, which matters above nu = 0.4 in plane strain).
// It is the only such Q that depends on nothing but the interface. Errors of squares are then of fourth order; those of
// other shapes fall to a third or less (triangles: stay small). A uniform strain has no part in it.
//
// Time steps whose oscillators run at omega^2 (1 - epsilon omega^2 dt^2) ask for M - epsilon dt^2 K in place of M. K of
// a long wave is G |grad u|^2 + B (div u)^2, B = D - G: so between neighbours
//   T = -1/2 sum of epsilon (G dt^2/d^2) rho l d |u_b' - u_a'|^2,    u at the centroids,
// where d is at most 4 area/perimeter of blocks that are not convex,
// and the inertia of each block's dilatation is lowered by epsilon B dt^2 times its area; in a chain, whose interfaces
// have one normal n and whose waves are those of a bar, that of the strain e_nn by epsilon (Q_bar - G) dt^2 times it.
// Explicit steps (ADR 49) need an inertia without neighbours, and run oscillators too fast: epsilon = -1/12. Theirs is
// made up for in K, by K - dt^2/12 K M^-1 K for long waves: with tau = dt^2/(12 rho d^2) the isotropic Q of the moduli
// tau D^2 and tau G^2,
//   Q_nn = Q_tt = tau D^2, Q_nt = tau (D^2 - 2 G^2), Q_shear = tau G^2,
// is added to the other. That is softening of the same sort, of at most a third of the size below the limit of
// stability. The implicit corrections are bounded, which K is not: at their caps short waves keep a third of their
// inertia, and strains a tenth.
#pragma once

#include <vector>

#include "engine/contact/interface.h"
#include "engine/contact/interface_element.h"
#include "engine/core/types.h"
#include "engine/model/model.h"

namespace dda {

namespace mesh {

// The cap on s D/2 in Q_tt over G: a change of shape (1, -1, 0) has Q = s D/2 and an energy of 2 G, of which the jumps
// of the shortest waves would take more where D is far above G.
inline constexpr double most_stabilisation = 1.0 / 3;
// The cap on D over G in Q: D of Poisson's ratio 0.471. Q couples jumps of volume and of shape by D/12, and blocks that
// change shape resist with G alone. Rock nearer to incompressible keeps a part of the error of its P waves; where D was
// left as it is some motions lost all stiffness from 0.49 on.
inline constexpr double most_compression = 18;

// The cap on what is taken from the mass l d rho between neighbours, as a share. Over the sides of a block l d sums up
// to at most four times its area, so short waves would lose all of their inertia at 1/8.
inline constexpr double most_correction = 0.08;
// The cap on (c_p dt/d)^2/12 under explicit steps. Blocks as wide as the narrowest have a tenth of it less at their
// limit of stability.
inline constexpr double most_step_softening = 0.02;
inline constexpr double most_strain_correction = 0.9;  // of the inertia that can be taken from these strains alone

}  // namespace mesh

// Whether an interface is one of such a mesh: consistent, neither block held. `held`: of every block (held_flags).
bool is_in_mesh(const std::vector<bool>& held, const InterfaceElement& element);

// Says by how much jumps are softened.
struct JumpSoftening {
  bool for_blocks = false;  // for the size of blocks
  double for_steps = 0;     // for explicit steps: 1/12 times dt^2, s^2

  [[nodiscard]] bool acts() const { return for_blocks || for_steps > 0; }
};

// The stiffness of strains' jumps: zero between unlike materials, where strains do jump, and beside non-convex blocks.
InterfaceMatrices jump_stiffness(const Model& model, const Interface& interface,
                                 const JumpSoftening& softening = {true, 0});

// The share of what explicit steps ask for that an interface has: 1, or less where it is capped.
double jump_share(const Model& model, const Interface& interface, const JumpSoftening& softening);

// The inertia added between the centroids. `period_error`: epsilon of the integrator (wave_corrections.h).
InterfaceMatrices mesh_inertia(const Model& model, const Interface& interface, double period_error, double dt);

// What is taken from the inertia of a block's strains: of the dilatation in a mesh, of e_nn in a chain along a normal.
// `strain_inertia`: see Stage.
Mat6 dilatation_reduction(const Model& model, int block, double strain_inertia, double period_error, double dt);
Mat6 axial_reduction(const Model& model, int block, const Vec2& normal, double strain_inertia, double period_error,
                     double dt);

// By how much loads beside the interface are sharpened: see LoadFilter.
double mesh_load_sharpening(const Model& model, const Interface& interface, double period_error, double dt);

}  // namespace dda
