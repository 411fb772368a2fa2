// The thesis' bar as a finite chain of identical rectangular blocks: the data of the discrete problem, nothing solved.
//
// Blocks are `length` x `height` (m, thickness 1 m) with unknowns (u0, ex, ey): by symmetry about the bar's axis v0, r0
// and gxy vanish. Between blocks j and j+1
//   normal gap       g = u_(j+1) - L/2 ex_(j+1) - u_j - L/2 ex_j
//   tangential half  w = h/2 (ey_(j+1) - ey_j)   (half the difference of the tangential gaps of the two corners)
//   potential        V = k g^2/2 + [consistent] h {sigma_x} g + k_t w^2/2
// with {sigma_x} the mean of the two blocks' stresses; the interface carries N = dV/dg, tension positive.
//
// The cubic law (Hermite chain) has instead, over the cell from centroid to centroid, the axial displacement w(x) that
// is cubic with w = u, w' = ex at both centroids. The strain that it adds to the block it lies in contracts sideways
// freely: eps_y(x) = ey - e12/e11 (w'(x) - ex). With Q = e11 - e12^2/e11 (bar with free sides) each half then adds
//   h integral of Q ex (w' - ex) + Q (w' - ex)^2/2,   Q ex = sigma_x - e12/e11 sigma_y of that block,
// to V = k g^2/2 + k_t w^2/2, and the inertia of w replaces that of the two straight lines. A chain so stores
//   h integral of Q w'^2/2  +  sum over blocks of h L e11 (ey + e12/e11 ex)^2/2.
//
// From the last centroid to a face that nothing holds (the left one, under the load; the right one if it is free) a
// cubic chain has straight lines, whose strain counts by the share s = (10 - sqrt(2))/12 alone: h L/2 Q ex^2/2 is
// multiplied by s, and so is the part of ex in the work of the load. See end_share() for why.
#pragma once

#include <vector>

namespace exact {

// sigma_x = e11 ex + e12 ey and likewise for y (Pa).
struct PlaneElasticity {
  double e11 = 0;
  double e12 = 0;
};
[[nodiscard]] PlaneElasticity plane_stress(double young, double poisson);
[[nodiscard]] PlaneElasticity plane_strain(double young, double poisson);

struct InterfaceLaw {
  double normal = 0;           // k (N/m) of the whole interface; may be 0 for the cubic law
  double tangential_half = 0;  // k_t (N/m)
  bool consistent = false;     // with the flux term of Nitsche's method
  bool cubic = false;          // cubic displacement across the interface; excludes `consistent`
  // Cubic only, co (-): the kinetic energy is lowered by
  //   rho h L/2 (co (u0_(j+1)' - u0_j')^2 + min(co, 0.05) L^2 (ex_(j+1)' - ex_j')^2/12)   (velocities).
  double inertia_reduction = 0;
};
// Classical DDA: a normal and a shear spring (N/m each) at each of the two corners.
[[nodiscard]] InterfaceLaw corner_springs(double normal_spring, double shear_spring);
// Symmetric Nitsche edge: stiffness (N/m) of the gap at mid-edge and of the tangential half-difference.
[[nodiscard]] InterfaceLaw consistent_edge(double mid, double tangential_half);
// The cubic law without further stiffness; see inertia_reduction() for its argument.
[[nodiscard]] InterfaceLaw cubic_edge(double inertia_reduction = 0);

struct BlockChain {
  int blocks = 1;
  double length = 1;   // m, of one block
  double height = 1;   // m
  double density = 0;  // kg/m3
  PlaneElasticity elasticity;
  InterfaceLaw interface;
  // Inertia of ex and ey: factor rho h L^3/12 and factor rho L h^3/12. 1: consistent; 2: averaged consistent/lumped.
  double inertia_factor = 1;
  double lateral_inertia = 1;  // further factor on the inertia of ey; 0: ey follows without inertia
  // Right end, acting on the centre of its face; both zero: free.
  double end_stiffness = 0;  // N/m
  double end_impedance = 0;  // N s/m, ratio rho c h for a dashpot of that ratio to the bar's impedance
};

// Q (Pa): axial modulus of a bar whose sides are free.
[[nodiscard]] double bar_modulus(const PlaneElasticity& elasticity);

// co = min(period_error (c dt/L)^2, 0.1), c^2 = Q/rho, lifts the chain's frequencies by the share that a time scheme of
// that period_error() takes away: with k = kappa L the mean of (u0_(j+1)' - u0_j')^2 is (k^2 - k^4/12) u0'^2, that of
// L^2 (ex_(j+1)' - ex_j')^2/12 is k^4/12 u0'^2, so the sum is k^2 u0'^2 up to k^6.
[[nodiscard]] double inertia_reduction(const BlockChain& chain, double period_error, double dt);
// min(co, 0.05) of the term in ex.
[[nodiscard]] double jump_inertia_reduction(const InterfaceLaw& law);

enum class Face { left, right };

// s of a face, 1 where it is held and in chains without the cubic law. With k = omega L/(2 c) and lengths in L/2, a
// wave exp(-i k x) of unit force at the face has the residual -(1/2 - s) k^2 U in the equation of ex and k^4 U/6 in
// that of u. A residual r in the former moves the end by r/(s + sqrt(2)/6), where sqrt(2)/6 is the static stiffness of
// the chain against its first slope (cubic Hermite elements: slopes decay by 3 - sqrt(8) a block). The reflection is
// right to third order in k if (s - 2/3)(s + sqrt(2)/6) = (s - 1/2)^2.
[[nodiscard]] double end_share(const BlockChain& chain, Face face);
// By what the inertia of ex is lowered at such a face, over rho h L^3/12: the correction of `inertia_reduction` there,
// min(co, 0.05) times stiffness over (c/L)^2. 0 where the share is 1.
[[nodiscard]] double end_inertia_reduction(const BlockChain& chain, Face face);

enum class ChainQuantity {
  block_stress,  // sigma_x of block `index` (Pa), index 0..blocks-1
  // N between blocks `index` and `index + 1` (N), index 0..blocks-2; cubic law: h Q ({ex} + 3/2 g/L), the height
  // times the stress of the cubic at the interface.
  interface_force,
  displacement,      // u0 of block `index` (m)
  interface_stress,  // interface_force/height (Pa)
};

struct ChainProbe {
  ChainQuantity quantity = ChainQuantity::block_stress;
  int index = 0;
};

// One history per probe, each with a value per sample of the load (the first is the state of rest).
using ChainHistories = std::vector<std::vector<double>>;

// Throws std::invalid_argument unless sizes, density and stiffnesses are positive, the interface is not both cubic and
// consistent, and every probe exists.
void check(const BlockChain& chain, const std::vector<ChainProbe>& probes);

}  // namespace exact
