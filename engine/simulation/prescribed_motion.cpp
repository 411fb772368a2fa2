#include "engine/simulation/prescribed_motion.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "engine/model/moving_stages.h"
#include "engine/simulation/free_field.h"
#include "engine/simulation/held_blocks.h"

namespace dda {
namespace {

// Supports have a part in a step beyond what its matrix makes of them: prescribed motion, or what is foreseen.
bool supports_drive(const StepPlan& plan) { return plan.moving_supports || plan.finite_kinematics; }

// The gap from the unknowns alone, where all kinematics are small. A deformation is 1 and something, of which round-off
// takes 1e-16: on a block of a metre a spring of 1000 E turns that into newtons, which in weak waves is what they
// carry.
void measure_small_gap(const PointSupport& prescription, const State& state, SupportElement& support) {
  support.prescribed = prescribed_displacement(prescription, state.time);
  support.gap =
      support.rows * state.displacement[static_cast<std::size_t>(support.block)] - support.prescribed - support.rest;
}

}  // namespace

void add_dashpot_and_support_rhs(const BlockSystem& system, Eigen::VectorXd& rhs) {
  const StepCoefficients& c = system.coefficients;
  const State& state = system.state;
  for (const auto& [block, matrix] : system.damping) {
    const auto i = static_cast<std::size_t>(block);
    rhs.segment<6>(6 * block) -= matrix * (c.damping_v * state.velocity[i] + c.damping_a * state.acceleration[i]);
  }
  if (!supports_drive(system.plan)) return;
  const LoadTime end = system.load_time_after(c.dt);
  for (std::size_t i = 0; i < system.supports.size(); ++i) {
    const SupportElement& support = system.supports[i];
    const Vec2 motion = prescribed_displacement(system.model.supports[i], end) - support.prescribed - support.foreseen;
    rhs.segment<6>(6 * support.block) += c.stiffness * support.rows.transpose() * (support.stiffness * motion);
  }
}

void accept_supports(BlockSystem& system) {
  const bool small = !has_finite_kinematics(system.model);
  // The state is at the end of the step already.
  const LoadTime end = system.stage_in_force().paces_itself() ? system.load_time_after(system.coefficients.dt)
                                                              : LoadTime::at(system.state.time);
  for (std::size_t i = 0; i < system.supports.size(); ++i) {
    SupportElement& support = system.supports[i];
    const SupportElement before = support;
    const PointSupport& prescription = system.model.supports[i];
    if (system.plan.linear && !prescription.partner) {  // the way between two points would be lost in their own
      if (small)
        measure_small_gap(prescription, system.state, support);
      else
        measure_gap(system.model, system.state, i, support);
    } else {
      advance_gap(prescribed_displacement(prescription, end), system.increment, support);
    }
    if (supports_drive(system.plan)) system.audit.support_moved(before, support);
  }
}

void let_go_of_support(std::size_t index, BlockSystem& system) {
  SupportElement& support = system.supports[index];
  const Vec2 force = -support.stiffness * support.gap;
  const Vec6 on_block = support.rows.transpose() * force;
  system.audit.support_let_go(support_energy(support));
  support.stiffness.setZero();
  system.forces.internal_old.segment<6>(6 * support.block) += on_block;
  if (!leaves_force(system.model.supports[index])) return;
  system.external.keep_reaction(index, support.offset, force);
  system.forces.load_old.segment<6>(6 * support.block) += on_block;
}

void let_go_of_supports(BlockSystem& system) {
  for (std::size_t i = 0; i < system.supports.size(); ++i)
    if (system.model.supports[i].last_stage == static_cast<int>(system.clock.stage)) let_go_of_support(i, system);
}

void begin_viscous_edges(BlockSystem& system) {
  const std::size_t stage = system.clock.stage;
  const Model& model = system.model;
  const auto begins = [&](const ViscousEdge& edge) { return edge.first_stage == static_cast<int>(stage); };
  if (stage == 0 || model.viscous_edges.empty()) return;
  const State geometry = system.geometry_moves() ? system.state : initial_state(model);
  if (std::any_of(model.viscous_edges.begin(), model.viscous_edges.end(), begins))
    update_geometry(model, geometry, stage, system.damping);
  if (system.free_field && system.free_field->begin_stage(model, geometry, stage))
    system.loads_at(system.state.time, system.forces.load_old);
}

void measure_internal_forces(BlockSystem& system) {
  const HeldUnknowns& held = system.held;
  BlockForces& forces = system.forces;
  if (!held.move) return system.sum_internal_forces(forces.internal_old);
  const auto add = [&](double sign) {
    for (std::size_t i = 0; i < held.blocks.size(); ++i)
      forces.measured[i] += sign * forces.internal_old.segment<6>(6 * held.blocks[i]);
  };
  forces.measured.resize(held.blocks.size(), Vec6::Zero());
  add(-1);
  system.sum_internal_forces(forces.internal_old);
  add(1);
}

void audit_held_blocks(BlockSystem& system) {
  const HeldUnknowns& held = system.held;
  BlockForces& forces = system.forces;
  if (held.empty()) return;
  double at_start = held.work(forces.internal_old) - held.work(forces.load_old);
  double at_end = held.work(forces.internal_new) - held.work(forces.load_new);
  if (system.plan.gravity) at_start -= held.work(system.external.weight());
  if (system.plan.gravity) at_end -= held.work(system.external.weight());
  double by_measuring = 0;
  for (std::size_t i = 0; i < std::min(forces.measured.size(), held.increments.size()); ++i)
    by_measuring += held.increments[i].dot(forces.measured[i]);
  forces.measured.clear();
  const double by_jump = forces.kept.jump.size() > 0 ? held.work(forces.kept.jump) : 0;
  system.audit.held_blocks_moved(system.coefficients, at_start, at_end, by_measuring, by_jump);
}

bool nothing_prescribed_changes_until(double time, BlockSystem& system) {
  if (system.plan.loads) {
    if (system.free_field && !system.free_field->stands_still_until(time)) return false;
    system.loads_at(time, system.forces.load_new);
    if (system.forces.load_new != system.forces.load_old) return false;
  }
  for (std::size_t i = 0; system.plan.moving_supports && i < system.supports.size(); ++i)
    if (prescribed_displacement(system.model.supports[i], time) != system.supports[i].prescribed) return false;
  return held_blocks_stand_still_until(system.model, system.state, time);
}

}  // namespace dda
