// Supports, dashpots, free-field sides and held blocks in a step of Simulation.
#include <algorithm>
#include <cstddef>

#include "engine/simulation/free_field.h"
#include "engine/simulation/simulation.h"

namespace dda {

void Simulation::add_dashpot_and_support_rhs() {
  const StepCoefficients& c = coefficients_;
  for (const auto& [block, matrix] : damping_) {
    const auto i = static_cast<std::size_t>(block);
    constant_rhs_.segment<6>(6 * block) -=
        matrix * (c.damping_v * state_.velocity[i] + c.damping_a * state_.acceleration[i]);
  }
  if (!plan_.moving_supports) return;
  for (std::size_t i = 0; i < supports_.size(); ++i) {
    const SupportElement& support = supports_[i];
    const Vec2 motion = prescribed_displacement(model_.supports[i], state_.time + c.dt) - support.prescribed;
    constant_rhs_.segment<6>(6 * support.block) +=
        c.stiffness * support.rows.transpose() * (support.stiffness * motion);
  }
}

void Simulation::accept_supports() {
  for (std::size_t i = 0; i < supports_.size(); ++i) {
    const SupportElement before = supports_[i];
    if (plan_.linear && !model_.supports[i].partner) {  // the way between two points would be lost in their own
      measure_gap(model_, state_, i, supports_[i]);
    } else {
      advance_gap(model_.supports[i], increment_, state_.time, supports_[i]);
    }
    if (plan_.moving_supports) audit_.support_moved(before, supports_[i]);
  }
}

// Supports that end with this stage leave their force behind, so that what they held stays at rest, or take it along.
void Simulation::let_go_of_supports() {
  for (std::size_t i = 0; i < supports_.size(); ++i) {
    if (model_.supports[i].last_stage != static_cast<int>(stage_)) continue;
    SupportElement& support = supports_[i];
    const Vec2 force = -support.stiffness * support.gap;
    const Vec6 on_block = support.rows.transpose() * force;
    audit_.support_let_go(support_energy(support));
    support.stiffness.setZero();
    internal_old_.segment<6>(6 * support.block) += on_block;
    if (!leaves_force(model_.supports[i])) continue;
    external_.keep_reaction(i, support.offset, force);
    load_old_.segment<6>(6 * support.block) += on_block;
  }
}

// Dashpots that begin to act with this stage.
void Simulation::begin_viscous_edges() {
  const auto begins = [&](const ViscousEdge& edge) { return edge.first_stage == static_cast<int>(stage_); };
  if (stage_ == 0 || std::none_of(model_.viscous_edges.begin(), model_.viscous_edges.end(), begins)) return;
  const State& geometry = geometry_moves() ? state_ : initial_state(model_);
  update_geometry(model_, geometry, stage_, damping_);
  if (free_field_ && free_field_->begin_stage(model_, geometry, stage_)) loads_at(state_.time, load_old_);
}

const Simulation* Simulation::free_field_columns() const { return free_field_ ? &free_field_->columns() : nullptr; }

// The columns go first: what they do at the end of the step is then known.
Status Simulation::step_free_field() {
  if (!free_field_) return Status::ok;
  const double dt = stage().dt;
  const Status status = free_field_->advance_to(stage_start_ + static_cast<double>(step_in_stage_ + 1) * dt, dt);
  if (status != Status::ok) message_ = "columns of the free field: " + free_field_->message();
  return status;
}

void Simulation::loads_at(double time, Eigen::VectorXd& force) const {
  external_.loads_at(time, force);
  if (free_field_) free_field_->add_loads_at(time, force);
}

// What moves the held blocks works against all other forces on them.
void Simulation::audit_held_blocks() {
  if (held_.empty()) return;
  double at_start = held_.work(internal_old_) - held_.work(load_old_);
  double at_end = held_.work(internal_new_) - held_.work(load_new_);
  if (plan_.gravity) at_start -= held_.work(external_.weight());
  if (plan_.gravity) at_end -= held_.work(external_.weight());
  audit_.held_blocks_moved(coefficients_, at_start, at_end);
}

// What the integrator made of the velocities of held blocks gives way to what is prescribed.
void Simulation::set_held_rates() {
  if (!plan_.is_static) held_.set_rates(model_, state_);
}

}  // namespace dda
