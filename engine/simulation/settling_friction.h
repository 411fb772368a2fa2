// Which steps of a static stage that paces itself take the friction of their contacts as given.
//
// Where hundreds of small blocks find their places at once the open-close iteration, in which friction follows the
// normal forces, may have nothing to converge to, or goes in circles: Coulomb's law gives a step no potential. With the
// capacities of the normal forces at its start a step is a convex problem, which has one answer at any length and is
// sure to be solved. What the step leaves is friction of a moment ago, and the next takes it up: Coulomb's law as the
// fixed point of problems with given friction (Panagiotopoulos 1975), one a step. Once nothing moves both are the same.
// But a step that took friction as given proves nothing, so no stage ends with one.
#pragma once

namespace dda {

struct BlockSystem;

class SettlingFriction {
 public:
  // The step under way takes it as given.
  [[nodiscard]] bool is_given() const { return steps_left_ > 0; }
  // The step under way did not settle otherwise: it and the next ones take it as given. False where they did already,
  // and where friction must follow the forces: in other stages, and in the first steps of one.
  [[nodiscard]] bool give(const BlockSystem& system);
  // The step under way did not settle so either: a shorter one is tried with friction that follows the forces.
  void take_back() { steps_left_ = 0; }
  // The step under way is accepted.
  void settled(const BlockSystem& system);
  // The last step accepted took it as given.
  [[nodiscard]] bool was_given() const { return was_given_; }

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [steps_left, was_given] = self;
    archive(steps_left, was_given);
  }

 private:
  int steps_left_ = 0;
  bool was_given_ = false;
};

}  // namespace dda
