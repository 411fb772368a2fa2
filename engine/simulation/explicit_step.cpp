#include "engine/simulation/explicit_step.h"

#include <array>
#include <cmath>

#include "engine/core/phase_clock.h"
#include "engine/linear/block_vectors.h"
#include "engine/simulation/held_blocks.h"
#include "engine/simulation/kinematic_update.h"
#include "engine/simulation/prescribed_motion.h"
#include "engine/terms/elasticity.h"
#include "engine/terms/velocity_damping.h"

namespace dda {
namespace {

Eigen::Index at(std::size_t block) { return static_cast<Eigen::Index>(6 * block); }

auto of(const Eigen::VectorXd& vector, std::size_t block) { return vector.segment<6>(at(block)); }
auto of(Eigen::VectorXd& vector, std::size_t block) { return vector.segment<6>(at(block)); }

// Over fixed pieces, whatever the number of threads: body(block, sums).
template <typename Body>
ExplicitStepSums sum_over_blocks(std::size_t blocks, const Body& body) {
  std::array<ExplicitStepSums, most_sum_pieces> of_pieces;
  for_each_piece(sum_pieces(blocks, blocks_worth_sharing), [&](std::size_t piece, std::size_t first, std::size_t last) {
    ExplicitStepSums sums;
    for (std::size_t i = first; i < last; ++i) body(i, sums);
    of_pieces[piece] = sums;
  });
  ExplicitStepSums whole;
  for (const ExplicitStepSums& sums : of_pieces) whole += sums;
  return whole;
}

}  // namespace

ExplicitStepSums& ExplicitStepSums::operator+=(const ExplicitStepSums& other) {
  twice_kinetic += other.twice_kinetic;
  acceleration += other.acceleration;
  strain += other.strain;
  elastic += other.elastic;
  twice_loads += other.twice_loads;
  weight += other.weight;
  twice_inertia += other.twice_inertia;
  twice_radiated += other.twice_radiated;
  twice_damping += other.twice_damping;
  return *this;
}

void ExplicitStep::set_up(BlockMatrix pattern) {
  BlockSystem& s = system_;
  const Stage& stage = s.stage_in_force();
  const Eigen::Index unknowns = pattern.unknowns();
  pattern = BlockMatrix(0, {});  // no matrix to solve with: its memory is for the operators
  s.coefficients = step_coefficients(stage.integrator, stage.dt);
  linear_.set_up();
  mass_damping_ = stage.material_damping.mass;
  find_dashpots();
  message_.clear();
  next_acceleration_.assign(s.state.acceleration.size(), Vec6::Zero());
  if (solver_.set_up(inertia_in_step(), s.held) != Status::ok) message_ = sentence(Failure::singular_matrix);
  if (solver_.is_by_blocks()) return;
  for (Eigen::VectorXd* vector : {&rhs_, &acceleration_}) vector->setZero(unknowns);
}

BlockMatrix ExplicitStep::inertia_in_step() const {
  const double half = system_.coefficients.dt / 2;
  BlockMatrix inertia = linear_.operators->inertia.matrix(1 + half * mass_damping_);
  for (const Dashpot& each : dashpots_) inertia.diagonal(static_cast<int>(each.block)) += half * each.matrix;
  return inertia;
}

void ExplicitStep::find_dashpots() {
  dashpots_.clear();
  place_.clear();
  for (const auto& [block, matrix] : system_.damping) {
    if (matrix.isZero(0) || system_.held.holds(block)) continue;
    const auto i = static_cast<std::size_t>(block);
    place_.resize(system_.terms.inertia.size(), -1);
    place_[i] = static_cast<int>(dashpots_.size());
    dashpots_.push_back({i, matrix});
  }
}

void ExplicitStep::begin() {
  BlockSystem& s = system_;
  linear_.begin();
  dashpot_force_.resize(static_cast<Eigen::Index>(6 * dashpots_.size()));
  for (std::size_t k = 0; k < dashpots_.size(); ++k)
    of(dashpot_force_, k) = dashpots_[k].matrix * s.state.velocity[dashpots_[k].block];
  mass_damping_force_.resize(0);
  if (mass_damping_ != 0) mass_damping_force_ = mass_damping_ * linear_.momentum;
  if (s.clock.stage > 0) s.audit.kinetic_counted_as(stored_energy().kinetic);
}

// Momenta of blocks on their own are not followed from step to step.
void ExplicitStep::end() {
  if (solver_.is_by_blocks()) linear_.operators->inertia.multiply(flat(system_.state.velocity), linear_.momentum);
  system_.audit.kinetic_counted_as(linear_.stored_energy().kinetic);
}

void ExplicitStep::hand_over() {
  write_linear_states(system_);
  linear_.end();
  solver_ = {};
}

StoredEnergy ExplicitStep::stored_energy() const {
  StoredEnergy stored = linear_.stored_energy();
  const double half = system_.coefficients.dt / 2;
  stored.kinetic -= half * half * dot(flat(system_.state.acceleration), linear_.inertia_force) / 2;
  return stored;
}

Status ExplicitStep::advance(double dt, Taken /*taken*/) {
  if (!message_.empty()) return Status::singular;
  BlockSystem& s = system_;
  const double start = s.state.time;
  const double end = s.end_of_step(dt);
  if (s.plan.loads) s.loads_at(end, s.forces.load_new);
  aim(s.model, s.state, LoadTime::at(end), s.held);
  remember();
  move();
  s.state.time = end;
  if (s.plan.supports) accept_supports(s);
  linear_.sum_internal_forces(s.forces.internal_new);
  if (!solver_.is_by_blocks()) {
    const Status status = solve_coupled();
    if (status != Status::ok) return take_back(start, status);
  }
  const ExplicitStepSums sums = balance();
  if (!std::isfinite(sums.acceleration) || !std::isfinite(sums.elastic)) {
    message_ = sentence(Failure::not_finite);
    return take_back(start, Status::not_finite);
  }
  finish(sums);
  return Status::ok;
}

void ExplicitStep::remember() {
  if (system_.plan.supports) before_.supports = system_.supports;
  before_.audit = static_cast<const EnergyAudit&>(system_.audit);
  before_.dashpot_force = dashpot_force_;
  before_.mass_damping_force = mass_damping_force_;
}

// The state of a step that failed is that of its start, but for round-off, and so are supports and the ledger.
Status ExplicitStep::take_back(double time, Status status) {
  BlockSystem& s = system_;
  for (std::size_t i = 0; i < s.state.velocity.size(); ++i) take_back_block(i);
  s.state.time = time;
  if (s.plan.supports) s.supports = before_.supports;
  static_cast<EnergyAudit&>(s.audit) = before_.audit;
  dashpot_force_ = before_.dashpot_force;
  mass_damping_force_ = before_.mass_damping_force;
  set_held_rates(s.model, s.state);
  return status;
}

void ExplicitStep::take_back_block(std::size_t i) {
  State& state = system_.state;
  const double dt = system_.coefficients.dt;
  const Vec6 d = of(system_.increment, i);
  state.velocity[i] = d / dt - dt / 2 * state.acceleration[i];  // d = dt times the velocity of the middle
  state.displacement[i] -= d;
  state.stress[i].noalias() -= system_.terms.elasticity[i] * d.tail<3>();
  deform_small(-d, state.deformation[i]);
}

// To the end of the step in displacements and stresses, and to its middle in velocities.
void ExplicitStep::move() {
  const PhaseScope scope(Phase::acceptance);
  parallel_for_each(system_.state.velocity.size(), blocks_worth_sharing, [this](std::size_t i) { move_block(i); });
}

void ExplicitStep::move_block(std::size_t i) {
  BlockSystem& s = system_;
  State& state = s.state;
  const double dt = s.coefficients.dt;
  state.velocity[i] += dt / 2 * state.acceleration[i];
  Vec6 d = dt * state.velocity[i];
  if (s.held.holds(static_cast<int>(i))) d = s.held.increments[static_cast<std::size_t>(s.held.place[i])];
  of(s.increment, i) = d;
  state.displacement[i] += d;
  state.stress[i].noalias() += s.terms.elasticity[i] * d.tail<3>();
  deform_small(d, state.deformation[i]);
}

// What dampers take at the velocities of the middle of the step.
Vec6 ExplicitStep::dampers_at_half_step(std::size_t i) const {
  const Vec6& velocity = system_.state.velocity[i];
  Vec6 force = Vec6::Zero();
  if (has_dashpot(i)) force += dashpots_[static_cast<std::size_t>(place_[i])].matrix * velocity;
  if (mass_damping_ == 0) return force;
  if (solver_.is_by_blocks()) return force + mass_damping_ * momentum(system_.terms.inertia[i], velocity);
  const double half = system_.coefficients.dt / 2;
  return force + mass_damping_ * (of(linear_.momentum, i) + half * of(linear_.inertia_force, i));
}

Vec6 ExplicitStep::unbalanced_force(std::size_t i) const {
  const BlockSystem& s = system_;
  Vec6 force = -of(s.forces.internal_new, i);
  if (s.plan.loads) force += of(s.forces.load_new, i);
  if (s.plan.gravity) force += of(s.external.weight(), i);
  return force;
}

Status ExplicitStep::solve_coupled() {
  const PhaseScope scope(Phase::solution);
  for (std::size_t i = 0; i < system_.state.velocity.size(); ++i)
    of(rhs_, i) = unbalanced_force(i) - dampers_at_half_step(i);
  system_.held.clear(rhs_);
  const Status status = solver_.solve(rhs_, acceleration_);
  if (status != Status::ok) message_ = sentence(Failure::linear_solver);
  return status;
}

// Accelerations and velocities at the end of the step, and all sums over it.
ExplicitStepSums ExplicitStep::balance() {
  const PhaseScope scope(Phase::solution);
  return sum_over_blocks(system_.state.velocity.size(),
                         [this](std::size_t i, ExplicitStepSums& sums) { balance_block(i, sums); });
}

void ExplicitStep::balance_block(std::size_t i, ExplicitStepSums& sums) {
  BlockSystem& s = system_;
  const Vec6 d = of(s.increment, i);
  add_stored(i, d, sums);
  if (s.held.holds(static_cast<int>(i))) return;
  Vec6 force = unbalanced_force(i);
  Vec6 acceleration;
  if (!solver_.is_by_blocks()) {
    acceleration = of(acceleration_, i);
  } else if (has_dashpot(i) || mass_damping_ != 0) {
    acceleration = solver_.inverse(i) * (force - dampers_at_half_step(i));
  } else {
    acceleration.noalias() = solver_.inverse(i) * force;
  }
  next_acceleration_[i] = acceleration;
  s.state.velocity[i] += s.coefficients.dt / 2 * acceleration;
  if (has_dashpot(i)) take_off_dashpot(i, d, force, sums);
  const Vec6 momentum = take_off_mass_damping(i, d, force, sums);
  sums.twice_kinetic += s.state.velocity[i].dot(momentum);
  sums.acceleration += acceleration.dot(force);
  sums.twice_inertia += d.dot(of(linear_.inertia_force, i) + force);
  of(linear_.inertia_force, i) = force;
}

void ExplicitStep::take_off_dashpot(std::size_t i, const Vec6& d, Vec6& force, ExplicitStepSums& sums) {
  const auto k = static_cast<std::size_t>(place_[i]);
  const Vec6 now = dashpots_[k].matrix * system_.state.velocity[i];
  sums.twice_radiated += d.dot(of(dashpot_force_, k) + now);
  of(dashpot_force_, k) = now;
  force -= now;
}

// Returns the momentum M v at the end of the step. Where inertia couples blocks it goes on by M (a0 + a1) dt/2.
Vec6 ExplicitStep::take_off_mass_damping(std::size_t i, const Vec6& d, Vec6& force, ExplicitStepSums& sums) {
  const double half = system_.coefficients.dt / 2;
  Vec6 momentum;
  if (solver_.is_by_blocks()) {
    momentum = dda::momentum(system_.terms.inertia[i], system_.state.velocity[i]);
  } else {
    momentum = (of(linear_.momentum, i) + half * (of(linear_.inertia_force, i) + force)) / (1 + half * mass_damping_);
    of(linear_.momentum, i) = momentum;
  }
  if (mass_damping_ == 0) return momentum;
  const Vec6 before = of(mass_damping_force_, i);
  const Vec6 now = mass_damping_ * momentum;
  sums.twice_damping += d.dot(before + now);
  of(mass_damping_force_, i) = now;
  force -= now;
  return momentum;
}

// Stored energies, and the work of loads and weight.
void ExplicitStep::add_stored(std::size_t i, const Vec6& d, ExplicitStepSums& sums) const {
  const BlockSystem& s = system_;
  sums.elastic += s.state.displacement[i].dot(of(linear_.elastic_force, i) / 2 + of(linear_.internal_at_rest, i));
  sums.strain += strain_energy(s.terms.area[i], s.state.stress[i], s.terms.compliance[i]);
  if (s.plan.loads) sums.twice_loads += d.dot(of(s.forces.load_old, i) + of(s.forces.load_new, i));
  if (s.plan.gravity) sums.weight += d.dot(of(s.external.weight(), i));
}

void ExplicitStep::finish(const ExplicitStepSums& of_step) {
  const PhaseScope scope(Phase::acceptance);
  BlockSystem& s = system_;
  ExplicitStepSums sums = of_step;
  s.state.acceleration.swap(next_acceleration_);
  s.audit.dampers_worked(sums.twice_radiated / 2, sums.twice_damping / 2);
  if (s.plan.velocity_damping) damp(sums);
  const double half = s.coefficients.dt / 2;
  const double kinetic = (sums.twice_kinetic - half * half * sums.acceleration) / 2;
  const double lost = (of_step.twice_kinetic - sums.twice_kinetic) / 2;
  s.audit.damping_worked(lost, 0);
  s.audit.record({sums.twice_loads / 2, sums.weight, sums.twice_inertia / 2 - lost},
                 linear_.stored_energy(kinetic, sums.strain, linear_.elastic_energy(sums.elastic)));
  audit_held_blocks(s);
  set_held_rates(s.model, s.state);
  s.forces.internal_old.swap(s.forces.internal_new);
  s.forces.load_old.swap(s.forces.load_new);
  ++s.costs.counters.steps;
}

void ExplicitStep::damp(ExplicitStepSums& sums) {
  BlockSystem& s = system_;
  const double factor = velocity_factor(s.stage().velocity_factor, s.stage().damping_rate, s.coefficients.dt);
  for (Vec6& velocity : s.state.velocity) velocity *= factor;
  if (!solver_.is_by_blocks()) linear_.momentum *= factor;
  sums.twice_kinetic *= factor * factor;
}

}  // namespace dda
