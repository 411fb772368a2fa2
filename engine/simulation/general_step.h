// The step of a scene in which something can change: geometry, contacts, joints or bolts.
//
//   follow the geometry -> pose a StepProblem -> ContactSolver -> replace joints that broke, and solve on -> accept
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/contact/moving_contacts.h"
#include "engine/contact/open_close.h"
#include "engine/core/status.h"
#include "engine/simulation/block_system.h"
#include "engine/simulation/contact_range.h"
#include "engine/simulation/face_loads.h"
#include "engine/simulation/given_friction.h"
#include "engine/simulation/penetration.h"
#include "engine/simulation/settling_cushion.h"
#include "engine/simulation/step.h"
#include "engine/solve/contact_solver.h"

namespace dda {

class GeneralStep : public Step {
 public:
  // Where blocks can move against each other the contacts of the system become those that are followed.
  explicit GeneralStep(BlockSystem& system);

  void set_up(BlockMatrix pattern) override;
  void begin() override;
  [[nodiscard]] Status advance(double dt, Taken taken) override;
  void hand_over() override { solver_.end(); }
  [[nodiscard]] StoredEnergy stored_energy() const override { return system_.stored_energy_now(); }
  [[nodiscard]] bool is_provisional() const override { return given_friction_.was_given(); }
  [[nodiscard]] const std::string& message() const override { return message_; }

  // The pattern of the system's matrix: blocks that touch, or can before the pattern changes, and those that bolts tie.
  [[nodiscard]] BlockMatrix pattern() const;

  // Blocks that are absent, `absent` saying so of each, touch nothing from now on. What they were in the way of is
  // looked for in the next step. Those of `added` come in, as drawn; `at_rest`: see join_blocks.h.
  void set_blocks(const std::vector<bool>& absent, const std::vector<int>& added = {}, bool at_rest = false);
  // Brings all to the geometry of the state, or where blocks are `coming` to move (in their sizes) within the step, to
  // what is foreseen.
  void place_geometry(double coming);
  // Does so where blocks have moved since it last did, or are about to; returns whether it did. A static step is in
  // balance in the geometry in which it was solved, and may be out of it where it has moved blocks to.
  bool follow_geometry();

  // Where the blocks were when their geometry was last followed.
  [[nodiscard]] const State& acting() const { return acting_; }

  // Contacts are looked for anew as blocks move.
  [[nodiscard]] bool follows_contacts() const { return moving_.has_value(); }
  // False when bonded blocks have left the contacts of the start, which are then not followed; message() says which.
  [[nodiscard]] bool is_in_contact_range();
  [[nodiscard]] const Penetration& deepest_penetration() const { return deepest_; }
  // To be called when a stage that paces itself is over: what its steps pass through is no answer. Those of all other
  // stages are noted with every step.
  void note_penetrations();
  [[nodiscard]] std::int64_t solver_iterations() const { return solver_.solver_iterations(); }

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [system, solver, moving, range, moved, acting, deepest, cushion, given_friction, face_loads, changing, bonded,
           base, base_version, base_is_current, base_turns, rule, rhs, taken, message] = self;
    if (moving) {
      archive(*moving);
      archive.expect(moving->known_contacts() == system.contacts.interfaces.size());
    }
    archive(solver, deepest, cushion, given_friction);
    if (system.geometry_moves()) {
      archive(range, moved);
      archive.of_blocks(acting.displacement);
      archive.of_blocks(acting.deformation);
    }
    // The others follow from the system, or begin with every step.
  }

 private:
  void set_step_size(double dt);
  void list_contacts();

  void pose();
  [[nodiscard]] Status solve_far_enough();
  [[nodiscard]] bool moves_further_than_seen();
  [[nodiscard]] bool follow_contacts();
  void assemble_base();
  [[nodiscard]] StepProblem problem() const;

  [[nodiscard]] Status solve();
  [[nodiscard]] bool replace_broken_joints();
  void weaken(std::size_t i);

  void accept();

  BlockSystem& system_;
  ContactSolver solver_;
  std::optional<MovingContacts> moving_;  // only where blocks can move against each other
  ContactRange range_;                    // looked at where they cannot; widths of blocks; finite kinematics alone
  double moved_ = 0;                      // largest motion since the geometry was last followed, in block sizes
  State acting_;  // displacements and shapes of the blocks where the step's forces act; in finite kinematics alone
  Penetration deepest_;
  SettlingCushion cushion_;       // of the stage
  GivenFriction given_friction_;  // of the stage
  FaceLoads face_loads_;

  std::vector<int> changing_, bonded_;  // interfaces that can change in a step, and the others; ascending
  BlockMatrix base_;                    // of the problem: all but the contacts that can change and bolts
  std::uint64_t base_version_ = 0;
  bool base_is_current_ = false;
  bool base_turns_ = false;  // it has some stiffness of turning_stiffness.h
  ContactRule rule_;
  Eigen::VectorXd rhs_;
  Taken taken_ = Taken::to_the_end;  // the step under way
  std::string message_;
};

}  // namespace dda
