#include "engine/simulation/linear_step.h"

#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/core/phase_clock.h"
#include "engine/linear/block_vectors.h"
#include "engine/simulation/held_blocks.h"
#include "engine/simulation/prescribed_motion.h"

namespace dda {
namespace {

// Per-block arrays as one vector of 6 entries a block.
Eigen::Map<const Eigen::VectorXd> flat(const std::vector<Vec6>& per_block) {
  return {per_block.front().data(), static_cast<Eigen::Index>(6 * per_block.size())};
}

void unflatten(const Eigen::VectorXd& from, std::vector<Vec6>& per_block) {
  for (std::size_t i = 0; i < per_block.size(); ++i) per_block[i] = from.segment<6>(static_cast<Eigen::Index>(6 * i));
}

// Solves M a = force once, at the start of a stage. In meshes M couples neighbours, and its factor would fill in as
// that of K does; conjugate gradients take a few iterations however many blocks there are.
Eigen::VectorXd acceleration_of(const BlockMatrix& inertia, const Eigen::VectorXd& force) {
  Eigen::VectorXd acceleration = Eigen::VectorXd::Zero(force.size());
  const std::unique_ptr<LinearSolver> solver = make_solver(choose_solver({inertia.size(), inertia.couplings()}));
  solver->analyze(inertia);
  if (solver->factorize(inertia) == Status::ok && solver->solve(force, acceleration) == Status::ok) return acceleration;
  return Eigen::VectorXd::Constant(force.size(), std::numeric_limits<double>::quiet_NaN());
}

bool jumps_are_softened(const BlockSystem& s, std::size_t stage) {
  return s.model.with_acting_corrections(s.model.stages[stage]).correct_block_dispersion;
}

// The stage that begins goes on without what softened jumps in the one before.
bool softening_ends(const BlockSystem& s) {
  const std::size_t stage = s.clock.stage;
  return stage > 0 && jumps_are_softened(s, stage - 1) && !jumps_are_softened(s, stage);
}

}  // namespace

void LinearStep::set_up(BlockMatrix pattern) {
  BlockSystem& s = system_;
  const Stage& stage = s.stage_in_force();
  const Eigen::Index unknowns = pattern.unknowns();
  matrix_.begin(std::move(pattern), s.plan.solver, s.plan.chi, MatrixUse::stays);
  set_step_size(stage.dt);
  s.waves = WaveCorrections(s.model, stage, s.contacts);
  operators_.emplace(s.model, s.terms, s.contacts, s.supports, s.waves);
  rayleigh_.begin(stage);
  if (s.plan.loads) s.external.filter(s.waves);
  for (Eigen::VectorXd* vector : {&next_momentum_, &rhs_}) vector->setZero(unknowns);
  if (s.plan.gravity) set_consistent_weight();
}

void LinearStep::set_step_size(double dt) {
  system_.coefficients = step_coefficients(system_.stage_in_force().integrator, dt);
  matrix_.outdate();
}

void LinearStep::begin() {
  BlockSystem& s = system_;
  const bool corrections_end = softening_ends(s);
  if (corrections_end) sum_forces_of_states();
  if (s.plan.loads) s.loads_at(s.state.time, s.forces.load_old);
  for (Eigen::VectorXd* vector : {&momentum_, &inertia_force_, &elastic_force_, &internal_at_rest_})
    vector->setZero(rhs_.size());
  operators_->stiffness_times.multiply(flat(s.state.displacement), elastic_force_);
  internal_at_rest_ = s.forces.internal_old - elastic_force_;
  operators_->inertia_times.multiply(flat(s.state.velocity), momentum_);
  // Contact energy of the first moment, interface by interface; later ones follow from the elastic energy of the whole,
  // and those of later stages go on from the ledger, unless what it counts ends with the corrections.
  const double contact = s.clock.stage == 0 || corrections_end ? contact_energy() : s.audit.ledger().contact;
  energy_offset_ = contact + strain_energy(s.terms, s.state) - elastic_energy();
  if (s.clock.stage > 0) s.audit.geometry_followed(stored_energy());  // inertia may be another than before
  if (s.plan.is_static) return;
  set_held_rates(s.model, s.state);  // dampers act on them from the first moment on
  inertia_force_ = accelerating_forces(s);
  if (rayleigh_.acts()) {
    rayleigh_.force_of(*operators_, flat(s.state.velocity), momentum_, next_momentum_);
    inertia_force_ -= next_momentum_;
    if (s.plan.moving_supports) rayleigh_.add_drive(s, s.state.time, inertia_force_);
  }
  s.held.clear(inertia_force_);
  if (inertia_force_.isZero(0)) return;
  const Eigen::VectorXd acceleration = initial_acceleration();
  unflatten(acceleration, s.state.acceleration);
  operators_->inertia_times.multiply(acceleration, inertia_force_);
}

// Weight acts on the displacements between centroids as inertia does: M times the acceleration of free fall.
void LinearStep::set_consistent_weight() {
  Eigen::VectorXd fall = Eigen::VectorXd::Zero(rhs_.size());
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(rhs_.size());
  for (Eigen::Index block = 0; 6 * block < fall.size(); ++block) fall.segment<2>(6 * block) = system_.model.gravity;
  operators_->inertia_times.multiply(fall, weight);
  system_.external.set_weight(weight);
}

// Of the unbalanced forces in inertia_force_. Strains without inertia take theirs with the inertia they would have: the
// first step puts them in equilibrium.
Eigen::VectorXd LinearStep::initial_acceleration() const {
  const BlockSystem& s = system_;
  BlockMatrix inertia = s.waves.leave_strains_without_inertia()
                            ? make_inertia(s.model, s.terms, s.contacts, s.waves.with_all_inertia())
                            : operators_->inertia;
  HeldCouplings().take_out(s.held, inertia);
  return acceleration_of(inertia, inertia_force_);
}

void LinearStep::take_over() {
  const State& state = system_.state;
  ContactSet& contacts = system_.contacts;
  for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
    const InterfaceElement& element = contacts.elements[i];
    contacts.states[i].gap -= element.rows_a * state.displacement[static_cast<std::size_t>(element.block_a)] +
                              element.rows_b * state.displacement[static_cast<std::size_t>(element.block_b)];
  }
}

