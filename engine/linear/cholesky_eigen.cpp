// CholeskySolver on Eigen, for builds without GPL parts. Eigen's factorize allocates its work space each time.
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>

#include "engine/linear/block_substitution.h"
#include "engine/linear/cholesky_solver.h"
#include "engine/linear/permuted_triangle.h"
#include "engine/linear/pivot_test.h"

namespace dda {
namespace {

using Sparse = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

// With the natural ordering and the upper triangle Eigen reads our copy in place.
class Llt : public Eigen::SimplicialLLT<Sparse, Eigen::Upper, Eigen::NaturalOrdering<int>> {
 public:
  // The factor as it is stored; matrixL() gives a view without access to the arrays.
  [[nodiscard]] const Sparse& factor() const { return m_matrix; }
};

}  // namespace

struct CholeskySolver::Implementation {
  void order_blocks(const BlockMatrix& matrix);
  void copy_pattern();
  [[nodiscard]] bool has_sound_pivots() const;

  Llt llt;
  std::vector<int> order;
  PermutedTriangle permuted;
  Sparse triangle;
  BlockSubstitution substitution;
};

// Minimum degree on the graph of the blocks: it has 36 times fewer edges than that of the unknowns and the same answer.
void CholeskySolver::Implementation::order_blocks(const BlockMatrix& matrix) {
  const std::vector<double> ones(matrix.block_rows().size(), 1.0);
  const Eigen::Map<const Sparse> graph(matrix.size(), matrix.size(), static_cast<Eigen::Index>(ones.size()),
                                       matrix.column_starts().data(), matrix.block_rows().data(), ones.data());
  const Sparse lower = graph;
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
  Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), permutation);
  order.assign(permutation.indices().begin(), permutation.indices().end());
}

void CholeskySolver::Implementation::copy_pattern() {
  triangle = Eigen::Map<const Sparse>(
      permuted.unknowns(), permuted.unknowns(), static_cast<Eigen::Index>(permuted.values().size()),
      permuted.column_pointers().data(), permuted.row_indices().data(), permuted.values().data());
}

bool CholeskySolver::Implementation::has_sound_pivots() const {
  const Sparse& factor = llt.factor();
  for (int k = 0; k < permuted.unknowns(); ++k) {
    const double root = factor.valuePtr()[factor.outerIndexPtr()[k]];
    if (!is_sound_pivot(root * root, permuted.diagonal(k))) return false;
  }
  return true;
}

CholeskySolver::CholeskySolver() = default;
CholeskySolver::~CholeskySolver() = default;

CholeskySolver::FactorFacts CholeskySolver::factor_facts() const {
  if (!implementation_) return {};
  const Sparse& factor = implementation_->llt.factor();
  FactorFacts facts;
  for (Eigen::Index k = 0; k < factor.cols(); ++k) {
    const double height = factor.outerIndexPtr()[k + 1] - factor.outerIndexPtr()[k];
    facts.nonzeros += height;
    facts.flops += height * height;
  }
  return facts;
}

void CholeskySolver::order_and_lay_out(const BlockMatrix& matrix) {
  implementation_ = std::make_unique<Implementation>();
  implementation_->order_blocks(matrix);
  implementation_->permuted = PermutedTriangle(matrix, implementation_->order, PermutedTriangle::Side::upper);
  implementation_->copy_pattern();
  implementation_->llt.analyzePattern(implementation_->triangle);
}

Status CholeskySolver::do_factorize(const BlockMatrix& matrix) {
  Implementation& self = *implementation_;
  self.permuted.update(matrix);
  std::copy(self.permuted.values().begin(), self.permuted.values().end(), self.triangle.valuePtr());
  self.llt.factorize(self.triangle);
  if (self.llt.info() != Eigen::Success || !self.has_sound_pivots()) return Status::singular;
  const Sparse& factor = self.llt.factor();
  if (!self.substitution.has_pattern()) {
    self.substitution = BlockSubstitution(
        BlockSubstitution::pattern_of_csc(self.order, factor.outerIndexPtr(), factor.innerIndexPtr()));
  }
  self.substitution.set_values(factor.valuePtr());
  return Status::ok;
}

Status CholeskySolver::do_solve(const Eigen::VectorXd& rhs, Eigen::VectorXd& x) {
  implementation_->substitution.solve(rhs, x);
  return Status::ok;
}

}  // namespace dda
