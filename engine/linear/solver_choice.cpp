#include "engine/linear/solver_choice.h"

#include <cmath>
#include <stdexcept>

#include "engine/linear/cholesky_solver.h"
#include "engine/linear/dense_solver.h"
#include "engine/linear/over_processes.h"
#include "engine/linear/pcg_solver.h"

namespace dda {

namespace {

bool is_chain_like(const SolverScene& scene) { return scene.couplings <= 1.1 * scene.blocks; }

int fill_level(double chi) { return has_incomplete_factor(chi) ? 1 : IncompleteCholesky::diagonal; }

constexpr double with_factor = 2, with_diagonal_blocks = 67;  // iterations for each unit of sqrt(chi)

// The iterations of PCG that take as long as a direct solution: see the table in the README.
double affordable_iterations(const SolverScene& scene) {
  if (scene.matrix_changes_every_step) return is_chain_like(scene) ? 20 : 17 * std::cbrt(scene.blocks);
  if (is_chain_like(scene)) return 1;
  const bool complete_factor_leaves_cache = scene.blocks > 5000;
  if (has_incomplete_factor(scene.chi)) return complete_factor_leaves_cache ? 9 : 3;
  return complete_factor_leaves_cache ? 20 : 4;
}

PcgOptions options_for(double chi, MatrixUse use) {
  return {.fill_level = fill_level(chi), .matrix_stays = use == MatrixUse::stays};
}

std::unique_ptr<LinearSolver> make_over_processes(const PcgOptions& options) {
  if (!over_processes().make) throw std::logic_error("make_solver: this program has no PETSc");
  return over_processes().make(options);
}

}  // namespace

bool has_incomplete_factor(double chi) { return chi >= 0.1; }

double expected_iterations(double chi) {
  return 3 + (has_incomplete_factor(chi) ? with_factor : with_diagonal_blocks) * std::sqrt(chi);
}

SolverKind choose_solver(const SolverScene& scene) {
  // Where a factor serves one step alone diagonal blocks are of use as long as steps are short.
  const double expected =
      scene.matrix_changes_every_step ? 3 + with_factor * std::sqrt(scene.chi) : expected_iterations(scene.chi);
  return expected < affordable_iterations(scene) ? SolverKind::pcg : SolverKind::cholesky;
}

std::unique_ptr<LinearSolver> make_solver(SolverKind kind, double chi, MatrixUse use) {
  switch (kind) {
    case SolverKind::pcg: return std::make_unique<PcgSolver>(options_for(chi, use));
    case SolverKind::petsc: return make_over_processes(options_for(chi, use));
    case SolverKind::dense: return std::make_unique<DenseSolver>();
    case SolverKind::cholesky: break;
  }
  return std::make_unique<CholeskySolver>();
}

}  // namespace dda
