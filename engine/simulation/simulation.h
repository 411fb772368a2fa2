// Runs a model: scene facts in, states out.
//
//   Simulation simulation(model);
//   while (!simulation.finished() && simulation.step() == Status::ok) use(simulation.state());
//
// One step: contact geometry -> matrix (only when something in it changed) -> solve -> judge contacts, again until
// none changes -> move. A step that does not converge is retried in halves; the state only ever holds converged steps.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/contact/moving_contacts.h"
#include "engine/contact/open_close.h"
#include "engine/core/counters.h"
#include "engine/core/phase_times.h"
#include "engine/core/status.h"
#include "engine/linear/block_matrix.h"
#include "engine/linear/solver.h"
#include "engine/model/energy.h"
#include "engine/model/model.h"
#include "engine/model/state.h"
#include "engine/simulation/block_terms.h"
#include "engine/simulation/bolt_set.h"
#include "engine/simulation/contact_range.h"
#include "engine/simulation/energy_audit.h"
#include "engine/simulation/external_forces.h"
#include "engine/simulation/friction_newton.h"
#include "engine/simulation/held_blocks.h"
#include "engine/simulation/linear_operators.h"
#include "engine/simulation/penetration.h"
#include "engine/simulation/step_coefficients.h"
#include "engine/simulation/step_plan.h"
#include "engine/simulation/support_set.h"

namespace dda {

class FreeField;

class Simulation {
 public:
  // The model must be finished (finish_model) and have at least one stage.
  explicit Simulation(Model model);
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;
  ~Simulation();

  // Advances by one time step of the current stage, and on to the next stage after the last step of one. Anything but
  // ok leaves the state at the last converged moment; message() says why. When finished() it does nothing and returns
  // Status::finished.
  [[nodiscard]] Status step();

  [[nodiscard]] bool finished() const { return stage_ >= model_.stages.size(); }
  [[nodiscard]] const std::string& message() const { return message_; }

  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] const State& state() const { return state_; }
  [[nodiscard]] const ContactSet& contacts() const { return contacts_; }
  // Contacts are looked for anew as blocks move: their list changes from step to step.
  [[nodiscard]] bool follows_contacts() const { return moving_.has_value(); }
  // The state of one interface now. (In a linear scene it is not kept from step to step but computed here.)
  [[nodiscard]] InterfaceState interface_state(std::size_t index) const;
  // The columns beside free-field sides, stepped along; nullptr where there are none.
  [[nodiscard]] const Simulation* free_field_columns() const;
  [[nodiscard]] const std::vector<SupportElement>& supports() const { return supports_; }
  [[nodiscard]] const BoltSet& bolts() const { return bolts_; }
  [[nodiscard]] const StepPlan& plan() const { return plan_; }
  [[nodiscard]] const EnergyLedger& energy() const { return audit_.ledger(); }
  [[nodiscard]] Counters counters() const;
  // Since this object was made; what a step does besides is in none of them.
  [[nodiscard]] const PhaseTimes& phase_times() const { return phase_times_; }
  // Of all steps with contacts that can change.
  [[nodiscard]] const Penetration& deepest_penetration() const { return deepest_; }

  // Largest unbalanced force of any unknown in the last step, internal against external without inertia, divided by the
  // largest load, weight or in-situ force on an interface: what is left on the way to static equilibrium.
  [[nodiscard]] double out_of_balance() const;

  // out_of_balance() at the end of every stage; NaN for stages that are not static or not over.
  [[nodiscard]] const std::vector<double>& static_out_of_balance() const { return static_out_of_balance_; }

  [[nodiscard]] std::int64_t steps_in_all_stages() const;

 private:
  friend struct SnapshotAccess;  // snapshot.h

  void begin_stage();
  void set_step_size(double dt);
  [[nodiscard]] const Stage& stage() const { return model_.stages[stage_]; }
  [[nodiscard]] std::int64_t steps_in_stage() const;

  [[nodiscard]] Status advance(double dt, int reductions_left);
  [[nodiscard]] Status try_step(double dt);

  // General step (simulation.cpp, open_close_loop.cpp)
  void prepare_step();
  void follow_geometry();
  void follow_contacts();
  struct Motion {
    std::size_t block = 0;
    double share = 0;
  };
  [[nodiscard]] Motion largest_motion() const;
  [[nodiscard]] bool moves_too_far();
  [[nodiscard]] std::string unsettled_message() const;
  void form_constant_rhs();
  [[nodiscard]] Status refactor();
  void assemble_matrix();
  [[nodiscard]] Status factorize();
  [[nodiscard]] Status solve_for_increment(Eigen::VectorXd& increment);

  // Open-close iteration (open_close_loop.cpp)
  [[nodiscard]] Status find_contact_statuses();
  void start_trials();
  [[nodiscard]] Status settle_contacts();
  [[nodiscard]] bool capacities_stand_still();
  [[nodiscard]] bool dilations_stand_still();
  [[nodiscard]] Status solve_pass();
  void add_contact_rhs(Eigen::VectorXd& rhs) const;
  [[nodiscard]] Vec4 constant_force(std::size_t i, const InterfaceSprings& springs) const;
  void restart_trials();
  [[nodiscard]] bool take_newton_step();
  [[nodiscard]] double length_of_step();
  [[nodiscard]] double mismatch_of_whole_step() const;
  void follow_trials(double share);
  void follow_whole(std::size_t i);
  [[nodiscard]] double negligible_force() const;
  [[nodiscard]] double round_off_of_forces() const;
  [[nodiscard]] Vec3 trial_stress(int block) const;
  [[nodiscard]] bool break_interfaces();
  [[nodiscard]] bool weaken_consistent(std::size_t i);

