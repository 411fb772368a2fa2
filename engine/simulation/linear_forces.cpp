#include "engine/simulation/linear_forces.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "engine/contact/contact_set.h"
#include "engine/linear/block_vectors.h"
#include "engine/simulation/damped_start.h"
#include "engine/simulation/held_blocks.h"
#include "engine/simulation/linear_states.h"
#include "engine/simulation/prescribed_motion.h"
#include "engine/simulation/step.h"

namespace dda {
namespace {

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

// What the columns do at once, and so their sides', is not known before they step; model and columns leave it to the
// steps.
bool stands_beside_free_field(const BlockSystem& s) {
  return s.free_field ||
         std::ranges::any_of(s.model.supports, [](const PointSupport& each) { return each.partner.has_value(); });
}

// The stage that begins goes on without what softened jumps in the one before.
bool softening_ends(const BlockSystem& s) {
  const std::size_t stage = s.clock.stage;
  return stage > 0 && jumps_are_softened(s, stage - 1) && !jumps_are_softened(s, stage);
}

}  // namespace

void LinearForces::set_up() {
  BlockSystem& s = system;
  const Stage& stage = s.stage_in_force();
  s.waves = WaveCorrections(s.model, stage, s.contacts);
  operators.emplace(s.model, s.terms, s.contacts, s.supports, s.waves, s.reinforcement.linings);
  rayleigh.begin(stage);
  if (s.plan.loads) s.external.filter(s.waves);
  scratch_.setZero(6 * operators->inertia.size());
  if (s.plan.gravity) set_consistent_weight();
}

void LinearForces::begin() {
  BlockSystem& s = system;
  const bool corrections_end = softening_ends(s);
  // The softening of jumps between strains exerts forces between blocks at rest too. A stage without it would keep
  // those it finds for good, and its balance would be another than that of the same loads from the start (ADR 24).
  if (corrections_end) sum_forces_of_states(s);
  if (s.plan.loads) s.loads_at(s.state.time, s.forces.load_old);
  for (Eigen::VectorXd* vector : {&momentum, &inertia_force, &elastic_force, &internal_at_rest})
    vector->setZero(scratch_.size());
  operators->stiffness.multiply(flat(s.state.displacement), elastic_force);
  internal_at_rest = s.forces.internal_old - elastic_force;
  operators->inertia.multiply(flat(s.state.velocity), momentum);
  // Contact energy of the first moment, interface by interface; later ones follow from the elastic energy of the whole,
  // and those of later stages go on from the ledger, unless what it counts ends with the corrections. Whatever
  // takes these away works, as what changes moduli does: it is no damping of the stage that begins.
  const double contact_before = s.audit.ledger().contact;
  const double contact = s.clock.stage == 0 || corrections_end ? contact_energy() : contact_before;
  energy_offset =
      contact + s.reinforcement.linings.stored_energy() + strain_energy(s.terms, s.state) - elastic_energy();
  if (s.clock.stage > 0) {
    const StoredEnergy stored = stored_energy();
    s.audit.kinetic_counted_as(stored.kinetic);  // corrections and strain inertia may be others than before
    if (corrections_end) s.audit.rock_changed(0, 0, stored.contact - contact_before);
    s.audit.geometry_followed(stored);
  }
  if (s.plan.is_static) return;
  set_held_rates(s.model, s.state);  // dampers act on them from the first moment on
  inertia_force = accelerating_forces(s);
  if (rayleigh.acts()) {
    rayleigh.force_of(*operators, flat(s.state.velocity), momentum, scratch_);
    inertia_force -= scratch_;
    if (s.plan.moving_supports) rayleigh.add_drive(s, s.state.time, inertia_force);
  }
  s.held.clear(inertia_force);
  if (inertia_force.isZero(0)) return;
  if (rayleigh.acts() && !stands_beside_free_field(s)) make_jumps();
  const Eigen::VectorXd acceleration = initial_acceleration();
  unflatten(acceleration, s.state.acceleration);
  operators->inertia.multiply(acceleration, inertia_force);
}

MotionAtStart LinearForces::motion() const {
  return {flat(system.state.velocity), flat(system.state.acceleration), momentum, inertia_force};
}

// What dampers do sooner than a step can follow, see damped_start.h.
void LinearForces::make_jumps() {
  BlockSystem& s = system;
  const auto [change, brought] = change_at_once(s, *operators, rayleigh, s.coefficients.dt, inertia_force);
  if (change.size() == 0) return;
  Eigen::VectorXd force(scratch_.size());
  operators->inertia.multiply(change, scratch_);
  s.audit.velocities_jumped(brought, dot(change, momentum) + dot(change, scratch_) / 2);
  rayleigh.force_of(*operators, change, scratch_, force);
  momentum += scratch_;
  inertia_force -= force;
  for (std::size_t i = 0; i < s.state.velocity.size(); ++i)
    s.state.velocity[i] += change.segment<6>(static_cast<Eigen::Index>(6 * i));
  for (const auto& [block, matrix] : s.damping)
    inertia_force.segment<6>(6 * block) -= matrix * change.segment<6>(6 * block);
  s.held.clear(inertia_force);
}

// Weight acts on the displacements between centroids as inertia does: M times the acceleration of free fall.
void LinearForces::set_consistent_weight() {
  Eigen::VectorXd fall = Eigen::VectorXd::Zero(scratch_.size());
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(scratch_.size());
  for (Eigen::Index block = 0; 6 * block < fall.size(); ++block) fall.segment<2>(6 * block) = system.model.gravity;
  operators->inertia.multiply(fall, weight);
  system.external.set_weight(weight);
}

// Returns how the unbalanced forces in inertia_force accelerate blocks. Strains without inertia take theirs with the
// inertia they would have: the first step puts them in equilibrium.
Eigen::VectorXd LinearForces::initial_acceleration() const {
  const BlockSystem& s = system;
  BlockMatrix inertia = s.waves.leave_strains_without_inertia()
                            ? make_inertia(s.model, s.terms, s.contacts, s.waves.with_all_inertia())
                            : operators->inertia.matrix();
  HeldCouplings().take_out(s.held, inertia);
  return acceleration_of(inertia, inertia_force);
}

void LinearForces::sum_internal_forces(Eigen::VectorXd& force) {
  const BlockSystem& s = system;
  operators->stiffness.multiply(flat(s.state.displacement), elastic_force);
  in_stretches(force.size(),
               [&](const VectorStretch& here) { here.of(force) = here.of(elastic_force) + here.of(internal_at_rest); });
  if (!s.plan.moving_supports) return;
  for (std::size_t i = 0; i < s.supports.size(); ++i) {
    const SupportElement& support = s.supports[i];
    const Vec2 moved = support.prescribed - prescribed_displacement(s.model.supports[i], s.clock.start);
    force.segment<6>(6 * support.block) -= support.rows.transpose() * (support.stiffness * moved);
  }
}

double LinearForces::elastic_energy() const {
  const auto displacement = flat(system.state.displacement);
  return elastic_energy(dot(displacement, elastic_force) / 2 + dot(displacement, internal_at_rest));
}

double LinearForces::elastic_energy(double of_displacements) const {
  const BlockSystem& s = system;
  double energy = of_displacements;
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

StoredEnergy LinearForces::stored_energy() const {
  return stored_energy(dot(flat(system.state.velocity), momentum) / 2, strain_energy(system.terms, system.state),
                       elastic_energy());
}

StoredEnergy LinearForces::stored_energy(double kinetic, double strain, double elastic) const {
  const double linings = system.reinforcement.linings.stored_energy();
  return {kinetic, strain, elastic + energy_offset - strain - linings, 0, linings};
}

double LinearForces::contact_energy() const {
  const BlockSystem& s = system;
  double contact = support_energy(s.supports);
  for (std::size_t i = 0; i < s.contacts.elements.size(); ++i)
    contact += interface_energy(s.contacts.elements.but_for_blocks(i), linear_interface_state(s, i));
  return contact + s.waves.end_energy(s.model, s.state.stress);
}

}  // namespace dda
