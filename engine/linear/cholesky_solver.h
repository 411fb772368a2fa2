// Sparse Cholesky factorization: exact to round-off at any chi, and by far the cheapest once a factor can be reused.
#pragma once

#include <memory>

#include "engine/linear/incomplete_cholesky.h"
#include "engine/linear/solver.h"

namespace dda {

// Backed by CHOLMOD, or by Eigen's SimplicialLLT in a build without GPL parts (DDA_WITH_CHOLMOD=OFF).
// A warm solve never allocates, and neither does a warm simplicial factorization with CHOLMOD; a supernodal one, and
// any with Eigen, allocate work space inside of those libraries. Throws std::bad_alloc where CHOLMOD runs out of
// memory.
//
// A part of the blocks has an incomplete factor, which is laid out when the first part is factored after an analysis:
// a part is another one each time, and to order and lay out a complete factor takes longer than to compute it.
class CholeskySolver final : public LinearSolver {
 public:
  CholeskySolver();
  ~CholeskySolver() override;

  // What the analysis found: nonzeros of the factor, floating-point operations to compute it, and whether it is kept in
  // supernodes (dense BLAS blocks) or column by column.
  struct FactorFacts {
    double nonzeros = 0;
    double flops = 0;
    bool supernodal = false;
  };
  [[nodiscard]] FactorFacts factor_facts() const;

  [[nodiscard]] bool takes_parts() const override { return true; }
  [[nodiscard]] bool is_direct() const override { return true; }

 private:
  struct Implementation;

  void do_analyze(const BlockMatrix& matrix) override;
  Status do_factorize(const BlockMatrix& matrix) override;
  Status do_factorize_part(const BlockMatrix& matrix, const BlockPart& part) override;
  Status do_solve(const Eigen::VectorXd& rhs, Eigen::VectorXd& x) override;
  double do_precondition(const Eigen::VectorXd& r, Eigen::VectorXd& z) override;

  void order_and_lay_out(const BlockMatrix& matrix);

  std::unique_ptr<Implementation> implementation_;
  IncompleteCholesky part_factor_;
  bool part_factor_is_laid_out_ = false;
};

}  // namespace dda
