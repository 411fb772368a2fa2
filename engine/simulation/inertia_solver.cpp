#include "engine/simulation/inertia_solver.h"

#include <Eigen/Cholesky>
#include <utility>

#include "engine/linear/block_vectors.h"
#include "engine/linear/different_blocks.h"
#include "engine/linear/solver_choice.h"

namespace dda {

Status InertiaSolver::set_up(BlockMatrix inertia, const HeldUnknowns& held) {
  solver_.reset();
  matrix_.reset();
  if (inertia.couplings() == 0) return invert_blocks(inertia, held);
  matrix_ = std::make_unique<BlockMatrix>(std::move(inertia));
  HeldCouplings().take_out(held, *matrix_);
  solver_ = make_solver(SolverKind::cholesky);
  solver_->analyze(*matrix_);
  return solver_->factorize(*matrix_);
}

Status InertiaSolver::invert_blocks(const BlockMatrix& inertia, const HeldUnknowns& held) {
  const auto blocks = static_cast<std::size_t>(inertia.size());
  inverses_.clear();
  which_.resize(blocks);
  DifferentBlocks numbers(inverses_);
  for (std::size_t i = 0; i < blocks; ++i) {
    const int block = static_cast<int>(i);
    which_[i] = held.holds(block) ? numbers.number_of(Mat6::Zero()) : numbers.number_of(inertia.diagonal(block));
  }
  for (Mat6& each : inverses_) {
    if (each.isZero(0)) continue;
    const Eigen::LLT<Mat6> factor(each);
    if (factor.info() != Eigen::Success) return Status::singular;
    each = factor.solve(Mat6::Identity());
  }
  return Status::ok;
}

Status InertiaSolver::solve(const Eigen::VectorXd& force, Eigen::VectorXd& acceleration) {
  if (solver_) return solver_->solve(force, acceleration);
  parallel_for_each(which_.size(), blocks_worth_sharing, [&](std::size_t i) {
    const auto at = static_cast<Eigen::Index>(6 * i);
    acceleration.segment<6>(at).noalias() = inverse(i) * force.segment<6>(at);
  });
  return Status::ok;
}

}  // namespace dda
