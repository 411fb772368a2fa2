#include "engine/distributed/petsc_solver.h"

#include <atomic>
#include <exception>
#include <mutex>

#include "engine/distributed/ranks.h"
#include "engine/linear/block_vectors.h"

namespace dda {
namespace {

std::atomic<int> solvers_so_far = 0;
std::mutex in_turn;  // threads of the first process

// What all processes do at once. Where it fails in the first, the others wait for a message that will not come.
template <typename Act>
void together(const Order& order, const Act& act) {
  const std::lock_guard lock(in_turn);
  Ranks::give(order);
  try {
    act();
  } catch (const std::exception& error) {
    if (Ranks::count() > 1) Ranks::give_up(error.what());
    throw;
  }
}

}  // namespace

PetscSolver::PetscSolver(const PcgOptions& options)
    : options_(options), number_(solvers_so_far++), share_(std::make_unique<RowShare>(options)) {}

PetscSolver::~PetscSolver() {
  if (!is_known_) return;
  const std::lock_guard lock(in_turn);
  Ranks::give({.task = Task::forget, .solver = number_});
  share_.reset();
}

void PetscSolver::do_analyze(const BlockMatrix& matrix) {
  part_factor_is_laid_out_ = false;
  is_known_ = true;
  together({.task = Task::analyze, .solver = number_, .blocks = matrix.size(), .options = options_},
           [&] { share_->analyze(matrix.size(), &matrix); });
}

Status PetscSolver::do_factorize(const BlockMatrix& matrix) {
  bool is_sound = false;
  together({.task = Task::factorize, .solver = number_}, [&] { is_sound = share_->factorize(&matrix); });
  return is_sound ? Status::ok : Status::singular;
}

Status PetscSolver::do_factorize_part(const BlockMatrix& matrix, const BlockPart& part) {
  if (!part_factor_is_laid_out_) part_factor_.analyze(matrix, options_.fill_level);
  part_factor_is_laid_out_ = true;
  return part_factor_.factorize(matrix, part) ? Status::ok : Status::singular;
}

Status PetscSolver::do_solve(const Eigen::VectorXd& rhs, Eigen::VectorXd& x) {
  if (rhs.isZero(0)) x.setZero();
  SharedSolution solution;
  const bool has_guess = !x.isZero(0);
  together({.task = Task::solve, .solver = number_, .has_guess = has_guess},
           [&] { solution = share_->solve(has_guess, rhs.data(), x.data()); });
  count_iterations(solution.iterations);
  return solution.status;
}

double PetscSolver::do_precondition(const Eigen::VectorXd& r, Eigen::VectorXd& z) {
  if (is_of_part()) return part_factor_.apply(r, z);
  together({.task = Task::precondition, .solver = number_}, [&] { share_->precondition(r.data(), z.data()); });
  return dot(r, z);
}

std::unique_ptr<LinearSolver> make_petsc_solver(const PcgOptions& options) {
  return std::make_unique<PetscSolver>(options);
}

}  // namespace dda
