// The step of a linear scene: constant stiffness K and inertia M over all unknowns.
#include <cstddef>
#include <limits>
#include <memory>

#include "engine/simulation/kinematic_update.h"
#include "engine/simulation/simulation.h"

namespace dda {
namespace {

// Per-block arrays as one vector of 6 entries a block.
Eigen::Map<const Eigen::VectorXd> flat(const std::vector<Vec6>& per_block) {
  return {per_block.front().data(), static_cast<Eigen::Index>(6 * per_block.size())};
}

void unflatten(const Eigen::VectorXd& from, std::vector<Vec6>& per_block) {
  for (std::size_t i = 0; i < per_block.size(); ++i) per_block[i] = from.segment<6>(static_cast<Eigen::Index>(6 * i));
}

// Solves M a = force once, at the start of a stage.
Eigen::VectorXd acceleration_of(const BlockMatrix& inertia, const Eigen::VectorXd& force) {
  Eigen::VectorXd acceleration = Eigen::VectorXd::Zero(force.size());
  const std::unique_ptr<LinearSolver> solver = make_solver(SolverKind::cholesky);
  solver->analyze(inertia);
  if (solver->factorize(inertia) == Status::ok && solver->solve(force, acceleration) == Status::ok) return acceleration;
  return Eigen::VectorXd::Constant(force.size(), std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

void Simulation::begin_linear_stage() {
  if (!linear_) keep_gaps_at_rest();
  linear_.emplace(make_linear_operators(model_, stage(), terms_, contacts_, supports_));
  if (plan_.loads) {
    external_.sharpen(load_sharpening(model_, stage(), contacts_), stage().dt);
    loads_at(state_.time, load_old_);
  }
  const Eigen::Index unknowns = matrix_.unknowns();
  for (Eigen::VectorXd* vector : {&momentum_, &inertia_force_, &elastic_force_, &internal_at_rest_})
    vector->setZero(unknowns);
  rhs_ = flat(state_.displacement);
  linear_->stiffness_times.multiply(rhs_, elastic_force_);
  internal_at_rest_ = internal_old_ - elastic_force_;
  rhs_ = flat(state_.velocity);
  linear_->inertia_times.multiply(rhs_, momentum_);
  set_energy_offset();
  if (stage_ > 0) audit_.geometry_followed(linear_stored_energy());  // inertia may be another than before
  if (plan_.gravity) set_consistent_weight();
  if (plan_.is_static) return;
  inertia_force_ = load_old_ - internal_old_;
  if (plan_.gravity) inertia_force_ += external_.weight();
  for (const auto& [block, matrix] : damping_)
    inertia_force_.segment<6>(6 * block) -= matrix * state_.velocity[static_cast<std::size_t>(block)];
  held_.clear(inertia_force_);
  if (inertia_force_.isZero(0)) return;
  rhs_ = initial_linear_acceleration();
  unflatten(rhs_, state_.acceleration);
  linear_->inertia_times.multiply(rhs_, inertia_force_);
}

// Weight acts on the displacements between centroids as inertia does: M times the acceleration of free fall.
void Simulation::set_consistent_weight() {
  rhs_.setZero();
  for (int block = 0; block < matrix_.size(); ++block) rhs_.segment<2>(6 * block) = model_.gravity;
  linear_->inertia_times.multiply(rhs_, constant_rhs_);
  external_.set_weight(constant_rhs_);
}

// Of the unbalanced forces in inertia_force_. Strains without inertia take theirs with the inertia they would have: the
// first step puts them in equilibrium.
Eigen::VectorXd Simulation::initial_linear_acceleration() {
  Stage complete = stage();
  complete.lateral_inertia = true;
  BlockMatrix inertia = stage().lateral_inertia
                            ? linear_->inertia
                            : make_linear_operators(model_, complete, terms_, contacts_, supports_).inertia;
  held_.take_out(inertia);
  return acceleration_of(inertia, inertia_force_);
}

// In a linear stage contacts_.states hold the gaps at zero displacement: what finite kinematics before it left.
void Simulation::keep_gaps_at_rest() {
  for (std::size_t i = 0; i < contacts_.elements.size(); ++i) {
    const InterfaceElement& element = contacts_.elements[i];
    contacts_.states[i].gap -= element.rows_a * state_.displacement[static_cast<std::size_t>(element.block_a)] +
                               element.rows_b * state_.displacement[static_cast<std::size_t>(element.block_b)];
  }
}

void Simulation::end_linear_stage() {
  for (std::size_t i = 0; i < contacts_.states.size(); ++i) contacts_.states[i] = interface_state(i);
  linear_.reset();
}

Status Simulation::linear_step() {
  if (plan_.loads) loads_at(state_.time + coefficients_.dt, load_new_);
  form_linear_rhs();
  held_.aim(model_, state_, state_.time + coefficients_.dt);
  Status status = matrix_is_current_ ? Status::ok : refactor();
  if (status == Status::ok) status = solve_for_increment(increment_);
  if (status == Status::ok) accept_linear_step();
  return status;
}

void Simulation::form_linear_rhs() {
  const StepCoefficients& c = coefficients_;
  constant_rhs_ = c.mass_v * momentum_ - internal_old_;
  if (c.mass_a != 0) constant_rhs_ += c.mass_a * inertia_force_;
  if (plan_.loads) constant_rhs_ += c.load_new * load_new_ + c.load_old * load_old_;
  if (plan_.gravity) constant_rhs_ += external_.weight();
  add_dashpot_and_support_rhs();
  rhs_ = constant_rhs_;
}

void Simulation::accept_linear_step() {
  const StepCoefficients& c = coefficients_;
  if (plan_.viscous_edges) audit_.dashpots_worked(c, damping_, state_, increment_);
  advance_blocks(c, terms_, increment_, state_);
  deform_blocks(Kinematics::small, increment_, state_);
  state_.time += c.dt;
  if (plan_.supports) accept_supports();
  linear_internal_forces(internal_new_);
  // M a1 from the change of M v, as a1 follows from that of v.
  rhs_ = flat(state_.velocity);
  linear_->inertia_times.multiply(rhs_, constant_rhs_);
  double work = (1 - c.weight_new_a) * increment_.dot(inertia_force_);
  inertia_force_ = (constant_rhs_ - momentum_ - c.v_a0 * inertia_force_) / c.v_a1;
  work += c.weight_new_a * increment_.dot(inertia_force_);
  momentum_.swap(constant_rhs_);
  audit_.record(c, work, linear_stored_energy(),
                {load_old_, load_new_, external_.weight(), internal_old_, internal_new_}, increment_);
  audit_held_blocks();
  damp_velocities();
  set_held_rates();
  internal_old_.swap(internal_new_);
  load_old_.swap(load_new_);
  ++counters_.steps;
}

// Internal forces at the current displacements; those of supports that move follow their prescribed places.
void Simulation::linear_internal_forces(Eigen::VectorXd& force) {
  rhs_ = flat(state_.displacement);
  linear_->stiffness_times.multiply(rhs_, elastic_force_);
  force = elastic_force_ + internal_at_rest_;
  if (!plan_.moving_supports) return;
  for (std::size_t i = 0; i < supports_.size(); ++i) {
    const SupportElement& support = supports_[i];
    const Vec2 moved = support.prescribed - prescribed_displacement(model_.supports[i], stage_start_);
    force.segment<6>(6 * support.block) -= support.rows.transpose() * (support.stiffness * moved);
  }
}

// Elastic energy of blocks, interfaces and supports above that of zero displacement.
double Simulation::linear_elastic_energy() const {
  const auto displacement = flat(state_.displacement);
  double energy = displacement.dot(elastic_force_) / 2 + displacement.dot(internal_at_rest_);
  if (!plan_.moving_supports) return energy;
  for (std::size_t i = 0; i < supports_.size(); ++i) {
    const SupportElement& support = supports_[i];
    const Vec2 moved = support.prescribed - prescribed_displacement(model_.supports[i], stage_start_);
    const Vec2 gap_without_motion = support.gap + moved;
    energy += (support.gap.dot(support.stiffness * support.gap) -
               gap_without_motion.dot(support.stiffness * gap_without_motion)) /
              2;
  }
  return energy;
}

// Blocks' strain energy from their stresses; what interfaces and supports store is the rest of the elastic energy.
StoredEnergy Simulation::linear_stored_energy() const {
  const double strain = strain_energy(terms_, state_);
  return {flat(state_.velocity).dot(momentum_) / 2, strain, linear_elastic_energy() + energy_offset_ - strain};
}

// Contact energy of the first moment, interface by interface; later ones follow from the elastic energy of the whole,
// and those of later stages go on from the ledger.
void Simulation::set_energy_offset() {
  energy_offset_ = initial_contact_energy() + strain_energy(terms_, state_) - linear_elastic_energy();
}

double Simulation::initial_contact_energy() const {
  if (stage_ > 0) return audit_.ledger().contact;
  double contact = support_energy(supports_);
  for (std::size_t i = 0; i < contacts_.elements.size(); ++i)
    contact += interface_energy(contacts_.elements[i], interface_state(i));
  for (const ChainEnd& end : contacts_.chain_ends)
    contact += end_energy(model_, end, state_.stress[static_cast<std::size_t>(end.block)]);
  return contact;
}

InterfaceState Simulation::interface_state(std::size_t index) const {
  if (!plan_.linear) return contacts_.states[index];
  const InterfaceElement& element = contacts_.elements[index];
  const Vec6& a = state_.displacement[static_cast<std::size_t>(element.block_a)];
  const Vec6& b = state_.displacement[static_cast<std::size_t>(element.block_b)];
  return linear_state(element, contacts_.states[index].gap, a, b,
                      state_.stress[static_cast<std::size_t>(element.block_a)],
                      state_.stress[static_cast<std::size_t>(element.block_b)]);
}

}  // namespace dda
