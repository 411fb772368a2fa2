#include "engine/simulation/simulation.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "engine/simulation/free_field.h"
#include "engine/simulation/kinematic_update.h"
#include "engine/simulation/system_matrix.h"
#include "engine/terms/elasticity.h"
#include "engine/terms/velocity_damping.h"

namespace dda {
namespace {

// Geometry is followed, and the matrix built anew, when some block has moved by this share of its size: directions are
// then off by as much, and gaps by half its square.
constexpr double geometry_tolerance = 1e-6;

// Blocks that move can come to touch, whether they do at the start or not, unless all joints are bonded.
bool contacts_move(const Model& model) {
  const bool can_touch =
      model.blocks.size() > 1 &&
      std::any_of(model.joints.begin(), model.joints.end(), [](const JointMaterial& joint) { return !joint.bonded; });
  return can_touch && std::any_of(model.stages.begin(), model.stages.end(),
                                  [](const Stage& stage) { return stage.kinematics == Kinematics::finite; });
}

ContactRule contact_rule(const Model& model, const Stage& stage, double dt) {
  const Integrator& integrator = stage.integrator;
  const double rate = integrator.is_static ? 0 : 1 / (dt * (1 - integrator.alpha_f));
  return {integrator.conserves_contact_energy, stage.unlimited_strength, model.length_tolerance, rate};
}

}  // namespace

Simulation::Simulation(Model model)
    : model_(std::move(model)),
      state_(initial_state(model_)),
      contacts_(make_contacts(model_)),
      supports_(make_supports(model_, state_)),
      bolts_(model_, state_),
      held_(model_),
      terms_(make_block_terms(model_)),
      damping_(make_block_damping(model_, state_, 0)),
      external_(model_, state_, contacts_.chain_ends),
      contact_range_(model_, contacts_.interfaces),
      matrix_(make_system_matrix(static_cast<int>(model_.blocks.size()), contacts_, bolts_.pairs())) {
  const Eigen::Index unknowns = matrix_.unknowns();
  turned_.assign(model_.blocks.size(), Vec4::Zero());
  static_out_of_balance_.assign(model_.stages.size(), std::numeric_limits<double>::quiet_NaN());
  for (Eigen::VectorXd* vector :
       {&load_old_, &load_new_, &internal_old_, &internal_new_, &constant_rhs_, &rhs_, &increment_, &target_})
    vector->setZero(unknowns);
  for (const InterfaceState& state : contacts_.states)
    in_situ_force_ = std::max(in_situ_force_, state.force.cwiseAbs().maxCoeff());
  if (contacts_move(model_)) {
    contacts_.can_change = true;
    moving_.emplace(model_, state_, contacts_);
    matrix_ = make_moving_matrix();
  }
  sum_internal_forces(internal_old_);
  if (!model_.free_field_sides.empty()) free_field_ = std::make_unique<FreeField>(model_, contacts_, state_);
  loads_at(state_.time, load_old_);
  begin_stage();
  start_energy_audit();
}

Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

void Simulation::start_energy_audit() { audit_.start(plan_.linear ? linear_stored_energy() : stored_energy_now()); }

StoredEnergy Simulation::stored_energy_now() const {
  StoredEnergy stored = stored_energy(terms_, state_, contacts_, supports_);
  stored.bolts = bolts_.stored_energy();
  return stored;
}

// With the pairs that can touch before the list of them changes.
BlockMatrix Simulation::make_moving_matrix() const {
  std::vector<std::pair<int, int>> pairs = bolts_.pairs();
  pairs.insert(pairs.end(), moving_->pairs().begin(), moving_->pairs().end());
  return make_system_matrix(matrix_.size(), std::move(pairs));
}

void Simulation::begin_stage() {
  step_in_stage_ = 0;
  stage_start_ = state_.time;
  set_strain_inertia(stage(), terms_);
  const StepPlan next =
      make_plan(model_, stage(), contacts_, matrix_.couplings(), stiffness_number(contacts_, terms_, stage().dt));
  if (linear_ && !next.linear) end_linear_stage();
  plan_ = next;
  if (plan_.contacts_can_change) newton_.resize(matrix_.unknowns());
  if (plan_.is_static) damp_velocities();
  if (solver_) counters_.solver_iterations += solver_->counts().iterations;
  solver_ = make_solver(plan_.solver, plan_.chi);
  solver_->analyze(matrix_);
  ++counters_.analyses;
  set_step_size(stage().dt);
  begin_viscous_edges();
  if (plan_.linear) {
    begin_linear_stage();
  } else {
    set_initial_acceleration();
  }
  set_held_rates();
}

void Simulation::set_step_size(double dt) {
  coefficients_ = step_coefficients(stage().integrator, dt);
  contact_rule_ = contact_rule(model_, stage(), dt);
  matrix_is_current_ = false;
}

// Geometry of a scene whose blocks never left the drawing is that of the model.
bool Simulation::geometry_moves() const {
  const auto begun = model_.stages.begin() + static_cast<std::ptrdiff_t>(std::min(stage_ + 1, model_.stages.size()));
  return std::any_of(model_.stages.begin(), begun,
                     [](const Stage& each) { return each.kinematics == Kinematics::finite; });
}

std::int64_t Simulation::steps_in_stage() const { return std::llround(stage().duration / stage().dt); }

std::int64_t Simulation::steps_in_all_stages() const {
  std::int64_t steps = 0;
  for (const Stage& each : model_.stages) steps += std::llround(each.duration / each.dt);
  return steps;
}

Status Simulation::step() {
  if (finished()) {
    message_ = "all stages are done";
    return Status::finished;
  }
  if (const Status ahead = step_free_field(); ahead != Status::ok) return ahead;
  const Status status = advance(stage().dt, stage().max_step_reductions);
  if (status != Status::ok) return status;
  ++step_in_stage_;
  ++state_.step;
  state_.time = stage_start_ + static_cast<double>(step_in_stage_) * stage().dt;
  const bool in_range = !plan_.finite_kinematics || moving_ || contacts_are_in_range();
  const Status end = reached_equilibrium() || step_in_stage_ >= steps_in_stage() ? end_stage() : Status::ok;
  return in_range ? end : Status::left_contact_range;
}

// Only when nothing more is to come: the clock then goes to the end of the stage.
bool Simulation::reached_equilibrium() {
  const double end = stage_start_ + static_cast<double>(steps_in_stage()) * stage().dt;
  if (!plan_.is_static || stage().equilibrium == 0 || out_of_balance() > stage().equilibrium) return false;
  if (!loads_stand_still_until(end)) return false;
  state_.time = end;
  return true;
}

bool Simulation::loads_stand_still_until(double time) {
  if (plan_.loads) {
    if (free_field_ && !free_field_->stands_still_until(time)) return false;
    loads_at(time, load_new_);
    if (load_new_ != load_old_) return false;
  }
  for (std::size_t i = 0; plan_.moving_supports && i < supports_.size(); ++i)
    if (prescribed_displacement(model_.supports[i], time) != supports_[i].prescribed) return false;
  return held_.stand_still_until(model_, state_, time);
}

Status Simulation::end_stage() {
  const Stage& ended = stage();
  const double imbalance = out_of_balance();
  if (plan_.is_static) static_out_of_balance_[stage_] = imbalance;
  let_go_of_supports();
  if (ended.unlimited_strength) release_shear_of_contacts();
  const bool balanced = !plan_.is_static || ended.equilibrium == 0 || imbalance <= ended.equilibrium;
  ++stage_;
  if (!finished()) begin_stage();
  if (balanced) return Status::ok;
  message_ = fmt::format(
      "static stage \"{}\" ended with forces out of balance by {:.2g} of the largest load, {:.2g} were asked for: give "
      "it more steps or a larger dt; blocks that nothing holds have no equilibrium",
      ended.name, imbalance, ended.equilibrium);
  return Status::not_in_equilibrium;
}

// Friction limits what contacts carry again; what they carried beyond it goes without a trace in the motion.
void Simulation::release_shear_of_contacts() {
  bool released = false;
  for (std::size_t i = 0; i < contacts_.elements.size(); ++i)
    released = release_shear(contacts_.elements[i], contacts_.strengths[i], contacts_.states[i]) || released;
  if (!released) return;
  audit_.geometry_followed(stored_energy_now());
  sum_internal_forces(internal_old_);
}

bool Simulation::contacts_are_in_range() {
  message_ = contact_range_.problem(model_, state_, contacts_);
  return message_.empty();
}

Status Simulation::advance(double dt, int reductions_left) {
  const Status status = try_step(dt);
  if (status != Status::not_converged || reductions_left == 0) return status;
  const Status first_half = advance(dt / 2, reductions_left - 1);
  return first_half == Status::ok ? advance(dt / 2, reductions_left - 1) : first_half;
}

Status Simulation::try_step(double dt) {
  if (dt != coefficients_.dt) set_step_size(dt);
  if (plan_.linear) return linear_step();
  prepare_step();
  Status status = find_contact_statuses();
  if (status == Status::ok && moving_ && moves_too_far()) status = Status::not_converged;
  if (status == Status::ok) {
    accept_step();
  } else {
    matrix_is_current_ = false;
  }
  return status;
}

void Simulation::prepare_step() {
  if (plan_.finite_kinematics) follow_geometry();
  if (plan_.loads) loads_at(state_.time + coefficients_.dt, load_new_);
  form_constant_rhs();
  held_.aim(model_, state_, state_.time + coefficients_.dt);
}

// The block that moves most in the step solved last, in sizes of that block.
Simulation::Motion Simulation::largest_motion() const {
  Motion largest;
  for (std::size_t i = 0; i < terms_.area.size(); ++i) {
    const auto own = increment_.segment<6>(static_cast<Eigen::Index>(6 * i));
    const double motion = own.head<2>().norm() / std::sqrt(terms_.area[i]) + own.tail<4>().cwiseAbs().maxCoeff();
    if (motion > largest.share) largest = {i, motion};
  }
  return largest;
}

bool Simulation::moves_too_far() {
  const Motion motion = largest_motion();
  if (motion.share <= ContactSearch::reach / 2) return false;
  message_ = fmt::format(
      "block \"{}\" would move by {:.2g} of its size in a step of {:.3g} s, and contacts could be missed beyond {:g}: "
      "take a "
      "smaller dt",
      model_.blocks[motion.block].name, motion.share, coefficients_.dt, ContactSearch::reach / 2);
  return true;
}

void Simulation::follow_contacts() {
  if (!moving_) {
    update_geometry(model_, state_, contacts_);
    return;
  }
  ++counters_.contact_searches;
  if (moving_->follow(model_, state_, contacts_)) {
    matrix_ = make_moving_matrix();
    solver_->analyze(matrix_);
    ++counters_.analyses;
  }
}

void Simulation::follow_geometry() {
  if (moved_ <= geometry_tolerance) return;
  const PhaseTimer timer(phase_times_.geometry);
  moved_ = 0;
  turn_stresses(terms_, state_, turned_);
  update_geometry(model_, state_, terms_);
  follow_contacts();
  update_geometry(model_, state_, supports_);
  for (std::size_t i = 0; i < supports_.size(); ++i) measure_gap(model_, state_, i, supports_[i]);
  bolts_.update_geometry(model_, state_);
  if (plan_.viscous_edges) update_geometry(model_, state_, stage_, damping_);
  if (plan_.loads) {
    external_.update_geometry(model_, state_);
    if (free_field_) free_field_->update_geometry(model_, state_, stage_);
    loads_at(state_.time, load_old_);
  }
  refresh_tractions(state_, contacts_);
  sum_internal_forces(internal_old_);
  audit_.geometry_followed(stored_energy_now());
  matrix_is_current_ = false;
}

void Simulation::sum_internal_forces(Eigen::VectorXd& force) const {
  for (std::size_t i = 0; i < state_.stress.size(); ++i) {
    auto own = force.segment<6>(static_cast<Eigen::Index>(6 * i));
    own.head<3>().setZero();
    own.tail<3>() = stress_force(terms_.area[i], state_.stress[i]);
  }
  add_contact_force(contacts_, force);
  for (const ChainEnd& end : contacts_.chain_ends)
    force.segment<6>(6 * end.block) += end_force(model_, end, state_.stress[static_cast<std::size_t>(end.block)]);
  add_support_force(supports_, force);
  bolts_.add_force(force);
}

void Simulation::form_constant_rhs() {
  const StepCoefficients& c = coefficients_;
  constant_rhs_ = -internal_old_;
  if (plan_.loads) constant_rhs_ += c.load_new * load_new_ + c.load_old * load_old_;
  if (plan_.gravity) constant_rhs_ += external_.weight();
  for (std::size_t i = 0; i < state_.velocity.size(); ++i)
    constant_rhs_.segment<6>(static_cast<Eigen::Index>(6 * i)) +=
        momentum(terms_.inertia[i], c.mass_v * state_.velocity[i] + c.mass_a * state_.acceleration[i]);
  add_dashpot_and_support_rhs();
}

void Simulation::accept_step() {
  const double work = inertia_work(coefficients_, terms_, state_, increment_);
  audit_.dashpots_worked(coefficients_, damping_, state_, increment_);
  advance_blocks(coefficients_, terms_, increment_, state_);
  if (plan_.finite_kinematics) moved_ += largest_motion().share;
  state_.time += coefficients_.dt;
  accept_contacts();
  if (plan_.contacts_can_change) note_penetrations(contacts_, terms_, state_.time, deepest_);
  bolts_.accept(audit_);
  accept_supports();
  sum_internal_forces(internal_new_);
  audit_.record(coefficients_, work, stored_energy_now(),
                {load_old_, load_new_, external_.weight(), internal_old_, internal_new_}, increment_);
  deform_blocks(stage().kinematics, increment_, state_);
  audit_held_blocks();
  damp_velocities();
  set_held_rates();
  internal_old_.swap(internal_new_);
  load_old_.swap(load_new_);
  ++counters_.steps;
}

void Simulation::damp_velocities() {
  if (!plan_.velocity_damping && !plan_.is_static) return;
  const double factor =
      plan_.is_static ? 0 : velocity_factor(stage().velocity_factor, stage().damping_rate, coefficients_.dt);
  for (Vec6& velocity : state_.velocity) velocity *= factor;
  if (plan_.is_static) {
    for (Vec6& acceleration : state_.acceleration) acceleration.setZero();
    inertia_force_.setZero();
  }
  if (plan_.linear) momentum_ *= factor;
  audit_.velocities_damped(factor);
}

// Acceleration from the forces at the start of a stage, without those that constrain: each block on its own.
void Simulation::set_initial_acceleration() {
  if (plan_.is_static) return;
  Eigen::VectorXd unbalanced = load_old_ - internal_old_;
  if (plan_.gravity) unbalanced += external_.weight();
  for (const auto& [block, matrix] : damping_)
    unbalanced.segment<6>(6 * block) -= matrix * state_.velocity[static_cast<std::size_t>(block)];
  for (std::size_t i = 0; i < state_.acceleration.size(); ++i) {
    if (terms_.inertia[i].mass == 0) continue;  // held
    state_.acceleration[i] =
        mass_matrix(terms_.inertia[i]).llt().solve(unbalanced.segment<6>(static_cast<Eigen::Index>(6 * i)));
  }
}

Counters Simulation::counters() const {
  Counters counters = counters_;
  counters.solver_iterations += solver_->counts().iterations;
  return counters;
}

double Simulation::out_of_balance() const {
  Eigen::VectorXd unbalanced = load_old_ - internal_old_;
  double scale = std::max(in_situ_force_, load_old_.cwiseAbs().maxCoeff());
  if (plan_.gravity) {
    unbalanced += external_.weight();
    scale = std::max(scale, external_.weight().cwiseAbs().maxCoeff());
  }
  held_.clear(unbalanced);
  return scale > 0 ? unbalanced.cwiseAbs().maxCoeff() / scale : unbalanced.cwiseAbs().maxCoeff();
}

}  // namespace dda