  // Its quick passes (friction_newton.cpp)
  [[nodiscard]] bool has_something_to_settle();
  void move_held_blocks();
  [[nodiscard]] bool newton_finds_balance();
  [[nodiscard]] bool goes_in_circles(int stalled_passes) const;
  [[nodiscard]] double work_of_pass() const;
  [[nodiscard]] bool is_balanced() const;
  [[nodiscard]] double negligible_imbalance() const;
  void list_live_interfaces();
  [[nodiscard]] Status bring_matrix_up_to_date(bool anew, bool& changed);
  [[nodiscard]] bool take_up_active_rows(std::size_t i, bool amend);
  void amend_matrix(std::size_t i);
  void form_residual();
  [[nodiscard]] double largest_entry(const Eigen::VectorXd& force, std::size_t block) const;
  [[nodiscard]] double largest_entry(const Eigen::VectorXd& force) const;
  [[nodiscard]] Status solve_newton_step(double relative);
  void list_couplings();
  void multiply_coupled(const Eigen::VectorXd& v, Eigen::VectorXd& w) const;
  void multiply_in_pass(const Eigen::VectorXd& v, Eigen::VectorXd& w) const;
  void take_newton_step_with_friction(bool strictly);
  // Its local passes (local_pass.cpp)
  [[nodiscard]] Status prepare_pass(bool& changed);
  [[nodiscard]] Status prepare_whole_pass();
  [[nodiscard]] bool choose_part();
  void add_neighbours();
  void follow_residual(const FrictionNewton::LiveContact& contact, const Vec4& moved, const Vec4& force_before);

  void accept_step();
  void accept_contacts();
  void accept_supports();
  void damp_velocities();
  void release_shear_of_contacts();
  [[nodiscard]] bool reached_equilibrium();
  [[nodiscard]] bool loads_stand_still_until(double time);
  [[nodiscard]] Status end_stage();
  void set_held_rates();
  void let_go_of_supports();
  void begin_viscous_edges();
  [[nodiscard]] bool geometry_moves() const;
  [[nodiscard]] StoredEnergy stored_energy_now() const;
  [[nodiscard]] BlockMatrix make_moving_matrix() const;
  void audit_held_blocks();
  [[nodiscard]] bool contacts_are_in_range();
  void add_dashpot_and_support_rhs();
  [[nodiscard]] Status step_free_field();
  void loads_at(double time, Eigen::VectorXd& force) const;
  void start_energy_audit();

  // Linear step (linear_step.cpp)
  void begin_linear_stage();
  void end_linear_stage();
  void keep_gaps_at_rest();
  [[nodiscard]] Eigen::VectorXd initial_linear_acceleration();
  [[nodiscard]] Status linear_step();
  void form_linear_rhs();
  void accept_linear_step();
  void linear_internal_forces(Eigen::VectorXd& force);
  [[nodiscard]] double linear_elastic_energy() const;
  [[nodiscard]] StoredEnergy linear_stored_energy() const;
  void set_energy_offset();
  [[nodiscard]] double initial_contact_energy() const;
  void set_consistent_weight();
  void sum_internal_forces(Eigen::VectorXd& force) const;
  void set_initial_acceleration();

  Model model_;
  State state_;
  ContactSet contacts_;
  std::vector<InterfaceTrial> trial_;  // interfaces in the current open-close pass
  std::vector<Vec4> matrix_rows_;      // active rows whose stiffness the matrix holds
  FrictionNewton newton_;
  std::optional<MovingContacts> moving_;  // only where blocks can move against each other
  double moved_ = 0;                      // largest motion since the geometry was last followed, in block sizes
  std::vector<Vec4> turned_;              // rotation (rad) and strains of each block that its stress has followed
  std::vector<SupportElement> supports_;
  BoltSet bolts_;
  HeldBlocks held_;
  BlockTerms terms_;
  BlockDamping damping_;
  ExternalForces external_;
  std::unique_ptr<FreeField> free_field_;  // only where a side has one
  EnergyAudit audit_;

  double in_situ_force_ = 0;  // N per m of thickness, the largest on an interface

  std::size_t stage_ = 0;
  std::vector<double> static_out_of_balance_;  // one a stage
  std::int64_t step_in_stage_ = 0;
  double stage_start_ = 0;
  StepPlan plan_;
  StepCoefficients coefficients_;
  ContactRule contact_rule_;
  ContactRange contact_range_;  // looked at in finite kinematics
  BlockMatrix matrix_;
  std::unique_ptr<LinearSolver> solver_;
  bool matrix_is_current_ = false;
  std::optional<LinearOperators> linear_;  // only in a linear stage
  Counters counters_;
  PhaseTimes phase_times_;
  Penetration deepest_;
  std::string message_;

  // 6 entries a block.
  Eigen::VectorXd load_old_, load_new_;
  Eigen::VectorXd internal_old_, internal_new_;
  Eigen::VectorXd constant_rhs_, rhs_, increment_, target_;

  // Linear scenes, 6 entries a block: M v, M a, K u without and internal forces that u does not change.
  Eigen::VectorXd momentum_, inertia_force_, elastic_force_, internal_at_rest_;
  double energy_offset_ = 0;  // makes the elastic energy of a linear scene the sum of its parts, J per m of thickness
};

}  // namespace dda
