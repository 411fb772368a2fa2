// The symmetric system matrix of n blocks with six unknowns each, stored so that assembly, product and factorization
// all work on it in place.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "engine/core/parallel.h"
#include "engine/core/types.h"
#include "engine/linear/block_part.h"
#include "engine/linear/panel_product.h"

namespace dda {

// Symmetric block-sparse matrix of n x n blocks of 6x6; only the lower triangle is stored, as one dense column-major
// panel per block column: its diagonal block on top, then the off-diagonal blocks (i > j) by ascending i. The pattern
// is fixed at construction; vectors are plain VectorXd of length 6n with block i in segment<6>(6 * i).
class BlockMatrix {
 public:
  using Block = Eigen::Map<Mat6, Eigen::Unaligned, Eigen::OuterStride<>>;
  using ConstBlock = Eigen::Map<const Mat6, Eigen::Unaligned, Eigen::OuterStride<>>;
  using Vector = Eigen::VectorXd;

  // `couplings` lists the pairs of blocks with an off-diagonal block between them, in any order; duplicates, mirrored
  // pairs and self pairs are harmless. All values start at zero. Throws std::invalid_argument for a negative number of
  // blocks, a pair outside of [0, blocks), or a matrix too large for int32 indices.
  BlockMatrix(int blocks, std::vector<std::pair<int, int>> couplings);

  // Number of blocks n; the matrix has 6n rows.
  [[nodiscard]] int size() const { return static_cast<int>(column_starts_.size()) - 1; }
  [[nodiscard]] int unknowns() const { return 6 * size(); }
  // Number of stored off-diagonal blocks, that is of distinct coupled pairs.
  [[nodiscard]] int couplings() const { return static_cast<int>(block_rows_.size()) - size(); }

  // The diagonal block i, both triangles stored: whoever writes it keeps it symmetric.
  [[nodiscard]] Block diagonal(int i) { return block(column_starts_[index(i)]); }
  [[nodiscard]] ConstBlock diagonal(int i) const { return block(column_starts_[index(i)]); }

  // Handle of the off-diagonal block (row i, column j), i > j, for offdiagonal(); -1 where the pattern has none.
  // Handles stay valid for the life of the matrix and its copies. Binary search: look up once, keep the handle.
  [[nodiscard]] int slot(int i, int j) const;
  [[nodiscard]] Block offdiagonal(int slot) { return block(slot); }
  [[nodiscard]] ConstBlock offdiagonal(int slot) const { return block(slot); }

  // Adds K_ij (force on block i by the unknowns of block j), and by symmetry K_ji = K_ij^T; for i == j adds to the
  // diagonal block. Throws std::out_of_range where the pattern has no such block.
  void add_coupling(int i, int j, const Mat6& stiffness);

  void set_zero();
  // Gives the memory of the values back; set_zero() is to come before anything else.
  void forget_values() { values_ = {}; }
  // Takes over the values of a matrix of the same pattern.
  void set_values(const BlockMatrix& same_pattern);

  // y = A x; x and y hold 6n numbers each and are different vectors. Allocates nothing. Shared by threads where there
  // are many blocks; every row gets its terms in the same order, whoever adds them.
  void multiply(const Eigen::Ref<const Vector>& x, Vector& y) const;

  // The same where x is zero outside of a part: reads only what meets it.
  void multiply(const BlockPart& part, const Vector& x, Vector& y) const;

  // The block pattern: block column j holds the block rows block_rows()[k] for k in [column_starts()[j],
  // column_starts()[j + 1]), the first of them j itself.
  [[nodiscard]] std::span<const int> column_starts() const { return column_starts_; }
  [[nodiscard]] std::span<const int> block_rows() const { return block_rows_; }

 private:
  // Where a block starts in values_, and the distance between its columns (the height of its panel).
  struct Place {
    int offset;
    int stride;
  };

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  Block block(int k) {
    const Place place = places_[index(k)];
    return Block(values_.data() + place.offset, Eigen::OuterStride<>(place.stride));
  }
  [[nodiscard]] ConstBlock block(int k) const {
    const Place place = places_[index(k)];
    return ConstBlock(values_.data() + place.offset, Eigen::OuterStride<>(place.stride));
  }
  // y = A x by those blocks alone, on the diagonal and beside it, for which meets(column, row) is true.
  template <typename Meets>
  void multiply_where(const Meets& meets, const double* x, Vector& y) const;
  void build_pattern(int blocks, const std::vector<std::pair<int, int>>& couplings);
  void build_places();
  void build_shares();
  [[nodiscard]] PanelProduct panel_product(int column, const double* x) const;
  void multiply_share(std::size_t share, const double* x, Vector& y) const;

  std::vector<int> column_starts_;  // n + 1
  std::vector<int> block_rows_;
  std::vector<Place> places_;  // one for each entry of block_rows_
  std::vector<double> values_;

  // The product in shares of consecutive rows. A share does the panels of its own columns; a block of these that lies
  // in the rows of a later share is gathered from here, and scattered by that one, which comes to it first: panels go
  // up in columns, and rows lie below them.
  struct Reach {
    int column, k;  // of the panel; of the block, as in block_rows_
  };
  Pieces shares_{0, 1};
  std::vector<Reach> reaches_;             // into each share, by ascending columns
  std::vector<std::size_t> reach_starts_;  // one a share, and the end
};

}  // namespace dda
