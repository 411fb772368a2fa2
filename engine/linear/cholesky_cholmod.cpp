// CholeskySolver on CHOLMOD.
#include <cholmod.h>

#include <algorithm>
#include <new>

#include "dda/linear/block_substitution.h"
#include "dda/linear/cholesky_solver.h"
#include "dda/linear/permuted_triangle.h"
#include "dda/linear/pivot_test.h"
#include "dda/linear/single_thread.h"

namespace dda {
namespace {

// Floating-point operations per nonzero of the factor above which dense BLAS blocks pay for their calls.
constexpr double supernodal_from = 40;

cholmod_sparse sparse_view(int size, void* column_pointers, void* row_indices, void* values, int symmetry) {
  cholmod_sparse view{};
  view.nrow = view.ncol = static_cast<std::size_t>(size);
  view.nzmax = static_cast<std::size_t>(static_cast<int*>(column_pointers)[size]);
  view.p = column_pointers;
  view.i = row_indices;
  view.x = values;
  view.stype = symmetry;
  view.itype = CHOLMOD_INT;
  view.xtype = values == nullptr ? CHOLMOD_PATTERN : CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = view.packed = 1;
  return view;
}

}  // namespace

struct CholeskySolver::Implementation {
  Implementation();
  ~Implementation();
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  void order_blocks(const BlockMatrix& matrix);
  void analyze_scalars(const BlockMatrix& matrix);
  [[nodiscard]] bool has_sound_pivots() const;
  void take_over_simplicial_factor();
  void solve_supernodal(const Eigen::VectorXd& rhs, Eigen::VectorXd& x);
  cholmod_sparse view() {
    return sparse_view(permuted.unknowns(), permuted.column_pointers().data(), permuted.row_indices().data(),
                       permuted.values().data(), factor != nullptr && factor->is_super ? -1 : 1);
  }

  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  cholmod_dense* solution = nullptr;
  cholmod_dense* workspace_y = nullptr;
  cholmod_dense* workspace_e = nullptr;
  std::vector<int> order;
  PermutedTriangle permuted;
  BlockSubstitution substitution;  // of a simplicial factor
  Eigen::VectorXd permuted_rhs;    // of a supernodal one
};

CholeskySolver::Implementation::Implementation() {
  use_one_blas_thread();
  cholmod_start(&common);
  common.print = 0;
  common.final_ll = 1;
  common.nmethods = 1;
  common.supernodal_switch = supernodal_from;
  common.quick_return_if_not_posdef = 1;
}

CholeskySolver::Implementation::~Implementation() {
  cholmod_free_dense(&solution, &common);
  cholmod_free_dense(&workspace_y, &common);
  cholmod_free_dense(&workspace_e, &common);
  cholmod_free_factor(&factor, &common);
  cholmod_finish(&common);
}

// Minimum degree on the graph of the blocks: it has 36 times fewer edges than that of the unknowns and the same answer.
void CholeskySolver::Implementation::order_blocks(const BlockMatrix& matrix) {
  std::vector<int> starts(matrix.column_starts().begin(), matrix.column_starts().end());
  std::vector<int> rows(matrix.block_rows().begin(), matrix.block_rows().end());
  cholmod_sparse graph = sparse_view(matrix.size(), starts.data(), rows.data(), nullptr, -1);
  common.method[0].ordering = CHOLMOD_AMD;
  common.postorder = 1;
  common.supernodal = CHOLMOD_SIMPLICIAL;
  cholmod_factor* ordered = cholmod_analyze(&graph, &common);
  if (ordered == nullptr) throw std::bad_alloc();
  const int* permutation = static_cast<const int*>(ordered->Perm);
  order.assign(permutation, permutation + matrix.size());
  cholmod_free_factor(&ordered, &common);
}

// The blocks are in order now, so CHOLMOD is to keep it: its natural ordering reads our copy in place, where any other
// would permute it into a new allocation at each factorization.
void CholeskySolver::Implementation::analyze_scalars(const BlockMatrix& matrix) {
  common.method[0].ordering = CHOLMOD_NATURAL;
  common.postorder = 0;
  common.supernodal = CHOLMOD_AUTO;
  cholmod_free_factor(&factor, &common);
  permuted = PermutedTriangle(matrix, order, PermutedTriangle::Side::upper);
  cholmod_sparse upper = view();
  factor = cholmod_analyze(&upper, &common);
  if (factor == nullptr) throw std::bad_alloc();
  if (factor->is_super) permuted = PermutedTriangle(matrix, order, PermutedTriangle::Side::lower);
  substitution = BlockSubstitution();
  permuted_rhs.resize(matrix.unknowns());
}

bool CholeskySolver::Implementation::has_sound_pivots() const {
  const double* values = static_cast<const double*>(factor->x);
  const auto is_sound = [&](int k, double root) { return is_sound_pivot(root * root, permuted.diagonal(k)); };
  if (!factor->is_super) {
    const int* starts = static_cast<const int*>(factor->p);
    for (int k = 0; k < permuted.unknowns(); ++k) {
      if (!is_sound(k, values[starts[k]])) return false;
    }
    return true;
  }
  const int* first_columns = static_cast<const int*>(factor->super);
  const int* row_starts = static_cast<const int*>(factor->pi);
  const int* value_starts = static_cast<const int*>(factor->px);
  for (std::size_t s = 0; s < factor->nsuper; ++s) {
    const int height = row_starts[s + 1] - row_starts[s];
    for (int k = first_columns[s]; k < first_columns[s + 1]; ++k) {
      if (!is_sound(k, values[value_starts[s] + (k - first_columns[s]) * (height + 1)])) return false;
    }
  }
  return true;
}

void CholeskySolver::Implementation::take_over_simplicial_factor() {
  const BlockSubstitution::ScalarFactor scalars{static_cast<const int*>(factor->p), static_cast<const int*>(factor->i),
                                                static_cast<const double*>(factor->x)};
  if (!substitution.has_pattern()) substitution.set_pattern(scalars, order);
  substitution.set_values(scalars);
}

void CholeskySolver::Implementation::solve_supernodal(const Eigen::VectorXd& rhs, Eigen::VectorXd& x) {
  const SingleThreadScope single_thread;
  const int blocks = static_cast<int>(order.size());
  for (int k = 0; k < blocks; ++k) {
    permuted_rhs.segment<6>(6 * k) = rhs.segment<6>(6 * order[static_cast<std::size_t>(k)]);
  }
  cholmod_dense right{};
  right.nrow = right.d = right.nzmax = static_cast<std::size_t>(rhs.size());
  right.ncol = 1;
  right.x = permuted_rhs.data();
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  if (!cholmod_solve2(CHOLMOD_A, factor, &right, nullptr, &solution, nullptr, &workspace_y, &workspace_e, &common)) {
    throw std::bad_alloc();
  }
  const Eigen::Map<const Eigen::VectorXd> permuted_x(static_cast<const double*>(solution->x), rhs.size());
  for (int k = 0; k < blocks; ++k) {
    x.segment<6>(6 * order[static_cast<std::size_t>(k)]) = permuted_x.segment<6>(6 * k);
  }
}

CholeskySolver::CholeskySolver() : implementation_(std::make_unique<Implementation>()) {}
CholeskySolver::~CholeskySolver() = default;

CholeskySolver::FactorFacts CholeskySolver::factor_facts() const {
  const cholmod_factor* factor = implementation_->factor;
  if (factor == nullptr) return {};
  return {implementation_->common.lnz, implementation_->common.fl, factor->is_super != 0};
}

void CholeskySolver::do_analyze(const BlockMatrix& matrix) {
  implementation_->order_blocks(matrix);
  implementation_->analyze_scalars(matrix);
}

Status CholeskySolver::do_factorize(const BlockMatrix& matrix) {
  Implementation& self = *implementation_;
  const SingleThreadScope single_thread;
  self.permuted.update(matrix);
  cholmod_sparse triangle = self.view();
  cholmod_factorize(&triangle, self.factor, &self.common);
  if (self.common.status < CHOLMOD_OK) throw std::bad_alloc();
  if (self.common.status == CHOLMOD_NOT_POSDEF || !self.has_sound_pivots()) return Status::singular;
  if (!self.factor->is_super) self.take_over_simplicial_factor();
  return Status::ok;
}

Status CholeskySolver::do_solve(const Eigen::VectorXd& rhs, Eigen::VectorXd& x) {
  if (implementation_->factor->is_super) {
    implementation_->solve_supernodal(rhs, x);
  } else {
    implementation_->substitution.solve(rhs, x);
  }
  return Status::ok;
}

}  // namespace dda
