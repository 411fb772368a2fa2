#include "engine/distributed/row_share.h"

#include <petscksp.h>

#include <cmath>
#include <cstddef>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/distributed/stretches.h"
#include "engine/linear/incomplete_cholesky.h"

namespace dda {
namespace {

void check(PetscErrorCode code) {
  if (code == 0) return;
  const char* text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  throw std::runtime_error("PETSc: " + std::string(text != nullptr ? text : "error " + std::to_string(code)));
}

// An object of PETSc's, and how it is given back.
template <typename Object, PetscErrorCode (*Destroy)(Object*)>
class Owned {
 public:
  Owned() = default;
  ~Owned() { reset(); }
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  void reset() { static_cast<void>(Destroy(&object_)); }
  // For PETSc to put a new one in.
  Object* fresh() {
    reset();
    return &object_;
  }
  operator Object() const { return object_; }  // NOLINT(google-explicit-constructor): it is one to all that PETSc does

 private:
  Object object_ = nullptr;
};

Eigen::Map<const Eigen::VectorXd> read(Vec vector, const PetscScalar** numbers) {
  PetscInt size = 0;
  check(VecGetLocalSize(vector, &size));
  check(VecGetArrayRead(vector, numbers));
  return {*numbers, size};
}

Status status_of(KSPConvergedReason reason) {
  switch (reason) {
    case KSP_DIVERGED_INDEFINITE_MAT:
    case KSP_DIVERGED_INDEFINITE_PC: return Status::singular;
    case KSP_DIVERGED_NANORINF: return Status::not_finite;
    default: return reason > 0 ? Status::ok : Status::not_converged;
  }
}

}  // namespace

struct RowShare::Implementation {
  explicit Implementation(const PcgOptions& given) : options(given) {}

  PcgOptions options;
  Stretches stretches;
  std::vector<int> starts, rows;  // pattern of the upper triangle in these rows: block row i has columns rows[k]
  std::vector<double> values;     // of the same blocks; the first process has them in the matrix that it assembles
  Owned<Mat, MatDestroy> matrix;
  Owned<Vec, VecDestroy> rhs, guess, solution, residual, preconditioned;
  Owned<KSP, KSPDestroy> iteration;
  // The preconditioner: our own incomplete factor, of what couples blocks of this process.
  BlockMatrix inner{0, {}};
  IncompleteCholesky factor;
  Eigen::VectorXd factor_in, factor_out;
  int checked_iterations = -1;

  [[nodiscard]] int entries() const { return starts.back() - starts.front(); }
  void take_pattern(const BlockMatrix* whole);
  void lay_out_matrix();
  void lay_out_vectors();
  void lay_out_iteration();
  void lay_out_factor();
  const double* take_values(const BlockMatrix* whole);
  void fill_matrix(const double* own);
  void fill_inner(const double* own);
  void hand_out_vector(const double* whole, Vec own) const;
  void collect_vector(Vec own, double* whole) const;
  void apply(Vec r, Vec z);
  double norm(Vec r);
  bool curves_down();
  Status check_solution();
};

// The lower triangle by columns is the upper one by rows.
void RowShare::Implementation::take_pattern(const BlockMatrix* whole) {
  const int* whole_starts = whole != nullptr ? whole->column_starts().data() : nullptr;
  const int* whole_rows = whole != nullptr ? whole->block_rows().data() : nullptr;
  starts.resize(static_cast<std::size_t>(stretches.size()) + 1);
  hand_out(whole_starts, stretches.cut(1, 1), starts.data(), stretches.size() + 1);
  rows.resize(static_cast<std::size_t>(entries()));
  hand_out(whole_rows, stretches.cut(whole_starts, 1), rows.data(), entries());
}

void RowShare::Implementation::lay_out_matrix() {
  std::vector<PetscInt> own, others;  // entries of each row, in columns of this process and of others
  for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
    own.push_back(0);
    for (int k = starts[i]; k < starts[i + 1]; ++k)
      own.back() += rows[static_cast<std::size_t>(k - starts.front())] < stretches.last() ? 1 : 0;
    others.push_back(starts[i + 1] - starts[i] - own.back());
  }
  const PetscInt size = 6 * stretches.size();
  check(MatCreateSBAIJ(PETSC_COMM_WORLD, 6, size, size, PETSC_DETERMINE, PETSC_DETERMINE, 0, own.data(), 0,
                       others.data(), matrix.fresh()));
  check(MatSetOption(matrix, MAT_NEW_NONZERO_ALLOCATION_ERR, PETSC_TRUE));
}

