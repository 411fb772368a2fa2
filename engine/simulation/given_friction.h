// Which steps take the friction of their contacts as given: some of static stages that pace themselves, and in motion
// the shortest parts of steps that settle in no other way.
//
// Where hundreds of small blocks find their places at once the open-close iteration, in which friction follows the
// normal forces, may have nothing to converge to, or goes in circles: Coulomb's law gives a step no potential. With the
// capacities of the normal forces at its start a step is a convex problem, which has one answer at any length and is
// sure to be solved. What the step leaves is friction of a moment ago, and the next takes it up: Coulomb's law as the
// fixed point of problems with given friction (Panagiotopoulos 1975), one a step. Once nothing moves both are the same.
// But a step that took friction as given proves nothing, so no static stage ends with one. In motion friction is then
// late by a part of a step, an error of first order in a time that is a 64th of dt by default; a counter says how
// often.
#pragma once

namespace dda {

struct BlockSystem;

class GivenFriction {
 public:
  // A step is to be taken: one that goes on with loads or motions does so with friction that follows the forces.
  void begin_step(const BlockSystem& system);
  // The step under way takes it as given.
  [[nodiscard]] bool is_given() const { return steps_left_ > 0; }
  // The step under way did not settle otherwise: it and the next ones take it as given. False where they did already,
  // and where friction must follow the forces: in other stages, and in the first steps of one.
  [[nodiscard]] bool give(const BlockSystem& system);
  // The same for a part of a step in motion that cannot be cut further.
  [[nodiscard]] bool give_to_shortest_part(const BlockSystem& system);
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
