#include "engine/simulation/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/core/error.h"
#include "engine/core/phase_clock.h"
#include "engine/simulation/block_system.h"
#include "engine/simulation/depth_given_back.h"
#include "engine/simulation/equilibrium.h"
#include "engine/simulation/excavation.h"
#include "engine/simulation/explicit_step.h"
#include "engine/simulation/free_field.h"
#include "engine/simulation/gain_at_start.h"
#include "engine/simulation/general_step.h"
#include "engine/simulation/height_owed.h"
#include "engine/simulation/held_blocks.h"
#include "engine/simulation/integrator_choice.h"
#include "engine/simulation/linear_step.h"
#include "engine/simulation/measured_forces.h"
#include "engine/simulation/parts_of_stage.h"
#include "engine/simulation/prescribed_motion.h"
#include "engine/simulation/reinforcement_of_stage.h"
#include "engine/simulation/rock_of_stage.h"
#include "engine/simulation/stability_limit.h"
#include "engine/simulation/stage_end.h"
#include "engine/simulation/step_coefficients.h"
#include "engine/simulation/step_limits.h"
#include "engine/simulation/system_matrix.h"

namespace dda {
namespace {

// The columns go first: what they do at the end of the step is then known.
Status step_free_field(BlockSystem& s, std::string& message) {
  if (!s.free_field) return Status::ok;
  const double dt = s.stage().dt_of(s.clock.step);
  const Status status = s.free_field->advance_to(s.clock.start + s.stage().time_of(s.clock.step + 1), dt);
  if (status != Status::ok) message = "columns of the free field: " + s.free_field->message();
  return status;
}

BlocksInMotion in_motion(const BlockSystem& s) {
  return {s.model, s.state, s.contacts, s.plan, s.clock, s.excavated.absent};
}

void begin_accelerations(BlockSystem& s) {
  set_held_rates(s.model, s.state);
  s.audit.of_start.free_step = energy_of_a_free_step(s);
  s.audit.of_start.left = gain_of_first_step(s);
}

// What accelerations still owe of the last steps, longer ones would give several times over: they begin anew, as those
// of a stage do.
void begin_longer_steps(Step& step, BlockSystem& s) {
  if (s.stage().dt_of(s.clock.step) <= s.stage().dt_of(s.clock.step - 1)) return;
  step.begin();
  begin_accelerations(s);
}

// GroundPlan and the like ask a model that has none yet, so finish_model lets it pass.
Model with_stages(Model model) {
  if (model.stages.empty()) throw InputError("", "stages", "empty", "at least one stage to be run");
  return model;
}

}  // namespace

Simulation::Simulation(Model model) : system_(std::make_unique<BlockSystem>(with_stages(std::move(model)))) {
  BlockSystem& s = *system_;
  stability_limits_ = kept_stability_limits(s.contacts, s.model, choose_integrators(s.contacts, s.model));
  results_ = StageResults(s.model.stages.size());
  for (const InterfaceState& state : s.contacts.states)
    in_situ_force_ = std::max(in_situ_force_, state.force.cwiseAbs().maxCoeff());
  general_ = std::make_unique<GeneralStep>(s);
  linear_ = std::make_unique<LinearStep>(s);
  explicit_ = std::make_unique<ExplicitStep>(s);
  if (s.contacts.can_change)
    for (Stage& each : s.model.stages) each.integrator = with_contacts(each.integrator);
  leave_out_absent(s, *general_);
  s.sum_internal_forces(s.forces.internal_old);
  if (!s.model.free_field_sides.empty()) s.free_field = std::make_unique<FreeField>(s.model, s.contacts, s.state);
  s.loads_at(s.state.time, s.forces.load_old);
  begin_stage();
  s.audit.start(stage_step().stored_energy());
}

Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

bool Simulation::finished() const { return system_->clock.stage >= system_->model.stages.size(); }
const Model& Simulation::model() const { return system_->model; }
const State& Simulation::state() const { return system_->state; }
const ContactSet& Simulation::contacts() const { return system_->contacts; }
bool Simulation::follows_contacts() const { return general_->follows_contacts(); }
const std::vector<bool>& Simulation::absent() const { return system_->excavated.absent; }
const BoltSet& Simulation::bolts() const { return system_->reinforcement.bolts; }
const StepPlan& Simulation::plan() const { return system_->plan; }
const EnergyLedger& Simulation::energy() const { return system_->audit.ledger(); }
const Penetration& Simulation::deepest_penetration() const { return general_->deepest_penetration(); }

double Simulation::stability_limit(std::size_t stage) const { return stability_limits_[stage]; }

const Simulation* Simulation::free_field_columns() const {
  return system_->free_field ? &system_->free_field->columns() : nullptr;
}

InterfaceState Simulation::interface_state(std::size_t index) const { return interface_state_now(*system_, index); }

Counters Simulation::counters() const {
  Counters counters = system_->costs.counters;
  counters.solver_iterations += general_->solver_iterations() + linear_->solver_iterations();
  return counters;
}

Step& Simulation::stage_step() {
  if (system_->plan.explicit_steps) return *explicit_;
  if (system_->plan.linear) return *linear_;
  return *general_;
}

void Simulation::begin_stage() {
  const PhaseScope scope(Phase::stage);
  BlockSystem& s = *system_;
  if (s.clock.stage > 0) stage_step().end();
  s.audit.begin_stage(s.stage().integrator.is_static);
  s.clock.begun = true;
  s.clock.step = 0;
  s.clock.start = s.state.time;
  take_out_reinforcement(s);
  excavate(s, *general_);
  change_rock(general_->follows_contacts(), s);
  bring_in(s, *general_);
  if (s.external.begin_stage(s.model, s.clock.stage)) s.loads_at(s.state.time, s.forces.load_old);
  put_in_reinforcement(*general_, s);
  note_reinforcement_in_air(s, results_.in_air);
  set_strain_inertia(s.stage(), s.terms);
  BlockMatrix pattern = general_->pattern();
  const double dt = first_step(s.model, s.stage(), s.contacts.can_change);
  const StepPlan next =
      make_plan(s.model, s.clock.stage, s.contacts, pattern.couplings(), stiffness_numbers(s.contacts, s.terms, dt));
  const bool other_kind = next.linear != s.plan.linear || next.explicit_steps != s.plan.explicit_steps;
  if (other_kind) stage_step().hand_over();
  s.plan = next;
  if (other_kind) stage_step().take_over();
  s.clock.parts = parts_of_stage(general_->follows_contacts(), s);
  if (s.stage().paces_itself()) pace_.begin(s.model, s.stage(), s.contacts.can_change, s.clock.parts.all > 1);
  if (s.plan.is_static) damp_velocities(s);
  begin_viscous_edges(s);
  stage_step().set_up(std::move(pattern));
  stage_step().begin();
  s.forces.most_exchanged = 0;
  if (s.plan.is_static) {
    note_exchanged_forces(s);
  } else {
    begin_accelerations(s);
  }
  s.audit.small_motion.begin_stage(in_motion(s));
}

Status Simulation::step() {
  if (finished()) {
    message_ = "all stages are done";
    return Status::finished;
  }
  BlockSystem& s = *system_;
  if (!s.clock.begun) begin_stage();  // of a run that was restored between two stages
  s.clock.passes_before_step = s.costs.counters.open_close_iterations;
  s.audit.forces_of_parts.clear();
  if (const Status ahead = step_free_field(s, message_); ahead != Status::ok) return ahead;
  note_asked_balance(s, in_situ_force_);
  const auto advance_by = [this](double dt, Taken taken) { return stage_step().advance(dt, taken); };
  const auto is_sure = [this] { return stage_step().is_provisional(); };
  const Status status = is_settling() ? pace_.step(s.costs.counters, advance_by, is_sure)
                                      : advance(s.stage().dt_of(s.clock.step), s.stage().limits.step_reductions);
  if (status != Status::ok) {
    message_ = stage_step().message();
    return status;
  }
  ++s.clock.step;
  s.audit.of_start.left = gain_at_start(s);
  if (is_settling()) go_on_with_loads(in_situ_force_, pace_.is_long(), s);
  ++s.state.step;
  s.state.time = s.clock.start + s.stage().time_of(s.clock.step);
  begin_longer_steps(stage_step(), s);
  s.audit.small_motion.follow(in_motion(s));
  const bool in_range = general_->is_in_contact_range();
  if (!in_range) message_ = general_->message();
  const Status end = is_over() ? end_stage() : Status::ok;
  return in_range ? end : Status::left_contact_range;
}

Status Simulation::advance(double dt, int reductions_left) {
  // Halves settle in a few passes where the whole step would take hundreds of the sure ones; but where quick passes
  // settle at no length, these must not be taken in each of 64 parts.
  constexpr int cuts_before_sure_passes = 4;
  const Stage& stage = system_->stage();
  const int cuts = stage.limits.step_reductions - reductions_left;
  const bool can_be_cut = !stage.integrator.is_static && reductions_left > 0 && cuts < cuts_before_sure_passes;
  const auto take = [&] { return stage_step().advance(dt, can_be_cut ? Taken::unless_cut : Taken::to_the_end); };
  const Status status = cuts == 0 ? take() : memory_.part(dt, system_->contacts, system_->state.acceleration, take);
  // Static steps take no time: what acts at their end is all that they are taken for.
  if (status == Status::ok && cuts > 0 && !system_->plan.is_static) note_part(dt, *system_);
  if (status != Status::not_converged || reductions_left == 0) return status;
  if (cuts == 0) memory_.begin(system_->terms.inertia, system_->contacts, system_->state.acceleration);
  for (int half = 0; half < 2; ++half)
    if (const Status part = advance(dt / 2, reductions_left - 1); part != Status::ok) return part;
  if (cuts > 0) return Status::ok;
  memory_.end(dt, system_->state.acceleration);
  if (!system_->plan.is_static) set_held_rates(system_->model, system_->state);
  return Status::ok;
}

bool Simulation::is_settling() const { return !finished() && system_->stage().paces_itself(); }

// At equilibrium only when nothing more is to come: the clock then goes to the end of the stage.
bool Simulation::is_over() {
  // At the loads of the end: walls take some 5, loose stones that look for the ground 60. Held blocks that turn far get
  // there in hundreds of parts, each of which takes five steps at most.
  constexpr std::int64_t most_settling_steps = 500;
  BlockSystem& s = *system_;
  const std::int64_t steps = is_settling() ? s.clock.parts.steps_of_part() : s.clock.step;
  const double asked = s.stage().equilibrium;
  bool is_balanced = s.plan.is_static && asked > 0 && !stage_step().is_provisional() && out_of_balance() <= asked &&
                     nothing_prescribed_changes_until(s.end_of_stage(), s);
  if (is_balanced && goes_far_for_its_geometry(s) && general_->follow_geometry())
    is_balanced = out_of_balance() <= asked;
  is_balanced = is_balanced && !owes_height(s);
  // Half of the steps are kept for the balance.
  if (is_balanced && is_settling() && steps < most_settling_steps / 2 && give_back_depths(s)) return false;
  const bool is_over = is_balanced || steps >= (is_settling() ? most_settling_steps : s.stage().steps());
  if (is_balanced || (is_settling() && is_over)) s.state.time = s.end_of_stage();
  return is_over;
}

Status Simulation::end_stage() {
  BlockSystem& s = *system_;
  const bool unlimited_strength = s.stage().unlimited_strength;
  if (stage_step().is_provisional()) release_shear_of_contacts(s);
  if (s.stage().paces_itself()) general_->note_penetrations();
  note_results(s, in_situ_force_, results_);
  const std::string problem = problem_at_end_of(s.clock.stage, s.model, results_);
  let_go_of_loose_blocks(s);
  s.audit.small_motion.end_stage(in_motion(s));
  close_books_of_stage(s);
  if (watch_.at_end) watch_.at_end();
  if (unlimited_strength) give_up_unlimited_strength(s);
  let_go_of_supports(s);
  results_.energy[s.clock.stage] = s.audit.ledger();
  ++s.clock.stage;
  s.clock.begun = false;
  if (watch_.between && problem.empty()) watch_.between();
  if (!finished() && problem.empty()) begin_stage();
  if (problem.empty()) return Status::ok;
  message_ = problem;
  return Status::not_in_equilibrium;
}

double Simulation::out_of_balance() const { return dda::out_of_balance(*system_, in_situ_force_); }

}  // namespace dda
