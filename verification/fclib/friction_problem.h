// A frictional contact problem of two dimensions, as FCLIB and Siconos have them:
//
//   M v = H r + f,   u = H^T v + w + D r
//   0 <= u_N, r_N >= 0, u_N r_N = 0;   |r_T| <= mu r_N, and u_T = 0 or r_T = -mu r_N sign(u_T)
//
// with a pair (N, T) of numbers for every contact: r what it presses and holds with, u by how much it has opened and
// slipped. D is the compliance of its springs, which the files of FCLIB do not have: there every spring is two unknowns
// more (fclib_file.h).
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace verify {

using SparseMatrix = Eigen::SparseMatrix<double>;

struct FrictionProblem {
  SparseMatrix mass;           // M
  SparseMatrix directions;     // H: a column for each number of a contact
  Eigen::VectorXd force;       // f
  Eigen::VectorXd gaps;        // w
  Eigen::VectorXd compliance;  // D
  Eigen::VectorXd friction;    // mu, one a contact

  [[nodiscard]] Eigen::Index contacts() const { return friction.size(); }
};

// The same without M and H: u = W r + q.
struct LocalFrictionProblem {
  SparseMatrix delassus;  // W = H^T M^-1 H + D
  Eigen::VectorXd free;   // q = H^T M^-1 f + w
  Eigen::VectorXd friction;
};

[[nodiscard]] LocalFrictionProblem local_problem(const FrictionProblem& problem);

// How far forces r are from an answer, in forces: what Alart and Curnier's projection with the diagonal of W changes
// of them, over the largest force,
//   |r_N - max(0, r_N - u_N/W_NN)|  and  |r_T - clamp(r_T - u_T/W_TT, -mu r_N, mu r_N)|.
// Zero if and only if r is an answer, whichever of them.
[[nodiscard]] double residual(const LocalFrictionProblem& problem, const Eigen::VectorXd& forces);

}  // namespace verify