void RowShare::Implementation::lay_out_vectors() {
  check(MatCreateVecs(matrix, rhs.fresh(), solution.fresh()));
  for (auto* vector : {&guess, &residual, &preconditioned}) check(VecDuplicate(rhs, vector->fresh()));
  factor_in.resize(6 * stretches.size());
  factor_out.resize(6 * stretches.size());
}

// As PcgSolver measures: r . P^-1 r against b . P^-1 b.
void RowShare::Implementation::lay_out_iteration() {
  const auto precondition = [](PC pc, Vec r, Vec z) -> PetscErrorCode {
    void* self = nullptr;
    if (const PetscErrorCode code = PCShellGetContext(pc, &self); code != 0) return code;
    try {
      static_cast<Implementation*>(self)->apply(r, z);
    } catch (const std::exception&) {
      return PETSC_ERR_LIB;
    }
    return 0;
  };
  check(KSPCreate(PETSC_COMM_WORLD, iteration.fresh()));
  check(KSPSetType(iteration, KSPCG));
  check(KSPSetNormType(iteration, KSP_NORM_NATURAL));
  check(KSPSetTolerances(iteration, options.relative_residual, 0, PETSC_MAX_REAL, options.max_iterations));
  PC preconditioner = nullptr;
  check(KSPGetPC(iteration, &preconditioner));
  check(PCSetType(preconditioner, PCSHELL));
  check(PCShellSetContext(preconditioner, this));
  check(PCShellSetApply(preconditioner, precondition));
}

void RowShare::Implementation::lay_out_factor() {
  std::vector<std::pair<int, int>> couplings;
  for (int i = 0; i < stretches.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    for (int k = starts[at]; k < starts[at + 1]; ++k)
      if (const int row = rows[static_cast<std::size_t>(k - starts.front())]; row < stretches.last())
        couplings.emplace_back(row - stretches.first(), i);
  }
  inner = BlockMatrix(stretches.size(), std::move(couplings));
  inner.set_zero();
  if (inner.size() > 0) factor.analyze(inner, options.fill_level);
}

const double* RowShare::Implementation::take_values(const BlockMatrix* whole) {
  const bool is_first = stretches.is_first_process();
  const double* whole_values = is_first ? whole->diagonal(0).data() : nullptr;
  const int* whole_starts = is_first ? whole->column_starts().data() : nullptr;
  if (!is_first) values.resize(36 * rows.size());
  hand_out(whole_values, stretches.cut(whole_starts, 36), is_first ? nullptr : values.data(), 36 * entries());
  return is_first ? whole_values : values.data();
}

