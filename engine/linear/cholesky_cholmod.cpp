// CholeskySolver on CHOLMOD.
#include <cholmod.h>

#include <algorithm>
#include <new>

#include "engine/linear/blas_setup.h"
#include "engine/linear/block_substitution.h"
#include "engine/linear/cholesky_solver.h"
#include "engine/linear/permuted_triangle.h"
#include "engine/linear/pivot_test.h"
#include "engine/linear/single_thread.h"

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
  [[nodiscard]] BlockSubstitution::Pattern supernodal_pattern() const;
  void prepare_substitution();
  cholmod_sparse view() {
    return sparse_view(permuted.unknowns(), permuted.column_pointers().data(), permuted.row_indices().data(),
                       permuted.values().data(), factor != nullptr && factor->is_super ? -1 : 1);
  }

  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  std::vector<int> order;
  PermutedTriangle permuted;
  BlockSubstitution substitution;
};

CholeskySolver::Implementation::Implementation() {
  set_up_blas();
  cholmod_start(&common);
  common.print = 0;
  common.final_ll = 1;
  common.nmethods = 1;
  common.supernodal_switch = supernodal_from;
  common.quick_return_if_not_posdef = 1;
}

CholeskySolver::Implementation::~Implementation() {
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
}

BlockSubstitution::Pattern CholeskySolver::Implementation::supernodal_pattern() const {
  const int* first_columns = static_cast<const int*>(factor->super);
  const int* row_starts = static_cast<const int*>(factor->pi);
  const int* value_starts = static_cast<const int*>(factor->px);
  const int* rows = static_cast<const int*>(factor->s);
  BlockSubstitution::Pattern pattern{order, {0}, {}, {}};
  for (std::size_t s = 0; s < factor->nsuper; ++s) {
    const int height = row_starts[s + 1] - row_starts[s];
    for (int local = 0; local < first_columns[s + 1] - first_columns[s]; ++local) {
      pattern.diagonal_places.push_back(value_starts[s] + local * (height + 1));
      if (local % 6 != 0) continue;
      for (int k = local + 6; k < height; k += 6) pattern.rows.push_back(rows[row_starts[s] + k] / 6);
      pattern.column_starts.push_back(static_cast<int>(pattern.rows.size()));
    }
  }
  return pattern;
}

// The pattern of a simplicial factor is known only after its first factorization.
void CholeskySolver::Implementation::prepare_substitution() {
  if (substitution.has_pattern()) return;
  substitution =
      BlockSubstitution(factor->is_super ? supernodal_pattern()
                                         : BlockSubstitution::pattern_of_csc(order, static_cast<const int*>(factor->p),
                                                                             static_cast<const int*>(factor->i)));
}

bool CholeskySolver::Implementation::has_sound_pivots() const {
  const double* values = static_cast<const double*>(factor->x);
  for (int k = 0; k < permuted.unknowns(); ++k) {
    const double root = values[substitution.diagonal_place(k)];
    if (!is_sound_pivot(root * root, permuted.diagonal(k))) return false;
  }
  return true;
}

CholeskySolver::CholeskySolver() : implementation_(std::make_unique<Implementation>()) {}
CholeskySolver::~CholeskySolver() = default;

CholeskySolver::FactorFacts CholeskySolver::factor_facts() const {
  const cholmod_factor* factor = implementation_->factor;
  if (factor == nullptr) return {};
  return {implementation_->common.lnz, implementation_->common.fl, factor->is_super != 0};
}

void CholeskySolver::order_and_lay_out(const BlockMatrix& matrix) {
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
  if (self.common.status == CHOLMOD_NOT_POSDEF) return Status::singular;
  self.prepare_substitution();
  if (!self.has_sound_pivots()) return Status::singular;
  self.substitution.set_values(static_cast<const double*>(self.factor->x));
  return Status::ok;
}

Status CholeskySolver::do_solve(const Eigen::VectorXd& rhs, Eigen::VectorXd& x) {
  implementation_->substitution.solve(rhs, x);
  return Status::ok;
}

}  // namespace dda
