// Conjugate gradients with an incomplete factor: needs work and memory in proportion to the number of blocks, where
// inertia reaches over a few blocks only.
#pragma once

#include <optional>

#include "engine/linear/constant_operator.h"
#include "engine/linear/incomplete_cholesky.h"
#include "engine/linear/krylov.h"
#include "engine/linear/solver.h"

namespace dda {

struct PcgOptions {
  // Stop when the residual r is this small against the right-hand side b, both in the norm sqrt(r^T M^-1 r) with M the
  // preconditioner: that norm does not mix up m, rad and strain, and comes free with the iteration. 1e-12 because
  // errors of steps add up, and histories are to agree with exact ones to 1e-9 after a thousand steps. Measured on
  // bonded grids, x then differs from the direct solution by 4e-12 at most up to chi = 2000, where round-off already
  // keeps the true residual at 6e-12 to 1e-11 (that of the factorization: 1e-12).
  double relative_residual = 1e-12;
  int max_iterations = 5000;
  // Generations of fill in the incomplete factor; IncompleteCholesky::diagonal takes the diagonal blocks only.
  int fill_level = IncompleteCholesky::diagonal;
  // The matrix serves many solutions: it is laid out for products once it is factored.
  bool matrix_stays = false;
  // Beyond this residual, measured at the end in the same norm, a solve fails: what round-off has left is of no use.
  double true_residual = 1e-8;
};

class PcgSolver final : public LinearSolver {
 public:
  explicit PcgSolver(const PcgOptions& options = {}) : options_(options) {}

  [[nodiscard]] bool takes_parts() const override { return true; }
  [[nodiscard]] bool needs_matrix() const override { return !product_ || !product_->has_rows(); }

 private:
  void do_analyze(const BlockMatrix& matrix) override;
  Status do_factorize(const BlockMatrix& matrix) override;
  Status do_factorize_part(const BlockMatrix& matrix, const BlockPart& part) override;
  Status do_solve(const Eigen::VectorXd& rhs, Eigen::VectorXd& x) override;
  double do_precondition(const Eigen::VectorXd& r, Eigen::VectorXd& z) override;

  // Whether diagonal blocks are the preconditioner, of a matrix that stays: equal ones then have one inverse.
  [[nodiscard]] bool may_share_inverses() const {
    return options_.matrix_stays && options_.fill_level == IncompleteCholesky::diagonal;
  }
  void share_inverses();
  void lay_out_factor(const BlockMatrix& matrix);
  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const;
  // `is_true`: false where the solution is not what the iteration takes it for.
  [[nodiscard]] Status iterate(const Eigen::VectorXd& rhs, Eigen::VectorXd& x, bool& is_true);
  [[nodiscard]] bool check(const Eigen::VectorXd& rhs, const Eigen::VectorXd& x);

  PcgOptions options_;
  const BlockMatrix* matrix_ = nullptr;
  IncompleteCholesky factor_;  // where equal inverses are not shared
  bool factor_is_laid_out_ = false;
  // A matrix that stays, laid out for products, and its diagonal blocks' inverses where these are the preconditioner.
  std::optional<ConstantOperator> product_;
  std::optional<ConstantOperator> inverse_product_;
  int checked_iterations_ = -1;  // the most that a checked solution with this factor took
  ConjugateGradients iteration_;
  Eigen::VectorXd residual_, preconditioned_;
};

}  // namespace dda