// A panel of the lower triangle by columns is a row of the upper one by rows, as PETSc takes it.
void RowShare::Implementation::fill_matrix(const double* own) {
  for (int i = 0; i < stretches.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const auto begin = static_cast<std::size_t>(starts[at] - starts.front());
    const PetscInt row = stretches.first() + i;
    check(MatSetValuesBlocked(matrix, 1, &row, starts[at + 1] - starts[at], rows.data() + begin, own + 36 * begin,
                              INSERT_VALUES));
  }
  check(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
  check(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
  check(KSPSetOperators(iteration, matrix, matrix));
}

void RowShare::Implementation::fill_inner(const double* own) {
  for (int i = 0; i < stretches.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const int begin = starts[at] - starts.front();
    const int height = starts[at + 1] - starts[at];
    const int inner_begin = inner.column_starts()[at];
    for (int k = 0; k < inner.column_starts()[at + 1] - inner_begin; ++k)
      inner.offdiagonal(inner_begin + k) =
          BlockMatrix::ConstBlock(own + 36 * std::ptrdiff_t{begin} + 6 * k, Eigen::OuterStride<>(6 * height));
  }
}

void RowShare::Implementation::hand_out_vector(const double* whole, Vec own) const {
  PetscScalar* numbers = nullptr;
  check(VecGetArray(own, &numbers));
  hand_out(whole, stretches.cut(6), numbers, 6 * stretches.size());
  check(VecRestoreArray(own, &numbers));
}

void RowShare::Implementation::collect_vector(Vec own, double* whole) const {
  const PetscScalar* numbers = nullptr;
  check(VecGetArrayRead(own, &numbers));
  collect(numbers, 6 * stretches.size(), stretches.cut(6), whole);
  check(VecRestoreArrayRead(own, &numbers));
}

void RowShare::Implementation::apply(Vec r, Vec z) {
  const PetscScalar* numbers = nullptr;
  factor_in = read(r, &numbers);
  check(VecRestoreArrayRead(r, &numbers));
  if (inner.size() > 0) factor.apply(factor_in, factor_out);
  PetscScalar* result = nullptr;
  check(VecGetArray(z, &result));
  Eigen::Map<Eigen::VectorXd>(result, factor_out.size()) = factor_out;
  check(VecRestoreArray(z, &result));
}

// The square of sqrt(r . P^-1 r).
double RowShare::Implementation::norm(Vec r) {
  apply(r, preconditioned);
  double norm = 0;
  check(VecDot(r, preconditioned, &norm));
  return norm;
}

// PETSc's iteration takes a matrix for definite as long as all curvatures have one sign, whichever.
bool RowShare::Implementation::curves_down() {
  double curvature = 0;
  check(VecAXPY(guess, -1, solution));
  check(MatMult(matrix, guess, residual));
  check(VecDot(guess, residual, &curvature));
  return curvature < 0;
}

// As PcgSolver::check, which says why.
Status RowShare::Implementation::check_solution() {
  if (curves_down()) return Status::singular;
  check(MatMult(matrix, solution, residual));
  check(VecAYPX(residual, -1, rhs));
  const double limit = options.true_residual * options.true_residual * norm(rhs);
  return norm(residual) <= limit ? Status::ok : Status::not_converged;
}

RowShare::RowShare(const PcgOptions& options) : implementation_(std::make_unique<Implementation>(options)) {}

RowShare::~RowShare() = default;

void RowShare::analyze(int blocks, const BlockMatrix* whole) {
  Implementation& own = *implementation_;
  own.stretches = Stretches(blocks);
  own.take_pattern(whole);
  own.lay_out_matrix();
  own.lay_out_vectors();
  own.lay_out_iteration();
  own.lay_out_factor();
}

bool RowShare::factorize(const BlockMatrix* whole) {
  Implementation& own = *implementation_;
  own.checked_iterations = -1;
  const double* values = own.take_values(whole);
  own.fill_matrix(values);
  own.fill_inner(values);
  int is_sound = own.inner.size() == 0 || own.factor.factorize(own.inner) ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &is_sound, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  return is_sound != 0;
}

SharedSolution RowShare::solve(bool has_guess, const double* rhs, double* x) {
  Implementation& own = *implementation_;
  own.hand_out_vector(rhs, own.rhs);
  if (has_guess) {
    own.hand_out_vector(x, own.solution);
    check(VecCopy(own.solution, own.guess));
  } else {
    check(VecSet(own.guess, 0));
  }
  check(KSPSetInitialGuessNonzero(own.iteration, has_guess ? PETSC_TRUE : PETSC_FALSE));
  check(KSPSolve(own.iteration, own.rhs, own.solution));
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  PetscInt iterations = 0;
  check(KSPGetConvergedReason(own.iteration, &reason));
  check(KSPGetIterationNumber(own.iteration, &iterations));
  Status status = status_of(reason);
  if (status == Status::ok && iterations > own.checked_iterations) {
    status = own.check_solution();
    if (status == Status::ok) own.checked_iterations = iterations;
  }
  own.collect_vector(own.solution, x);
  return {status, iterations};
}

void RowShare::precondition(const double* r, double* z) {
  Implementation& own = *implementation_;
  own.hand_out_vector(r, own.rhs);
  own.apply(own.rhs, own.preconditioned);
  own.collect_vector(own.preconditioned, z);
}

}  // namespace dda
