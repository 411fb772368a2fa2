#include "dda/linear/solver_choice.h"

#include "dda/linear/cholesky_solver.h"
#include "dda/linear/dense_solver.h"
#include "dda/linear/pcg_solver.h"

namespace dda {

SolverKind choose_solver(const SolverScene&) { return SolverKind::cholesky; }

std::unique_ptr<LinearSolver> make_solver(SolverKind kind) {
  switch (kind) {
    case SolverKind::pcg: return std::make_unique<PcgSolver>();
    case SolverKind::dense: return std::make_unique<DenseSolver>();
    case SolverKind::cholesky: break;
  }
  return std::make_unique<CholeskySolver>();
}

}  // namespace dda
