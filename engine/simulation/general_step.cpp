#include "engine/simulation/general_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/contact/contact_geometry.h"
#include "engine/contact/foreseen_gap.h"
#include "engine/contact/interface_frame.h"
#include "engine/contact/make_element.h"
#include "engine/contact/open_close.h"
#include "engine/contact/projected_stretch.h"
#include "engine/core/phase_clock.h"
#include "engine/model/moving_stages.h"
#include "engine/simulation/accepted_contacts.h"
#include "engine/simulation/bonded_joints.h"
#include "engine/simulation/carried_motion.h"
#include "engine/simulation/force_balance.h"
#include "engine/simulation/free_field.h"
#include "engine/simulation/hardly_slips.h"
#include "engine/simulation/held_blocks.h"
#include "engine/simulation/kinematic_update.h"
#include "engine/simulation/measured_anew.h"
#include "engine/simulation/parts_of_stage.h"
#include "engine/simulation/prescribed_motion.h"
#include "engine/simulation/step_limits.h"
#include "engine/simulation/system_matrix.h"
#include "engine/simulation/turning_stiffness.h"

namespace dda {
namespace {

// How often a step is solved with contacts looked for from further away, or with more drag on loose blocks, before it
// is cut. Two solutions are enough for what falls or is thrown; loose blocks of a static stage take a few.
constexpr int most_rounds = 10;

ContactRule contact_rule(const Model& model, const Stage& stage, double dt) {
  const Integrator& integrator = stage.integrator;
  const double rate = integrator.is_static ? 0 : 1 / (dt * (1 - integrator.alpha_f));
  return {integrator.conserves_contact_energy, stage.unlimited_strength, model.length_tolerance, rate};
}

// Quick passes hardly find the way down of ends that have ridden up, and the others do in some 40. What else a static
// stage tries leads astray there: in shorter steps blocks come down later than they slide, and what slides by given
// friction neither rides up nor down. A block that was drawn back on its joint kept 70 to 84 % of its rise so.
bool needs_sure_passes(const BlockSystem& system, const GivenFriction& given) {
  return system.plan.is_static && system.plan.dilation && !given.is_given();
}

}  // namespace

GeneralStep::GeneralStep(BlockSystem& system)
    : system_(system), solver_(system.costs), face_loads_(system.model), base_(0, {}) {
  if (has_finite_kinematics(system.model)) {
    range_ = ContactRange(system.model, system.contacts.interfaces);
    acting_ = system.state;
  }
  if (!contacts_move(system.model)) return;
  system.contacts.can_change = true;
  moving_.emplace(system.model, system.state, system.contacts);
}

BlockMatrix GeneralStep::pattern() const {
  std::vector<std::pair<int, int>> pairs = system_.reinforcement.pairs();
  if (moving_) pairs.insert(pairs.end(), moving_->pairs().begin(), moving_->pairs().end());
  // What is bonded stays coupled however far it is drawn apart, and may then be no pair of the search.
  return make_system_matrix(static_cast<int>(system_.model.blocks.size()), system_.contacts, std::move(pairs));
}

void GeneralStep::set_up(BlockMatrix pattern) {
  base_ = pattern;
  solver_.begin(std::move(pattern), system_.plan.solver, system_.plan.chi.largest);
  set_step_size(system_.stage_in_force().dt_of(system_.clock.step));
  list_contacts();
  system_.drag.hold_loose(system_.model.blocks.size(), system_.held);
}

void GeneralStep::set_step_size(double dt) {
  const Stage& stage = system_.stage_in_force();
  system_.coefficients = step_coefficients(stage.integrator, dt);
  rule_ = contact_rule(system_.model, stage, dt);
  base_is_current_ = false;
}

void GeneralStep::list_contacts() {
  changing_.clear();
  bonded_.clear();
  for (std::size_t i = 0; i < system_.contacts.elements.size(); ++i) {
    const bool can_change = system_.plan.contacts_judged && can_open_or_slide(system_.contacts.elements.own()[i]);
    (can_change ? changing_ : bonded_).push_back(static_cast<int>(i));
  }
  face_loads_.list(system_.model, system_.contacts);
}

Status GeneralStep::advance(double dt, Taken taken) {
  taken_ = taken;
  given_friction_.begin_step(system_);
  if (dt != system_.coefficients.dt) set_step_size(dt);
  const bool tries = taken == Taken::if_hardly_slips, can_be_cut = taken != Taken::to_the_end;
  message_ = can_be_cut && moving_ ? foreseen_turn_problem(system_) : "";
  if (!message_.empty()) return Status::not_converged;
  if (system_.plan.is_static && !tries && system_.drag.ease()) base_is_current_ = false;
  const auto solve_again = [this] {
    system_.increment.setZero();  // what did not settle is no place to begin
    return solve_far_enough();
  };
  Status status = solve_far_enough();
  const auto failed = [&] { return status == Status::not_converged && !tries; };
  if (failed() && cushion_.put_in(system_)) status = solve_far_enough();
  if (failed() && can_be_cut && needs_sure_passes(system_, given_friction_)) {
    taken_ = Taken::to_the_end;
    status = solve_again();
  }
  if (failed() && (can_be_cut ? given_friction_.give(system_) : given_friction_.give_to_shortest_part(system_)))
    status = solve_again();
  if (status == Status::ok && can_be_cut && goes_further_than_the_last_part(system_)) status = Status::not_converged;
  if (status != Status::ok) {
    if (tries) system_.increment.setZero();  // no place to begin either
    if (system_.plan.is_static) put_down(system_);
    given_friction_.take_back();
    face_loads_.take_back(system_);
    return status;
  }
  accept();
  return Status::ok;
}

// A step is solved with the contacts that were looked for, and solved again where what came out moves blocks beyond
// them.
Status GeneralStep::solve_far_enough() {
  rule_.capacity_is_given = given_friction_.is_given();
  pose();
  for (int round = 0; round < most_rounds; ++round) {
    const Status status = solve();
    system_.increment = solver_.increment();
    if (status != Status::ok) return status;
    if (!moves_further_than_seen()) {
      if (!moving_) return status;
      message_ = turn_problem(system_);
      return message_.empty() ? Status::ok : Status::not_converged;
    }
    pose();
  }
  message_ =
      fmt::format("blocks move beyond the contacts looked for in {} solutions of a step of {:.3g} s: take a smaller dt",
                  most_rounds, system_.coefficients.dt);
  return Status::not_converged;
}

// The problem of the step under way.
void GeneralStep::pose() {
  face_loads_.take_back(system_);
  // By the ends that touch now and the tension there is now.
  if (cushion_.is_in() || base_turns_ || has_turning_stiffness(system_)) base_is_current_ = false;
  aim(system_.model, system_.state, system_.load_time_after(system_.coefficients.dt), system_.held);
  if (takes_blocks_along(system_)) carry_along(system_);
  if (system_.plan.finite_kinematics) follow_geometry();
  if (system_.plan.loads) system_.loads_at(system_.load_time_after(system_.coefficients.dt), system_.forces.load_new);
  face_loads_.pose(system_.load_time_after(system_.coefficients.dt), system_);
  if (system_.reinforcement.linings.begin_step()) base_is_current_ = false;
  form_rhs(system_, rhs_);
}

// True when the step must be solved again, with drag on loose blocks or contacts looked for from further away.
bool GeneralStep::moves_further_than_seen() {
  // Where contacts stay those of the drawing, a block that nothing holds would go on for ever.
  const bool looks_for_loose = moving_ || system_.stage().equilibrium > 0;
  if (system_.plan.is_static && looks_for_loose && hold_back_what_goes_far(system_)) {
    base_is_current_ = false;
    return true;
  }
  if (!moving_ || !system_.plan.finite_kinematics) return false;  // contacts stay, however far blocks go
  if (!moving_->widen(system_.model, system_.state, system_.contacts, system_.increment)) return false;
  moved_ = std::numeric_limits<double>::infinity();  // the geometry is to be followed again, and searched
  return true;
}

// Forces act in the geometry that is foreseen for the moment to which the balance belongs; gaps are those of now. What
// is foreseen may be wrong, so it counts as motion that the geometry has still to follow.
bool GeneralStep::follow_geometry() {
  const double coming = largest_motion_within(system_, system_.coefficients.acts_at * system_.coefficients.dt);
  const double tolerance = geometry_tolerance(system_);
  const bool stays = std::max(moved_, coming) <= tolerance;
  if (stays) foresee_nothing(system_.supports);
  if (stays) return false;
  note_forces(system_);
  place_geometry(coming > tolerance ? coming : 0);
  compare_forces(system_);
  return true;
}

void GeneralStep::place_geometry(double coming) {
  BlockSystem& s = system_;
  const PhaseScope scope(Phase::geometry);
  const bool moves = coming > 0;
  moved_ = coming;
  const double most = moving_ ? most_turn : std::numeric_limits<double>::infinity();
  foresee(s.state, moves ? s.coefficients.dt : 0, s.coefficients.acts_at, most, acting_);
  follow_blocks(s.model, acting_, s.plan.is_static, s.state, s.terms);
  if (feels_spin(s.plan)) set_centrifugal_forces(s.model, s.state, s.terms);
  const bool stretches_ended = follow_contacts();
  if (moves && moving_ && s.coefficients.acts_at != 0.5)
    foresee_gaps(acting_.velocity, s.coefficients.dt, s.coefficients.acts_at, s.contacts);
  update_geometry(s.model, acting_, s.supports);
  measure_gaps(s.model, s.state, s.load_time(), s.supports);
  foresee_gaps(s.model, s.state, acting_.velocity, moves ? s.coefficients.dt : 0, s.coefficients.acts_at, s.supports);
  s.reinforcement.bolts.update_geometry(s.model, s.state, acting_);
  s.reinforcement.linings.update_geometry(s.model, s.state, acting_);
  if (s.plan.viscous_edges) update_geometry(s.model, acting_, s.clock.stage, s.damping);
  if (s.plan.loads) {
    s.external.update_geometry(s.model, acting_);
    s.excavated.released.update_geometry(acting_.deformation);
    if (s.free_field) s.free_field->update_geometry(s.model, acting_, s.clock.stage);
    s.loads_at(s.load_time(), s.forces.load_old);
  }
  refresh_tractions(s.state, s.contacts);
  measure_internal_forces(s);
  s.audit.geometry_followed(s.stored_energy_now(), stretches_ended);
  base_is_current_ = false;
}

// Whether some stretches went over to springs of vertices.
bool GeneralStep::follow_contacts() {
  BlockSystem& s = system_;
  if (!moving_) {
    update_geometry(s.model, s.state, acting_, s.contacts);
    return false;
  }
  ++s.costs.counters.contact_searches;
  const PhaseScope scope(Phase::search);
  const std::size_t stretches = moving_->stretches();
  moving_->let_part(s.model, s.state, s.contacts);
  if (moving_->follow(s.model, s.state, acting_, s.plan.is_static ? 0 : s.coefficients.dt, s.contacts)) {
    base_ = pattern();
    solver_.set_pattern(base_);
  }
  list_contacts();
  return moving_->stretches() != stretches;
}

void GeneralStep::assemble_base() {
  if (base_is_current_) return;
  const PhaseScope scope(Phase::assembly);
  const BlockSystem& s = system_;
  assemble_base_matrix(s.coefficients, s.terms, s.damping, s.supports, s.contacts, bonded_, base_);
  s.reinforcement.linings.add_stiffness(s.coefficients.stiffness, base_);
  if (s.plan.is_static) s.drag.add_to(s.terms, s.coefficients, base_);
  base_turns_ = add_turning_stiffness(s, base_);
  cushion_.add_to(s, changing_, base_);
  base_is_current_ = true;
  ++base_version_;
}

StepProblem GeneralStep::problem() const {
  const BlockSystem& s = system_;
  return {.base = base_,
          .base_version = base_version_,
          .rhs = rhs_,
          .guess = s.increment,
          .begins_at_guess = takes_blocks_along(s),
          .factor = s.coefficients.stiffness,
          .areas = s.terms.area,
          .asked_balance = s.forces.asked_balance,
          .contacts = {changing_, s.contacts.elements.own(), s.contacts.strengths, s.contacts.states, rule_},
          .bolts = s.plan.reinforcement.bolts ? s.reinforcement.bolts.links() : std::span<const LinkElement>{},
          .held = s.held,
          .dilates = s.plan.dilation && !rule_.capacity_is_given,
          .max_passes = most_passes(s.stage()),
          .to_the_end = taken_ == Taken::to_the_end,
          .goes_from_inside = goes_from_inside(s),
          .goes_one_way = s.plan.is_static};
}

Status GeneralStep::solve() {
  assemble_base();
  const StepSolution& solution = solver_.solve(problem());
  int rounds_of_linings = 0;
  const int most_yields = taken_ == Taken::to_the_end ? LiningSet::most_rounds : LiningSet::most_rounds_before_a_cut;
  while (solution.status == Status::ok && rounds_of_linings < most_yields) {
    if (taken_ == Taken::if_hardly_slips && !hardly_slips(system_, solver_, solution, bonded_))
      return Status::not_converged;
    if (solution.settled_from_inside) note_unsettled(solution, system_);
    const bool broke = replace_broken_joints() || solution.something_broke();
    if (broke) taken_ = Taken::to_the_end;  // it did so in this step, and a shorter one would not know of it
    // Linings that yield lie outside of the problem as well: Newton's method around it.
    LiningRound yield;
    if (system_.plan.reinforcement.linings_yield)
      yield = system_.reinforcement.linings.follow(solver_.increment(), rounds_of_linings++);
    if (!broke && !yield.goes_on) return Status::ok;
    if (yield.goes_on) {
      if (yield.has_other_slopes) base_is_current_ = false;
      assemble_base();
      form_rhs(system_, rhs_);
    }
    solver_.go_on(problem());
  }
  if (solution.status == Status::ok) {
    message_ = "linings that yield find no balance";
    return Status::not_converged;
  }
  // Nothing stays of a step that was only tried, whatever it did not find.
  if (solution.failure == Failure::unsettled && taken_ != Taken::if_hardly_slips) note_unsettled(solution, system_);
  message_ = solution.failure == Failure::unsettled ? unsettled_message(solution, system_) : sentence(solution.failure);
  return solution.status;
}

// Bonded joints lie outside of the problem, and break here: see weaken().
bool GeneralStep::replace_broken_joints() {
  if (!system_.plan.contacts_judged) return false;
  bool replaced = false;
  for (std::size_t b = 0; b < bonded_.size();) {
    const int index = bonded_[b];
    const auto i = static_cast<std::size_t>(index);
    const std::array<bool, 2> broken = ends_that_break(system_, solver_.increment(), i);
    if (!broken[0] && !broken[1]) {
      ++b;
      continue;
    }
    weaken(i);  // it leaves the list
    const auto place = std::lower_bound(changing_.begin(), changing_.end(), index);
    solver_.admit(problem(), static_cast<std::size_t>(place - changing_.begin()), broken);
    replaced = true;
  }
  if (!replaced) return false;
  system_.sum_internal_forces(system_.forces.internal_old);
  if (system_.forces.by_faces.size() > 0) system_.forces.internal_old -= system_.forces.by_faces;
  form_rhs(system_, rhs_);
  assemble_base();
  return true;
}

// An interface with an end beyond its strength goes on under the classical law, with the same forces at the start of
// the step and that end broken: blocks lose with the law the forces that it makes of their strains, and what that
// leaves may be within the strength again. Its other end is judged from the next pass on.
void GeneralStep::weaken(std::size_t i) {
  BlockSystem& s = system_;
  InterfaceElement& element = s.contacts.elements.edit()[i];
  const Interface& interface = s.contacts.interfaces[i];
  const double energy_before = interface_energy(element, s.contacts.states[i]);
  element = make_element(s.model, interface, InterfaceLaw::classical);
  const InterfaceFrame frame =
      s.plan.finite_kinematics ? current_frame(s.model, s.state, interface) : reference_frame(s.model, interface);
  set_geometry(s.model, frame, element);
  s.contacts.states[i] = as_classical(s.contacts.states[i], element.stiffness);
  if (s.contacts.strengths[i].is_dry()) s.contacts.states[i].broken = {true, true};  // no end has a bond to keep
  s.audit.interface_replaced(energy_before - interface_energy(element, s.contacts.states[i]));
  list_contacts();
  base_is_current_ = false;
}

void GeneralStep::note_penetrations() {
  if (system_.plan.contacts_can_change)
    dda::note_penetrations(system_.model, system_.contacts, system_.terms, system_.state, deepest_);
}

bool GeneralStep::is_in_contact_range() {
  if (!system_.plan.finite_kinematics || moving_) return true;
  message_ = range_.problem(system_.model, system_.state, system_.contacts);
  return message_.empty();
}

void GeneralStep::accept() {
  const PhaseScope scope(Phase::acceptance);
  BlockSystem& s = system_;
  const double settling_before = taken_by_settling(s.audit.ledger());
  double work = inertia_work(s.coefficients, s.terms, s.state, s.increment);
  if (feels_spin(s.plan)) work -= centrifugal_work(s.terms, s.increment);
  if (s.plan.is_static)
    work += s.drag.work(s.terms, s.coefficients, s.increment) + cushion_.work(s, changing_) + turning_work(s);
  given_friction_.settled(s);
  if (given_friction_.was_given()) ++s.costs.counters.steps_of_given_friction;
  const bool more_are_loose = s.plan.is_static && s.stage().equilibrium > 0 && finds_loose_blocks(s);
  if (cushion_.wears(s.passes_of_step()) || more_are_loose) base_is_current_ = false;
  accept_bonded(bonded_, s);  // by the stresses of the start
  move_blocks(s.stage().kinematics, s);
  if (s.plan.finite_kinematics) moved_ += largest_motion(system_);
  // What only a matrix built anew may see: the next step follows the geometry.
  const bool geometry_is_late = s.plan.finite_kinematics && moved_ > geometry_tolerance(s);
  if (geometry_is_late) keep_angular_momenta(s.model, s.state, s.terms);
  const double beyond_end = accept_contacts(solver_.contacts(), moving_.has_value(), s);
  if (!s.stage().paces_itself()) note_penetrations();
  if (s.plan.contacts_can_change && s.plan.finite_kinematics)  // or contacts stay as drawn, and nothing can pass
    note_depths_in_thickness(s.model, s.state, s.contacts, range_.least_widths(), s.excavated.came_in_over,
                             deepest_.in_thickness);
  s.reinforcement.bolts.accept(solver_.bolts(), s.audit);
  s.reinforcement.linings.accept(s.increment, s.audit);
  accept_supports(s);
  s.sum_internal_forces(s.forces.internal_new);
  face_loads_.accept(s);
  finish_step(work, s.stored_energy_now(), s);
  keep_friction_to_balance(settling_before, beyond_end, s);
  if (geometry_is_late) turn_strains_home(s.state, s.terms);  // what is recorded has the directions of now
  if (more_are_loose) s.drag.hold_loose(s.model.blocks.size(), s.held);
}

}  // namespace dda
