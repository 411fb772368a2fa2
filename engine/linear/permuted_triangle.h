// A copy of a block matrix in the order of elimination, in the layout that a sparse factorization reads without copying
// again.
#pragma once

#include <vector>

#include "engine/linear/block_matrix.h"

namespace dda {

// One triangle of P A P^T as scalar CSC with sorted rows. Diagonal blocks are stored in full; the entries on the wrong
// side of the diagonal are to be ignored by the reader.
class PermutedTriangle {
 public:
  enum class Side { lower, upper };

  PermutedTriangle() = default;
  // order[k] is the block eliminated as the k-th.
  PermutedTriangle(const BlockMatrix& matrix, const std::vector<int>& order, Side side);

  // Copies the values of a matrix with the pattern given to the constructor. Allocates nothing.
  void update(const BlockMatrix& matrix);

  [[nodiscard]] int unknowns() const { return static_cast<int>(column_pointers_.size()) - 1; }
  [[nodiscard]] std::vector<int>& column_pointers() { return column_pointers_; }
  [[nodiscard]] std::vector<int>& row_indices() { return row_indices_; }
  [[nodiscard]] std::vector<double>& values() { return values_; }
  // Diagonal entry k of P A P^T.
  [[nodiscard]] double diagonal(int k) const;

 private:
  // A block of the source, and where its copy starts here.
  struct Copy {
    int source;  // handle as of BlockMatrix::slot
    int offset;
    int stride;
    bool transposed;
  };

  void build_scalar_csc(const std::vector<std::vector<std::pair<int, Copy>>>& columns, Side side);

  std::vector<Copy> copies_;
  std::vector<int> diagonal_places_;  // of the first entry of each diagonal block
  std::vector<int> diagonal_strides_;
  std::vector<int> column_pointers_;
  std::vector<int> row_indices_;
  std::vector<double> values_;
};

}  // namespace dda