void LinearStep::write_states() {
  std::vector<InterfaceState>& states = system_.contacts.states;
  for (std::size_t i = 0; i < states.size(); ++i) states[i] = interface_state(i);
}

// The softening of jumps between strains exerts forces between blocks at rest too. A stage without it would keep those
// it finds for good, and its balance would be another than that of the same loads from the start (ADR 24).
void LinearStep::sum_forces_of_states() {
  BlockSystem& s = system_;
  const std::vector<InterfaceState> at_rest = s.contacts.states;
  write_states();
  s.sum_internal_forces(s.forces.internal_old);
  s.contacts.states = at_rest;
}

void LinearStep::hand_over() {
  write_states();
  operators_.reset();
  matrix_.end();
}

Status LinearStep::advance(double dt, bool /*can_be_cut*/) {
  BlockSystem& s = system_;
  if (dt != s.coefficients.dt) set_step_size(dt);
  const double end = s.end_of_step(dt);
  if (s.plan.loads) s.loads_at(end, s.forces.load_new);
  form_rhs();
  aim(s.model, s.state, end, s.held);
  const Status status = solve();
  if (status == Status::ok) {
    accept();
  } else {
    message_ = sentence(matrix_.failure());
  }
  return status;
}

void LinearStep::form_rhs() {
  const PhaseScope scope(Phase::right_hand_side);
  const StepCoefficients& c = system_.coefficients;
  const BlockForces& forces = system_.forces;
  in_stretches(rhs_.size(), [&](const Stretch& here) {
    here.of(rhs_) = c.mass_v * here.of(momentum_) - here.of(forces.internal_old);
    if (c.mass_a != 0) here.of(rhs_) += c.mass_a * here.of(inertia_force_);
    if (system_.plan.loads)
      here.of(rhs_) += c.load_new * here.of(forces.load_new) + c.load_old * here.of(forces.load_old);
    if (system_.plan.gravity) here.of(rhs_) += here.of(system_.external.weight());
  });
  add_dashpot_and_support_rhs(system_, rhs_);
  if (!rayleigh_.acts()) return;
  const State& state = system_.state;
  rayleigh_.take_off_known(*operators_, c, {flat(state.velocity), flat(state.acceleration), momentum_, inertia_force_},
                           rhs_);
  if (system_.plan.moving_supports) rayleigh_.add_drive_in_step(system_, rhs_);
}

Status LinearStep::solve() {
  const BlockSystem& s = system_;
  if (!matrix_.is_current()) {
    matrix_.assemble(s.held, [&](BlockMatrix& values) {
      assemble(rayleigh_.in_matrix(s.coefficients), *operators_, s.damping, values);
    });
    const Status status = matrix_.factorize();
    if (status != Status::ok) return status;
  }
  if (s.plan.solver == SolverKind::pcg) foresee_increment();
  return matrix_.solve(s.held, rhs_, system_.increment);
}

// Where the iteration starts: as if the acceleration stayed as it is.
void LinearStep::foresee_increment() {
  const BlockSystem& s = system_;
  const double dt = s.coefficients.dt;
  in_stretches(system_.increment.size(), [&](const Stretch& here) {
    here.of(system_.increment) =
        dt * here.of(flat(s.state.velocity)) + dt * dt / 2 * here.of(flat(s.state.acceleration));
  });
}

