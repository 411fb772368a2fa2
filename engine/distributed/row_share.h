// What one process holds of a system: some consecutive rows of blocks, in PETSc's matrices and vectors.
#pragma once

#include <memory>

#include "engine/core/status.h"
#include "engine/linear/block_matrix.h"
#include "engine/linear/pcg_solver.h"

namespace dda {

struct SharedSolution {
  Status status = Status::ok;
  int iterations = 0;
};

// All processes call the same, in the same order; what is handed over counts in the first alone, and is null in the
// others. Throws std::runtime_error where PETSc fails.
class RowShare {
 public:
  explicit RowShare(const PcgOptions& options);
  ~RowShare();
  RowShare(const RowShare&) = delete;
  RowShare& operator=(const RowShare&) = delete;

  void analyze(int blocks, const BlockMatrix* whole);

  // False where a diagonal block is not positive definite.
  [[nodiscard]] bool factorize(const BlockMatrix* whole);

  // Vectors of the whole system; `x` brings the guess, where there is one.
  [[nodiscard]] SharedSolution solve(bool has_guess, const double* rhs, double* x);

  // z = P^-1 r.
  void precondition(const double* r, double* z);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace dda
