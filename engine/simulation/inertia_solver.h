// Accelerations from forces, for steps that have no other system to solve: A a = f where A is the inertia, or the
// inertia and what dampers add to it in a step, M + dt/2 C.
//
// Where inertia does not couple blocks that is a product with a 6x6 inverse for each, and blocks that are equal to the
// last bit share one. Along cubic chains it couples neighbours; A is then factored once, and the factor of a chain has
// no more entries than A.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <vector>

#include "engine/core/status.h"
#include "engine/core/types.h"
#include "engine/linear/block_matrix.h"
#include "engine/linear/solver.h"
#include "engine/solve/held_unknowns.h"

namespace dda {

class InertiaSolver {
 public:
  // `inertia`: A. Held blocks get no acceleration. Status::singular where A is not positive definite.
  [[nodiscard]] Status set_up(BlockMatrix inertia, const HeldUnknowns& held);

  // One block at a time will do, by inverse().
  [[nodiscard]] bool is_by_blocks() const { return !solver_; }
  // Zero for held blocks.
  [[nodiscard]] const Mat6& inverse(std::size_t block) const {
    return inverses_[static_cast<std::size_t>(which_[block])];
  }

  // All blocks, 6 entries each; `acceleration` is read as a guess. Allocates nothing.
  [[nodiscard]] Status solve(const Eigen::VectorXd& force, Eigen::VectorXd& acceleration);

 private:
  [[nodiscard]] Status invert_blocks(const BlockMatrix& inertia, const HeldUnknowns& held);

  std::vector<Mat6> inverses_;
  std::vector<int> which_;               // of every block, in inverses_
  std::unique_ptr<BlockMatrix> matrix_;  // only where blocks are coupled, as the next
  std::unique_ptr<LinearSolver> solver_;
};

}  // namespace dda
