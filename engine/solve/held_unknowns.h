// Blocks whose six increments are known before a step is solved.
//
// Their rows and columns leave the system: with p the known and i the other blocks, A_ii d_i = r_i - A_ip d_p. All
// vectors here have 6 entries a block.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "engine/contact/interface_element.h"
#include "engine/core/types.h"
#include "engine/linear/block_matrix.h"

namespace dda {

struct HeldUnknowns {
  std::vector<int> blocks;
  std::vector<Vec6> increments;  // d_p, as `blocks`
  std::vector<int> place;        // of every block in `blocks`, -1 for the others; empty where no block is held
  bool move = false;             // not all of them stand still in this run

  [[nodiscard]] bool empty() const { return blocks.empty(); }
  [[nodiscard]] bool holds(int block) const { return !place.empty() && place[static_cast<std::size_t>(block)] >= 0; }

  // Writes the increments into `d`.
  void put(Eigen::VectorXd& d) const;

  // Sets the entries of held blocks to zero.
  void clear(Eigen::VectorXd& force) const;

  // True when `p` moves a held block: the first Newton step of a time step does.
  [[nodiscard]] bool moved_by(const Eigen::VectorXd& p) const;

  // Sum of d_p . force.
  [[nodiscard]] double work(const Eigen::VectorXd& force) const;

  // The change of an interface's gaps by the held of its blocks.
  [[nodiscard]] Vec4 gap_increment(const InterfaceElement& element) const;
};

// What stood beside held blocks in a matrix that they were taken out of.
class HeldCouplings {
 public:
  // Leaves 1 on the diagonal of held blocks and nothing beside it.
  void take_out(const HeldUnknowns& held, BlockMatrix& matrix);

  // The right-hand side that belongs to the matrix without them.
  void move_to_right(const HeldUnknowns& held, Eigen::VectorXd& rhs) const;

  // d A p of the entries that were taken out, where `p` leaves the held blocks in place.
  [[nodiscard]] double work(const Eigen::VectorXd& d, const Eigen::VectorXd& p) const;

 private:
  struct Coupling {
    int block, held;
    Mat6 stiffness;  // force on `block` by the unknowns of `held`
  };

  std::vector<Coupling> couplings_;  // only kept where held blocks move
};

}  // namespace dda
