#include "engine/distributed/row_share.h"

#include <petscksp.h>

#include <cmath>
#include <cstddef>
#include <exception>
#include <optional>
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
  // The preconditioner: our own incomplete factor of the rows of this process and those beside them, which PETSc gives
  // out and whose solutions it sums up where they overlap (additive Schwarz; Dryja & Widlund 1987).
  PC preconditioner = nullptr;
  std::optional<BlockMatrix> inner;
  IncompleteCholesky factor;
  bool is_sound = false;
  Eigen::VectorXd factor_in, factor_out;
  int checked_iterations = -1;

  // What PETSc calls must not throw: it is written in C.
  template <typename Act>
  static PetscErrorCode called_back(PC pc, const Act& act) {
    try {
      void* self = nullptr;
      check(PCShellGetContext(pc, &self));
      act(*static_cast<Implementation*>(self));
    } catch (const std::exception&) {
      return PETSC_ERR_LIB;
    }
    return 0;
  }
  [[nodiscard]] int entries() const { return starts.back() - starts.front(); }
  void take_pattern(const BlockMatrix* whole);
  void lay_out_matrix();
  void lay_out_vectors();
  void lay_out_iteration();
  void lay_out_preconditioner();
  const double* take_values(const BlockMatrix* whole);
  void fill_matrix(const double* own);
  void lay_out_factor(int blocks, const PetscInt* row_starts, const PetscInt* columns);
  void fill_inner(const PetscInt* row_starts, const PetscInt* columns, const PetscScalar* own);
  void factor_inner(Mat own);
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
}

// As PcgSolver measures: r . P^-1 r against b . P^-1 b.
void RowShare::Implementation::lay_out_iteration() {
  check(KSPCreate(PETSC_COMM_WORLD, iteration.fresh()));
  check(KSPSetType(iteration, KSPCG));
  check(KSPSetNormType(iteration, KSP_NORM_NATURAL));
  check(KSPSetTolerances(iteration, options.relative_residual, 0, PETSC_MAX_REAL, options.max_iterations));
  // Diagonal blocks alone have nothing to gain from an overlap.
  check(KSPGetPC(iteration, &preconditioner));
  check(PCSetType(preconditioner, PCASM));
  check(PCASMSetType(preconditioner, PC_ASM_BASIC));
  check(PCASMSetOverlap(preconditioner, options.fill_level == IncompleteCholesky::diagonal ? 0 : 1));
  inner.reset();
}

// Once PETSc has the pattern of what each process factors, it is told with what.
void RowShare::Implementation::lay_out_preconditioner() {
  KSP* own = nullptr;
  PC shell = nullptr;
  check(PCASMGetSubKSP(preconditioner, nullptr, nullptr, &own));
  check(KSPGetPC(*own, &shell));
  check(PCSetType(shell, PCSHELL));
  check(PCShellSetContext(shell, this));
  check(PCShellSetSetUp(shell, [](PC pc) {
    return called_back(pc, [pc](Implementation& self) {
      Mat given = nullptr;
      check(PCGetOperators(pc, &given, nullptr));
      self.factor_inner(given);
    });
  }));
  check(PCShellSetApply(
      shell, [](PC pc, Vec r, Vec z) { return called_back(pc, [r, z](Implementation& self) { self.apply(r, z); }); }));
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
}

// The pattern is that of rows of the upper triangle, which PETSc has given this process.
void RowShare::Implementation::lay_out_factor(int blocks, const PetscInt* row_starts, const PetscInt* columns) {
  std::vector<std::pair<int, int>> couplings;
  for (int i = 0; i < blocks; ++i)
    for (int k = row_starts[i]; k < row_starts[i + 1]; ++k) couplings.emplace_back(columns[k], i);
  inner.emplace(blocks, std::move(couplings));
  factor_in.resize(6 * blocks);
  factor_out.resize(6 * blocks);
  if (blocks > 0) factor.analyze(*inner, options.fill_level);
}

void RowShare::Implementation::fill_inner(const PetscInt* row_starts, const PetscInt* columns, const PetscScalar* own) {
  inner->set_zero();
  for (int i = 0; i < inner->size(); ++i)
    for (int k = row_starts[i]; k < row_starts[i + 1]; ++k) {
      const Eigen::Map<const Mat6> block(own + 36 * std::ptrdiff_t{k});
      inner->add_coupling(i, columns[k], block);
    }
}

// Its values go when they are factored; PETSc has them, too.
void RowShare::Implementation::factor_inner(Mat own) {
  PetscInt blocks = 0;
  const PetscInt *row_starts = nullptr, *columns = nullptr;
  PetscScalar* numbers = nullptr;
  PetscBool is_done = PETSC_FALSE;
  check(MatGetRowIJ(own, 0, PETSC_FALSE, PETSC_TRUE, &blocks, &row_starts, &columns, &is_done));
  check(MatSeqSBAIJGetArray(own, &numbers));
  if (!inner) lay_out_factor(blocks, row_starts, columns);
  fill_inner(row_starts, columns, numbers);
  is_sound = blocks == 0 || factor.factorize(*inner);
  inner->forget_values();
  check(MatSeqSBAIJRestoreArray(own, &numbers));
  check(MatRestoreRowIJ(own, 0, PETSC_FALSE, PETSC_TRUE, &blocks, &row_starts, &columns, &is_done));
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
  if (factor_in.size() > 0) factor.apply(factor_in, factor_out);
  PetscScalar* result = nullptr;
  check(VecGetArray(z, &result));
  Eigen::Map<Eigen::VectorXd>(result, factor_out.size()) = factor_out;
  check(VecRestoreArray(z, &result));
}

// The square of sqrt(r . P^-1 r).
double RowShare::Implementation::norm(Vec r) {
  check(PCApply(preconditioner, r, preconditioned));
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
}

bool RowShare::factorize(const BlockMatrix* whole) {
  Implementation& own = *implementation_;
  own.checked_iterations = -1;
  own.fill_matrix(own.take_values(whole));
  check(KSPSetOperators(own.iteration, own.matrix, own.matrix));
  check(KSPSetUp(own.iteration));
  if (!own.inner) own.lay_out_preconditioner();
  check(KSPSetUpOnBlocks(own.iteration));
  int is_sound = own.is_sound ? 1 : 0;
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
  check(PCApply(own.preconditioner, own.rhs, own.preconditioned));
  own.collect_vector(own.preconditioned, z);
}

}  // namespace dda