void LinearStep::accept() {
  const PhaseScope scope(Phase::acceptance);
  BlockSystem& s = system_;
  if (rayleigh_.acts()) book_damping();
  move_blocks(Kinematics::small, s);
  if (s.plan.supports) accept_supports(s);
  sum_internal_forces(s.forces.internal_new);
  const double work = follow_inertia_force();
  const double factor = finish_step(work, stored_energy(), s);
  if (factor != 1) momentum_ *= factor;
  if (s.plan.is_static) inertia_force_.setZero();
}

// What dampers take of all motion, and what held blocks and feet of supports bring in of it.
void LinearStep::book_damping() {
  BlockSystem& s = system_;
  const Eigen::VectorXd& force = rayleigh_.force_in_step(*operators_, s.coefficients, s.increment);
  const double on_feet = s.plan.moving_supports ? rayleigh_.work_on_feet(s) : 0;
  s.audit.damping_worked(dot(s.increment, force) - on_feet);
  s.audit.held_blocks_moved_against(s.held.work(force) - on_feet);
}

// M a1 from the change of M v, as a1 follows from that of v. Returns the work against it, see energy_audit.h.
double LinearStep::follow_inertia_force() {
  const StepCoefficients& c = system_.coefficients;
  operators_->inertia_times.multiply(flat(system_.state.velocity), next_momentum_);
  double work = (1 - c.weight_new_a) * dot(system_.increment, inertia_force_);
  in_stretches(inertia_force_.size(), [&](const Stretch& here) {
    here.of(inertia_force_) =
        (here.of(next_momentum_) - here.of(momentum_) - c.v_a0 * here.of(inertia_force_)) / c.v_a1;
  });
  work += c.weight_new_a * dot(system_.increment, inertia_force_);
  momentum_.swap(next_momentum_);
  return work;
}

// Internal forces at the current displacements; those of supports that move follow their prescribed places.
void LinearStep::sum_internal_forces(Eigen::VectorXd& force) {
  const BlockSystem& s = system_;
  operators_->stiffness_times.multiply(flat(s.state.displacement), elastic_force_);
  in_stretches(force.size(),
               [&](const Stretch& here) { here.of(force) = here.of(elastic_force_) + here.of(internal_at_rest_); });
  if (!s.plan.moving_supports) return;
  for (std::size_t i = 0; i < s.supports.size(); ++i) {
    const SupportElement& support = s.supports[i];
    const Vec2 moved = support.prescribed - prescribed_displacement(s.model.supports[i], s.clock.start);
    force.segment<6>(6 * support.block) -= support.rows.transpose() * (support.stiffness * moved);
  }
}

// Elastic energy of blocks, interfaces and supports above that of zero displacement.
double LinearStep::elastic_energy() const {
  const BlockSystem& s = system_;
  const auto displacement = flat(s.state.displacement);
  double energy = dot(displacement, elastic_force_) / 2 + dot(displacement, internal_at_rest_);
  if (!s.plan.moving_supports) return energy;
  for (std::size_t i = 0; i < s.supports.size(); ++i) {
    const SupportElement& support = s.supports[i];
    const Vec2 moved = support.prescribed - prescribed_displacement(s.model.supports[i], s.clock.start);
    const Vec2 gap_without_motion = support.gap + moved;
    energy += (support.gap.dot(support.stiffness * support.gap) -
               gap_without_motion.dot(support.stiffness * gap_without_motion)) /
              2;
  }
  return energy;
}

// Blocks' strain energy from their stresses; what interfaces and supports store is the rest of the elastic energy.
StoredEnergy LinearStep::stored_energy() const {
  const double strain = strain_energy(system_.terms, system_.state);
  return {dot(flat(system_.state.velocity), momentum_) / 2, strain, elastic_energy() + energy_offset_ - strain};
}

double LinearStep::contact_energy() const {
  const BlockSystem& s = system_;
  double contact = support_energy(s.supports);
  for (std::size_t i = 0; i < s.contacts.elements.size(); ++i)
    contact += interface_energy(s.contacts.elements[i], interface_state(i));
  return contact + s.waves.end_energy(s.model, s.state.stress);
}

InterfaceState LinearStep::interface_state(std::size_t index) const {
  const BlockSystem& s = system_;
  const InterfaceElement& element = s.contacts.elements[index];
  const auto a = static_cast<std::size_t>(element.block_a);
  const auto b = static_cast<std::size_t>(element.block_b);
  return linear_state(element, s.contacts.states[index].gap, s.state.displacement[a], s.state.displacement[b],
                      s.state.stress[a], s.state.stress[b]);
}

}  // namespace dda
