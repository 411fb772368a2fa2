// Incomplete Cholesky factorization by blocks: the preconditioner for contact systems, where inertia reaches over a few
// blocks only and a complete factor computes mostly what has no effect.
#pragma once

#include <vector>

#include "engine/linear/block_matrix.h"
#include "engine/linear/block_order.h"
#include "engine/linear/single_block.h"

namespace dda {

// A ~ M D M^T in an order of elimination, M unit lower triangular by 6x6 blocks, D block diagonal. M has the pattern of
// A and the fill of the first `level` generations (level of fill, Saad, Iterative methods for sparse linear systems,
// 2003, 10.3.3); what would fall elsewhere is dropped. Where dropping makes a diagonal block of D indefinite, which it
// may when blocks hardly resist strain, the factor of A + shift diag(A) takes its place (Manteuffel 1980), and as a
// last resort the diagonal blocks alone: M D M^T is always positive definite.
//
// From `worth_halving` blocks on the order is cut in halves that two threads eliminate, and substitute, side by side;
// what the second adds to the blocks that come after both is kept apart and added then, so that the bits do not depend
// on who did what.
//
// All in single precision, which halves the time of a factorization and of its use. Elimination leaves of a diagonal
// entry the share of inertia in it, 1/chi at least, and single precision tells that up to chi = 1e6: beyond, where no
// incomplete factor is worth its while, shifts become more frequent.
class IncompleteCholesky {
 public:
  static constexpr int diagonal = -1;  // a level: no fill and no coupling either
  static constexpr std::size_t worth_halving = 4096;

  // Orders the blocks (reverse Cuthill-McKee, blocks with many neighbours last) and lays out M.
  void analyze(const BlockMatrix& matrix, int level);

  // Takes the values of a matrix of the analyzed pattern. False where a diagonal block of it is not positive definite.
  // Allocates nothing.
  [[nodiscard]] bool factorize(const BlockMatrix& matrix);
  // The same for the rows and columns of a part alone, as if the others were not there.
  [[nodiscard]] bool factorize(const BlockMatrix& matrix, const BlockPart& part);

  // z = (M D M^T)^-1 r; returns r . z. Outside of the part that was factored r is not looked at and z is zero.
  // Allocates nothing.
  double apply(const Eigen::VectorXd& r, Eigen::VectorXd& z);

  // Off-diagonal blocks of M.
  [[nodiscard]] int entries() const { return static_cast<int>(rows_.size()); }
  // That of the last factorization.
  [[nodiscard]] double shift() const { return shift_; }

 private:
  // Where a block of A goes: the entry of M.
  struct Source {
    int entry;
    bool transposed;
  };

  // act(place) for all that are factored, shared by threads.
  template <typename Act>
  void for_each_place(const Act& act) const;
  // Where an entry, or a place, is kept, `apart` from what the first half adds there.
  template <bool apart>
  [[nodiscard]] std::size_t entry_for(int entry) const;
  template <bool apart>
  [[nodiscard]] std::size_t place_for(int place) const;

  [[nodiscard]] bool factorize_places(const BlockMatrix& matrix);
  void lay_out(const BlockMatrix& matrix, int level);
  void find_sources(const BlockMatrix& matrix);
  void find_targets();
  [[nodiscard]] int entry(int row, int column) const;
  void clear_fill(int column);
  void load(const BlockMatrix& matrix, double shift);
  void load_column(const BlockMatrix& matrix, int block);
  [[nodiscard]] bool is_halved() const { return halves_.second > 0 && is_whole(); }
  [[nodiscard]] bool is_whole() const { return places_.size() == order_.size(); }
  [[nodiscard]] bool eliminate_all();
  [[nodiscard]] bool eliminate_halves();
  template <bool apart>
  [[nodiscard]] bool eliminate_between(std::size_t first, std::size_t last);
  template <bool apart>
  void eliminate(int column);
  [[nodiscard]] double largest_entry(const Eigen::VectorXd& r) const;
  double substitute(double unit, const Eigen::VectorXd& r, Eigen::VectorXd& z);
  double substitute_halves(double unit, const Eigen::VectorXd& r, Eigen::VectorXd& z);
  template <bool whole, bool apart>
  void forward(std::size_t first, std::size_t last);
  template <bool whole>
  double backward(double unit, std::size_t first, std::size_t last, const Eigen::VectorXd& r, Eigen::VectorXd& z);
  double apply_diagonal(double unit, const Eigen::VectorXd& r, Eigen::VectorXd& z);
  [[nodiscard]] bool take_diagonal_only(const BlockMatrix& matrix);

  std::vector<int> order_;             // order_[k]: the block eliminated as the k-th
  Halves halves_;                      // of order_; none: all come after them
  int first_entry_after_ = 0;          // of M, in columns after the halves
  std::vector<int> position_;          // of each block in order_
  std::vector<int> places_;            // positions of the blocks that are factored, ascending
  std::vector<char> is_factored_;      // by position
  std::vector<int> column_starts_;     // n + 1, into rows_
  std::vector<int> rows_;              // by column, ascending
  std::vector<char> is_fill_;          // as in rows_: A has no block there
  std::vector<SingleBlock> blocks_;    // M, as in rows_; then what the second half adds to columns after the halves
  std::vector<SingleBlock> diagonal_;  // of A, then of D^-1; then what the second half adds there
  std::vector<Source> sources_;        // of all couplings, in the order of the matrix
  // For each column with rows a_0 < a_1 < ...: entry (a_i, a_j) for all j < i, row by row; -1 where it is dropped.
  std::vector<int> targets_;
  std::vector<int> target_starts_;
  std::vector<SingleSix> work_;   // by position; then what the second half adds after the halves
  std::vector<double> products_;  // r . z of each block, by position
  double shift_ = 0;
  double scale_ = 1;  // A times this is what was factored
};

}  // namespace dda
