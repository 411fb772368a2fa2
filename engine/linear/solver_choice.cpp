#include "engine/linear/solver_choice.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "engine/linear/cholesky_solver.h"
#include "engine/linear/dense_solver.h"
#include "engine/linear/over_processes.h"
#include "engine/linear/pcg_solver.h"

namespace dda {

namespace {

bool is_chain_like(const SolverScene& scene) { return scene.couplings <= 1.1 * scene.blocks; }

int fill_level(double chi) { return has_incomplete_factor(chi) ? 1 : IncompleteCholesky::diagonal; }

// Incomplete factors are kept in single precision (incomplete_cholesky.h).
constexpr double most_in_single_precision = 1e6;

constexpr double with_factor = 2, with_diagonal_blocks = 67;  // iterations for each unit of sqrt(chi)

// The iterations of PCG that take as long as a direct solution: see the table in the README.
double affordable_iterations(const SolverScene& scene) {
  if (scene.matrix_changes_every_step) return is_chain_like(scene) ? 20 : 17 * std::cbrt(scene.blocks);
  if (is_chain_like(scene)) return 1;
  const bool complete_factor_leaves_cache = scene.blocks > 5000;
  if (has_incomplete_factor(scene.chi.largest)) return complete_factor_leaves_cache ? 9 : 3;
  return complete_factor_leaves_cache ? 20 : 4;
}

PcgOptions options_for(double chi, MatrixUse use) {
  return {.fill_level = fill_level(chi), .matrix_stays = use == MatrixUse::stays};
}

std::unique_ptr<LinearSolver> make_over_processes(const PcgOptions& options) {
  if (!over_processes().make) throw std::logic_error("make_solver: this program has no PETSc");
  return over_processes().make(options);
}

// A matrix that changes every step belongs to blocks that go their ways. There splinters do not count, as an incomplete
// factor does with each what a complete one would do, up to where single precision no longer tells its inertia.
double iterations_that_count(const SolverScene& scene) {
  if (!scene.matrix_changes_every_step) return expected_iterations(scene.chi.largest);
  if (!(scene.chi.largest <= most_in_single_precision)) return std::numeric_limits<double>::infinity();
  // Where a factor serves one step alone diagonal blocks are of use as long as steps are short.
  return 3 + with_factor * std::sqrt(scene.chi.of_most);
}

}  // namespace

bool has_incomplete_factor(double chi) { return chi >= 0.1; }

double expected_iterations(double chi) {
  return 3 + (has_incomplete_factor(chi) ? with_factor : with_diagonal_blocks) * std::sqrt(chi);
}

std::string in_words(const StiffnessNumbers& chi) {
  const std::string of_most = chi.of_most < chi.largest / 2 ? fmt::format(", of most {:.3g}", chi.of_most) : "";
  return fmt::format("chi = {:.3g}", chi.largest) + of_most;
}

SolverKind choose_solver(const SolverScene& scene) {
  const double expected = iterations_that_count(scene);
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
