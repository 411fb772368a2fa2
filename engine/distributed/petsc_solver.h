// Conjugate gradients of PETSc, shared among the processes of mpirun: what LinearSolver is to the engine.
#pragma once

#include <memory>

#include "engine/distributed/order.h"
#include "engine/distributed/row_share.h"
#include "engine/linear/incomplete_cholesky.h"
#include "engine/linear/solver.h"

namespace dda {

// Lives in the first process. Stops where PcgSolver does. Its preconditioner is made of an incomplete factor for each
// process, so that iterations depend on their number, and results on it within the tolerance of the iteration. A part
// is factored and used by the first process alone: parts are small.
//
// Allocates in factorize and solve what PETSc does.
class PetscSolver final : public LinearSolver {
 public:
  explicit PetscSolver(const PcgOptions& options = {});
  ~PetscSolver() override;

  [[nodiscard]] bool takes_parts() const override { return true; }
  // Each process has its rows; but who changes the matrix wants it back.
  [[nodiscard]] bool needs_matrix() const override { return !options_.matrix_stays; }

 private:
  void do_analyze(const BlockMatrix& matrix) override;
  Status do_factorize(const BlockMatrix& matrix) override;
  Status do_factorize_part(const BlockMatrix& matrix, const BlockPart& part) override;
  Status do_solve(const Eigen::VectorXd& rhs, Eigen::VectorXd& x) override;
  double do_precondition(const Eigen::VectorXd& r, Eigen::VectorXd& z) override;

  PcgOptions options_;
  int number_;
  std::unique_ptr<RowShare> share_;
  bool is_known_ = false;  // to the other processes
  IncompleteCholesky part_factor_;
  bool part_factor_is_laid_out_ = false;
};

std::unique_ptr<LinearSolver> make_petsc_solver(const PcgOptions& options);

}  // namespace dda
