// What acted at the end of the last step, where gaps have been measured anew since.
//
// The rows of a step belong to one moment of it. What they miss where blocks turn, a way of second order in the turn,
// is put right at the start of the next step, and with it forces jump by the stiffness times that way, which nothing
// has balanced. A balance with a share alpha_f of the forces at the start has to have them as the last step ended with
// them: with the jump in, those at its end would be off by -alpha_f of it, and who reads them, or judges friction and
// strength by them, would see much of the jump where joints and supports are stiff, and nothing of it in the motion.
// Contacts of vertices foresee what their rows miss (engine/contact/foreseen_gap.h).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/contact/interface_element.h"
#include "engine/core/types.h"

namespace dda {

struct BlockSystem;

class KeptForces {
 public:
  // To be called before gaps are measured anew: remembers what acts, if it is the first time in this step.
  void note(const BlockSystem& system);
  // To be called when they have been: by how much that has changed the forces on the blocks.
  void compare(const BlockSystem& system);
  // The step is over.
  void forget();

  // Forces on the blocks' unknowns, 6 a block, which acted at the start by so much less than is measured; empty where
  // there never were any.
  [[nodiscard]] const Eigen::VectorXd& jump() const { return jump_; }

 private:
  struct OfInterface {
    int block_a, block_b;
    Vec2 from;
    Vec4 force, gap;
  };

  bool is_noted_ = false;
  std::vector<OfInterface> interfaces_;
  std::vector<Vec2> supports_, links_;
  std::vector<Vec3> linings_;
  Eigen::VectorXd jump_;
};

}  // namespace dda
