// The oracle of the other solvers: Eigen's dense Cholesky factorization. O(n^3) work, O(n^2) memory; allocates.
#pragma once

#include <memory>

#include "engine/linear/solver.h"

namespace dda {

// The full symmetric 6n x 6n matrix.
[[nodiscard]] Eigen::MatrixXd to_dense(const BlockMatrix& matrix);

class DenseSolver final : public LinearSolver {
 public:
  DenseSolver();
  ~DenseSolver() override;

  [[nodiscard]] bool is_direct() const override { return true; }

 private:
  struct Factor;

  void do_analyze(const BlockMatrix& matrix) override;
  Status do_factorize(const BlockMatrix& matrix) override;
  Status do_solve(const Eigen::VectorXd& rhs, Eigen::VectorXd& x) override;

  std::unique_ptr<Factor> factor_;
};

}  // namespace dda
