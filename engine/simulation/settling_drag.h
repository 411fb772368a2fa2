// What keeps blocks that nothing holds from flying off in a static stage.
//
// A static step solves (c_m M + K) d = forces out of balance. Where K does not hold a block, its motion is that of a
// free fall over the whole step, which for a small loose block is many times its size. Such blocks get a drag: their
// mass counts so many times that they move by a small share of their size, and find what they come to lie on. As it
// multiplies the motion of the step alone, the drag is nothing once the motion has died down: equilibrium is the same
// with it and without it. A block that its neighbours carry along goes with them all the same, since against their
// stiffness its mass is nothing; it is recognized by that and left alone.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "engine/linear/block_matrix.h"
#include "engine/simulation/block_terms.h"
#include "engine/simulation/step_coefficients.h"
#include "engine/solve/held_unknowns.h"

namespace dda {

// The larger of a block's rotation (rad) and its strain, by the length of its tensor: whichever way the scene is
// turned.
double turn_or_strain(const Vec6& increments);

// Motion of a block in a step, in its own size: displacement of the centroid over the side of the square with its area,
// plus its rotation or strain.
double motion_share(const Vec6& increments, double area);

class SettlingDrag {
 public:
  // Begins a step: what drag there was fades. True when the step's matrix is another for it.
  bool ease();

  // Raises the drag of what moves too far by increments `d` and would not without what it is carried by. True when
  // there was any: the step is to be solved anew.
  bool raise(const BlockTerms& terms, const HeldUnknowns& held, const Eigen::VectorXd& d);

  // Accepts a step of increments `d`. What has gone half of its size under drag will not find what it could come to lie
  // on: from then on it is loose, and to be held. True when there are more of these. What others carry does not go
  // under drag, however far.
  bool follow(const BlockTerms& terms, const Eigen::VectorXd& d);
  [[nodiscard]] const std::vector<int>& loose() const { return loose_; }
  // Adds the loose to the blocks that are held, of `blocks` in all.
  void hold_loose(std::size_t blocks, HeldUnknowns& held) const;

  // Adds the drag's share of inertia to the matrix of a step.
  void add_to(const BlockTerms& terms, const StepCoefficients& step, BlockMatrix& matrix) const;

  // Work of the drag over increments `d`, J per m of thickness.
  [[nodiscard]] double work(const BlockTerms& terms, const StepCoefficients& step, const Eigen::VectorXd& d) const;

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [factors, moved, is_carried, travelled, loose, areas] = self;
    archive.of_blocks(factors);
    archive.of_blocks(travelled);
    archive.lists_blocks(loose);  // `moved`, `is_carried` and `areas` are of the step under way
  }

 private:
  std::vector<double> factors_;    // on each block's mass; empty as long as no block needed any
  std::vector<double> moved_;      // shares of the last solution of this step, 0 before the first
  std::vector<char> is_carried_;   // too far in this step, by others: more drag did not hold it back
  std::vector<double> travelled_;  // under drag, in each block's size
  std::vector<int> loose_;         // blocks, in the order found
  std::vector<double> areas_;      // m2, of the blocks that can move
};

}  // namespace dda
