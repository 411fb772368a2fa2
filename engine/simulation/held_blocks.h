// Blocks whose motion is prescribed exactly: their six unknowns are known before a step is solved.
//
// Their rows and columns leave the system: with p the known and i the other blocks, A_ii d_i = r_i - A_ip d_p. They
// have no inertia (make_block_terms), so that all that is left of them in the energies is the work of their motion.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/contact/interface_element.h"
#include "engine/core/types.h"
#include "engine/linear/block_matrix.h"
#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

class HeldBlocks {
 public:
  explicit HeldBlocks(const Model& model);

  [[nodiscard]] bool empty() const { return increments_.empty(); }

  [[nodiscard]] bool holds(int block) const { return !place_.empty() && place_[static_cast<std::size_t>(block)] >= 0; }

  // Not all of them stand still.
  [[nodiscard]] bool move() const { return move_; }

  // The increments (d_p) that bring the blocks from `state` to where they are to be at `time`.
  void aim(const Model& model, const State& state, double time);

  // Writes the increments into `d` (6 entries a block, as all vectors here).
  void put(Eigen::VectorXd& d) const;

  // Sets the entries of held blocks to zero.
  void clear(Eigen::VectorXd& force) const;

  // Takes the held blocks out of the matrix: 1 on their diagonal, nothing beside it. What stood beside it is kept for
  // the functions below.
  void take_out(BlockMatrix& matrix);

  // The right-hand side that belongs to the matrix without them.
  void move_to_right(Eigen::VectorXd& rhs) const;

  // d A p of the entries that were taken out, where `p` leaves the held blocks in place.
  [[nodiscard]] double coupled_work(const Eigen::VectorXd& d, const Eigen::VectorXd& p) const;

  // True when `p` moves a held block: the first Newton step of a time step does.
  [[nodiscard]] bool moved_by(const Eigen::VectorXd& p) const;

  // Sum of d_p . force.
  [[nodiscard]] double work(const Eigen::VectorXd& force) const;

  // The change of an interface's gaps by the held of its blocks.
  [[nodiscard]] Vec4 gap_increment(const InterfaceElement& element) const;

  // True when they are at `time` where they are now.
  [[nodiscard]] bool stand_still_until(const Model& model, const State& state, double time) const;

  // Prescribed velocities and accelerations at the state's time.
  void set_rates(const Model& model, State& state) const;

 private:
  struct Coupling {
    int block, held;
    Mat6 stiffness;  // force on `block` by the unknowns of `held`
  };

  std::vector<int> blocks_;          // as in Model::held_blocks
  std::vector<Vec6> increments_;     // as blocks_
  std::vector<int> place_;           // of every block in blocks_, -1 for the others
  bool move_ = false;                // not all of them stand still
  std::vector<Coupling> couplings_;  // only kept where they move
};

}  // namespace dda
