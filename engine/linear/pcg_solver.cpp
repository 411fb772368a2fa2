#include "engine/linear/pcg_solver.h"

#include <Eigen/Cholesky>
#include <utility>
#include <vector>

#include "engine/linear/block_vectors.h"
#include "engine/linear/different_blocks.h"
#include "engine/linear/small_inverse.h"

namespace dda {

void PcgSolver::do_analyze(const BlockMatrix& matrix) {
  factor_is_laid_out_ = false;
  inverse_product_.reset();
  for (Eigen::VectorXd* vector : {&residual_, &preconditioned_}) vector->resize(matrix.unknowns());
  iteration_.resize(matrix.unknowns());
  if (!may_share_inverses()) lay_out_factor(matrix);
}

void PcgSolver::lay_out_factor(const BlockMatrix& matrix) {
  if (!factor_is_laid_out_) factor_.analyze(matrix, options_.fill_level);
  factor_is_laid_out_ = true;
}

Status PcgSolver::do_factorize(const BlockMatrix& matrix) {
  matrix_ = &matrix;
  checked_iterations_ = -1;
  inverse_product_.reset();
  if (may_share_inverses()) share_inverses();
  if (!inverse_product_) {
    lay_out_factor(matrix);
    if (!factor_.factorize(matrix)) return Status::singular;
  }
  if (options_.matrix_stays) product_.emplace(matrix);
  return Status::ok;
}

// In double precision, which a few different blocks cost nothing. Where one of them is not positive definite it is left
// to the factor to say so.
void PcgSolver::share_inverses() {
  std::vector<Mat6> blocks;
  std::vector<int> which(static_cast<std::size_t>(matrix_->size()));
  DifferentBlocks numbers(blocks);
  for (int i = 0; i < matrix_->size(); ++i) {
    which[static_cast<std::size_t>(i)] = numbers.number_of(matrix_->diagonal(i));
    if (2 * blocks.size() >= which.size()) return;
  }
  for (Mat6& block : blocks) {
    if (Mat6 inverse; !invert_block(block, inverse)) return;
    block = block.llt().solve(Mat6::Identity()).eval();
  }
  inverse_product_.emplace(which, std::move(blocks));
}

void PcgSolver::multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
  product_ ? product_->multiply(x, y) : matrix_->multiply(x, y);
}

Status PcgSolver::do_factorize_part(const BlockMatrix& matrix, const BlockPart& part) {
  lay_out_factor(matrix);
  return factor_.factorize(matrix, part) ? Status::ok : Status::singular;
}

// A guess that is many times the solution leaves round-off of its own size, which no iteration takes away: where the
// answer to one is not true the way begins at zero.
Status PcgSolver::do_solve(const Eigen::VectorXd& rhs, Eigen::VectorXd& x) {
  const bool is_from_a_guess = !x.isZero(0);
  bool is_true = true;
  const Status status = iterate(rhs, x, is_true);
  if (is_true || !is_from_a_guess) return status;
  x.setZero();
  return iterate(rhs, x, is_true);
}

Status PcgSolver::iterate(const Eigen::VectorXd& rhs, Eigen::VectorXd& x, bool& is_true) {
  const auto times = [this](const Eigen::VectorXd& v, Eigen::VectorXd& w) { multiply(v, w); };
  const auto precondition = [this](const Eigen::VectorXd& r, Eigen::VectorXd& z) { return do_precondition(r, z); };
  const KrylovResult result =
      iteration_.solve(times, precondition, rhs, options_.relative_residual, options_.max_iterations, x);
  count_iterations(result.iterations);
  if (result.status != Status::ok || result.iterations <= checked_iterations_) return result.status;
  is_true = check(rhs, x);
  if (!is_true) return Status::not_converged;
  checked_iterations_ = result.iterations;
  return Status::ok;
}

// The residual that the iteration carries along parts from the true one where the condition of the matrix nears the
// precision of the numbers, the further the more iterations there are (Greenbaum 1997): a matrix that has been checked
// need not be checked again for a solution that took no more of them.
bool PcgSolver::check(const Eigen::VectorXd& rhs, const Eigen::VectorXd& x) {
  multiply(x, residual_);
  in_stretches(rhs.size(), [&](const VectorStretch& here) { here.of(residual_) = here.of(rhs) - here.of(residual_); });
  const double norm = do_precondition(residual_, preconditioned_);
  const double limit = options_.true_residual * options_.true_residual * do_precondition(rhs, preconditioned_);
  return norm <= limit;
}

double PcgSolver::do_precondition(const Eigen::VectorXd& r, Eigen::VectorXd& z) {
  if (!inverse_product_) return factor_.apply(r, z);
  inverse_product_->multiply(r, z, Phase::preconditioner);
  return dot(r, z);
}

}  // namespace dda
