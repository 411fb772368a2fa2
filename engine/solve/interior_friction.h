// Coulomb's law in interior passes (interior_passes.h): capacities that follow the pressures.
//
// When the capacity c(f) of a tangential row changes by dc = c'(f) df its shear does so by
//   S (z/(c - t) - y/(c + t)) dc,   S the stiffness that the matrix sees
// beyond what a given capacity makes of it: by all of dc where the row slides, by nothing where it sticks. With df by
// the gaps of the normal rows this is a part of the matrix that is not symmetric. GMRES takes it in, with the factor of
// the symmetric part for its preconditioner. Without that part the passes stall (ADR 70).
//
// Of a projected stretch on its bed either point has of the friction what it has of the pressure, and one that pulls
// has none: c has a kink there, at which steps would end that take it for a line. It is rounded off by forces of the
// size of sqrt(mu k), as products leave of other forces too:
//   c_1 = tan(phi) (P_1 + P_2 + r_1 - r_2)/2,   r = sqrt(P^2 + 0.1 mu k),   P the pressures of the points
// which is positive whatever the pressures of the ends, and in sum the friction of the whole.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "engine/contact/point_kinematics.h"
#include "engine/core/status.h"
#include "engine/linear/krylov.h"
#include "engine/solve/interior_rows.h"
#include "engine/solve/iterate.h"

namespace dda {

class InteriorFriction {
 public:
  // Whether friction is given, or all that capacities are. (Cohesion goes at once where an end opens.)
  [[nodiscard]] static bool serves(const Iterate& at);

  // A step begins. Its friction follows the pressures unless it is given: capacities then stay what they are, and
  // nothing is coupled.
  void begin(const Iterate& at);
  [[nodiscard]] bool follows() const { return follows_; }

  // Sets capacities of tangential rows to those of these forces (of all contacts), rounded off by products of this
  // mean.
  void take_capacities(const Iterate& at, std::span<const Vec4> forces, double product, std::span<InteriorRow> rows);
  // Couples shear forces to normal gaps as the shares of all rows are in the matrix that was factored.
  void couple(const Iterate& at, std::span<const InteriorBed> beds, std::span<const InteriorRow> rows);

  // Where the lengths of all rows are eliminated: adds to the constants of tangential ones what their forces change by
  // with the constants of normal ones.
  void eliminate(const Iterate& at, std::span<const InteriorBed> beds, std::span<InteriorRow> rows);
  // Solves for the increments `step` of a pass, less well where it only predicts.
  [[nodiscard]] Status solve(Iterate& at, const Eigen::VectorXd& rhs, bool corrects, Eigen::VectorXd& step);
  // The same for the steps of normal ones, once these are known, in place of their constants.
  void follow(const Iterate& at, std::span<const InteriorBed> beds, std::span<InteriorRow> rows);

 private:
  // How both shear forces of a contact follow the gaps of its normal rows, N/m per m of thickness.
  struct Coupling {
    int block_a, block_b;
    PointKinematics points;
    Mat2 shear_by_gap;
  };

  template <double InteriorRow::*change>
  void note_changes(const Iterate& at, std::span<const InteriorBed> beds, std::span<const InteriorRow> rows);
  template <double InteriorRow::*change>
  void follow_changes(const Iterate& at, std::span<const InteriorBed> beds, std::span<InteriorRow> rows);
  void multiply(const Iterate& at, const Eigen::VectorXd& v, Eigen::VectorXd& w) const;

  static constexpr int basis = 40;  // of GMRES

  bool follows_ = false;
  // Those of all contacts:
  std::vector<Mat2> by_forces_;  // how the capacities of both ends follow both normal forces
  std::vector<Vec2> changes_;    // of the normal forces of both ends, N per m of thickness
  std::vector<Mat2> normals_;    // how the normal forces of both ends follow both gaps, N/m per m of thickness
  std::vector<Coupling> couplings_;
  Gmres gmres_{basis};
};

}  // namespace dda
