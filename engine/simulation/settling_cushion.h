// What keeps a step of a static stage from opening and closing more contacts than its iteration can follow.
//
// A static step solves (c_m M + K) d = forces out of balance. Shorter steps hold back motions of much mass and little
// stiffness alone; what hops in rock of many small, wedged blocks is the stiffest there is, ends that open in one pass
// and are driven deep into each other in the next, and these the mass does not hold back before steps are so short that
// nothing moves any more. Cushions do: an end that touches as the step begins resists the change of its normal gap,
// both ways, by a share of its normal stiffness beside what its spring answers,
//   force = share * k_n * change of the normal gap in the step,   share = min(0.3/r^2, 3),
// for a step r times as long as the first that the stage tries. So cushions let go with the same power of r as the
// inertia, and the stiffest motions come to rest at no other pace than the slowest. As they multiply the motion of the
// step alone, they are nothing once the motion has died down: equilibrium is the same with them and without. Slip is
// free: blocks that slide to where they come to lie would take many steps else.
//
// They come with the first step of a stage that does not settle, and stay until a step has next to nothing to change,
// or for a hundred steps: what nothing but a cushion holds would creep on it, and where springs are a million times as
// stiff as their blocks cushions that are as stiff would hold them for good. Where steps settle there are none.
#pragma once

#include <cstdint>
#include <span>

#include "engine/linear/block_matrix.h"

namespace dda {

struct BlockSystem;

class SettlingCushion {
 public:
  // To be told when a step did not settle. Where the stage finds its own steps there are cushions from now on. Returns
  // false where there were some already, or can be none.
  [[nodiscard]] bool put_in(const BlockSystem& system);
  [[nodiscard]] bool is_in() const { return steps_left_ > 0; }
  // To be told at the end of a step, and how many passes it took. Returns whether there were cushions in it, which are
  // not those of the next.
  bool wears(std::int64_t passes) {
    if (!is_in()) return false;
    steps_left_ = passes <= passes_at_rest ? 0 : steps_left_ - 1;
    return true;
  }

  // Adds the cushions to the matrix of a step that is about to be solved. `contacts`: places of those that can open.
  void add_to(const BlockSystem& system, std::span<const int> contacts, BlockMatrix& matrix) const;

  // What they take of the blocks that are not held over the increments solved for, J per m of thickness: before the
  // states of the contacts follow.
  [[nodiscard]] double work(const BlockSystem& system, std::span<const int> contacts) const;

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [was_put_in, steps_left] = self;
    archive(was_put_in, steps_left);
  }

 private:
  static constexpr std::int64_t passes_at_rest = 5;

  bool was_put_in_ = false;
  int steps_left_ = 0;
};

}  // namespace dda
