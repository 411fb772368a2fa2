// Conjugate gradients preconditioned with the inverses of the diagonal blocks: the cheapest solver where inertia holds
// the blocks more than their neighbours do (small chi), and it needs no factor.
#pragma once

#include <vector>

#include "dda/linear/solver.h"

namespace dda {

struct PcgOptions {
  // Stop when the residual r is this small against the right-hand side b, both in the norm sqrt(r^T M^-1 r) with M the
  // block diagonal of A: that norm does not mix up m, rad and strain, and comes free with the iteration. 1e-12 because
  // errors of steps add up, and histories are to agree with exact ones to 1e-9 after a thousand steps. Measured on
  // bonded grids, x then differs from the direct solution by 4e-12 at most up to chi = 2000, where round-off already
  // keeps the true residual at 6e-12 to 1e-11 (that of the factorization: 1e-12).
  double relative_residual = 1e-12;
  // About 67 sqrt(chi) iterations are needed at most, so this serves up to chi = 5000.
  int max_iterations = 5000;
};

class PcgSolver final : public LinearSolver {
 public:
  explicit PcgSolver(const PcgOptions& options = {}) : options_(options) {}

 private:
  void do_analyze(const BlockMatrix& matrix) override;
  Status do_factorize(const BlockMatrix& matrix) override;
  Status do_solve(const Eigen::VectorXd& rhs, Eigen::VectorXd& x) override;

  double precondition(const Eigen::VectorXd& residual);
  double advance(double step, Eigen::VectorXd& x);
  Status iterate(double target, double residual_norm, Eigen::VectorXd& x);

  PcgOptions options_;
  const BlockMatrix* matrix_ = nullptr;
  std::vector<Mat6> inverse_blocks_;
  Eigen::VectorXd residual_;
  Eigen::VectorXd preconditioned_;
  Eigen::VectorXd direction_;
  Eigen::VectorXd image_;  // A * direction
};

}  // namespace dda
