// Which solver a scene gets, by a rule that can be printed and argued with.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "engine/linear/solver.h"

namespace dda {

enum class SolverKind { cholesky, pcg, dense, petsc };

constexpr std::string_view to_string(SolverKind kind) {
  switch (kind) {
    case SolverKind::cholesky: return "cholesky";
    case SolverKind::pcg: return "pcg";
    case SolverKind::dense: return "dense";
    case SolverKind::petsc: return "petsc";
  }
  return "unknown";
}

// Whether it starts from a guess, and takes the longer the worse that is.
constexpr bool is_iterative(SolverKind kind) { return kind == SolverKind::pcg || kind == SolverKind::petsc; }

// k dt^2/m of the interfaces of a scene: the stiffness of each against the inertia of the lighter of its blocks. Rock
// that is cut at random has splinters whose chi is thousands of times that of the others.
struct StiffnessNumbers {
  double largest = 0;
  double of_most = 0;  // nine interfaces in ten have no more
};

// "chi = 5.19e+03", and for most where that is far less.
std::string in_words(const StiffnessNumbers& chi);

// The facts of a scene that decide.
struct SolverScene {
  int blocks = 0;
  int couplings = 0;                       // coupled pairs of blocks; the couplings per block tell a chain from a grid
  StiffnessNumbers chi = {};               // infinite for a static step
  bool matrix_changes_every_step = false;  // contacts change or rotations are large: a factor serves one step only
};

// PCG where the iterations that chi makes it need are cheaper than what a direct solution costs in this scene: a reused
// factor where the matrix stays, a new factor where it changes every step. The figures behind it are in the README of
// this folder. Never dense, the oracle of tests, nor petsc, which few builds have. Numbers that are not finite give
// cholesky.
SolverKind choose_solver(const SolverScene& scene);

// The preconditioner of PCG: an incomplete factor, or the diagonal blocks where steps are short.
bool has_incomplete_factor(double chi);

// Iterations of PCG to 1e-12 from a zero guess, on chains and grids of any size.
double expected_iterations(double chi);

// Whether a matrix serves many solutions once it is factored, or few.
enum class MatrixUse { changes, stays };

// `chi` decides on the fill of the preconditioner of PCG and of PETSc. Throws std::logic_error for PETSc where the
// program has none (over_processes.h).
std::unique_ptr<LinearSolver> make_solver(SolverKind kind, double chi = 0, MatrixUse use = MatrixUse::changes);

}  // namespace dda
