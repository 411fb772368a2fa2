// Solving A x = b for a symmetric positive definite block matrix, with the three stages of the work kept apart so that
// a run pays only for what changed.
#pragma once

#include <cstdint>

#include "engine/core/status.h"
#include "engine/core/types.h"
#include "engine/linear/block_matrix.h"

namespace dda {

struct SolverCounts {
  std::int64_t analyses = 0;
  std::int64_t factorizations = 0;  // numeric factorizations; for an iterative solver, set-ups of its preconditioner
  std::int64_t solves = 0;
  std::int64_t iterations = 0;  // of iterative solvers, summed over the solves
};

// Call order: analyze once per pattern, factorize once per set of values, solve once per right-hand side. A call out of
// order, or with vectors or a matrix of another size than analyzed, throws std::logic_error. Once
// warm (a second factorize and solve after an analyze) nothing is allocated on the heap, unless the implementation says
// otherwise.
class LinearSolver {
 public:
  LinearSolver() = default;
  LinearSolver(const LinearSolver&) = delete;
  LinearSolver& operator=(const LinearSolver&) = delete;
  virtual ~LinearSolver() = default;

  // The pattern changed: orders the blocks and lays out the factor.
  void analyze(const BlockMatrix& matrix);

  // The values changed (same pattern as analyzed). singular: the matrix is not positive definite to working precision
  // (or not finite); there is then no factor to solve with.
  [[nodiscard]] Status factorize(const BlockMatrix& matrix);

  // Factors the rows and columns of a part alone, as if the others were not there: precondition() then keeps to it, and
  // solve() needs a factorize of the whole first. Only solvers that take_parts() can do so.
  [[nodiscard]] Status factorize(const BlockMatrix& matrix, const BlockPart& part);
  [[nodiscard]] virtual bool takes_parts() const { return false; }

  // Solves for x, which comes in with 6n numbers: the starting guess of an iterative solver, ignored by a direct one.
  // `rhs` and `x` are different vectors. not_converged: x holds the last iterate; not_finite: x is of no use.
  [[nodiscard]] Status solve(const Eigen::VectorXd& rhs, Eigen::VectorXd& x);

  // Whether a solution is exact to round-off however far its guess is off, and a factor therefore all that it costs.
  [[nodiscard]] virtual bool is_direct() const { return false; }

  // Whether solutions look at the matrix that was factored: it must then live, unchanged and in place, until the last.
  [[nodiscard]] virtual bool needs_matrix() const { return true; }

  // z = P^-1 r and returns r . z, P being what the solver knows of the inverse: all of it where it factors, else its
  // preconditioner, symmetric positive definite.
  double precondition(const Eigen::VectorXd& r, Eigen::VectorXd& z);

  [[nodiscard]] const SolverCounts& counts() const { return counts_; }

 protected:
  // What was factored last was a part.
  [[nodiscard]] bool is_of_part() const { return part_factored_; }
  void count_iterations(int iterations) { counts_.iterations += iterations; }

 private:
  virtual void do_analyze(const BlockMatrix& matrix) = 0;
  virtual Status do_factorize(const BlockMatrix& matrix) = 0;
  virtual Status do_factorize_part(const BlockMatrix& matrix, const BlockPart& part);
  virtual Status do_solve(const Eigen::VectorXd& rhs, Eigen::VectorXd& x) = 0;
  virtual double do_precondition(const Eigen::VectorXd& r, Eigen::VectorXd& z);

  void check_matrix(const BlockMatrix& matrix) const;
  void check_vectors(bool factored, const Eigen::VectorXd& rhs, const Eigen::VectorXd& x) const;

  SolverCounts counts_;
  Eigen::Index unknowns_ = -1;  // -1: not analyzed
  int couplings_ = 0;
  bool factored_ = false;
  bool part_factored_ = false;
};

}  // namespace dda
