#include "engine/simulation/held_blocks.h"

#include <cstddef>

#include "engine/geometry/rotation.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

bool moves(const HeldBlock& held) { return !held.amplitude.isZero(0) || held.turn != 0; }

Vec2 quarter_turned(const Vec2& v) { return {-v.y(), v.x()}; }

// Displacement, velocity and acceleration of the unknowns of a held block.
struct Motion {
  Vec6 displacement = Vec6::Zero();
  Vec6 velocity = Vec6::Zero();
  Vec6 acceleration = Vec6::Zero();
};

// The centroid turns about `about`, which moves; its arm is that of the drawing, turned.
void add_turn(const MotionFactors& factors, const HeldBlock& held, const Vec2& drawn_arm, Motion& motion) {
  const double angle = held.turn * factors.displacement;
  const double spin = held.turn * factors.velocity;
  const double spin_up = held.turn * factors.acceleration;
  const Vec2 arm = rotation(angle) * drawn_arm;
  motion.displacement.head<2>() += arm - drawn_arm;
  motion.velocity.head<2>() += spin * quarter_turned(arm);
  motion.acceleration.head<2>() += spin_up * quarter_turned(arm) - spin * spin * arm;
  motion.displacement(2) = angle;
  motion.velocity(2) = spin;
  motion.acceleration(2) = spin_up;
}

Motion motion_of(const Model& model, const HeldBlock& held, double time) {
  Motion motion;
  if (!moves(held)) return motion;
  const MotionFactors factors = motion_at(held.kind, held.history, time);
  motion.displacement.head<2>() = factors.displacement * held.amplitude;
  motion.velocity.head<2>() = factors.velocity * held.amplitude;
  motion.acceleration.head<2>() = factors.acceleration * held.amplitude;
  if (held.turn != 0) add_turn(factors, held, model.blocks[at(held.block)].moments.centroid - held.about, motion);
  return motion;
}

}  // namespace

HeldBlocks::HeldBlocks(const Model& model) : place_(model.held_blocks.empty() ? 0 : model.blocks.size(), -1) {
  for (const HeldBlock& held : model.held_blocks) {
    place_[at(held.block)] = static_cast<int>(blocks_.size());
    blocks_.push_back(held.block);
    increments_.emplace_back(Vec6::Zero());
    move_ = move_ || moves(held);
  }
}

void HeldBlocks::aim(const Model& model, const State& state, double time) {
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    increments_[i] = motion_of(model, model.held_blocks[i], time).displacement - state.displacement[at(blocks_[i])];
    increments_[i].tail<3>().setZero();
  }
}

void HeldBlocks::put(Eigen::VectorXd& d) const {
  for (std::size_t i = 0; i < blocks_.size(); ++i) d.segment<6>(6 * blocks_[i]) = increments_[i];
}

void HeldBlocks::clear(Eigen::VectorXd& force) const {
  for (const int block : blocks_) force.segment<6>(6 * block).setZero();
}

void HeldBlocks::take_out(BlockMatrix& matrix) {
  if (empty()) return;
  couplings_.clear();
  for (int column = 0; column < matrix.size(); ++column) {
    const bool column_is_held = place_[at(column)] >= 0;
    if (column_is_held) matrix.diagonal(column).setIdentity();
    const auto first = at(matrix.column_starts()[at(column)]) + 1;
    const auto last = at(matrix.column_starts()[at(column) + 1]);
    for (std::size_t k = first; k < last; ++k) {
      const int row = matrix.block_rows()[k];
      const bool row_is_held = place_[at(row)] >= 0;
      if (!column_is_held && !row_is_held) continue;
      auto entry = matrix.offdiagonal(static_cast<int>(k));
      if (move_ && !row_is_held) couplings_.push_back({row, column, entry});
      if (move_ && !column_is_held) couplings_.push_back({column, row, entry.transpose()});
      entry.setZero();
    }
  }
}

void HeldBlocks::move_to_right(Eigen::VectorXd& rhs) const {
  for (const Coupling& coupling : couplings_)
    rhs.segment<6>(6 * coupling.block).noalias() -= coupling.stiffness * increments_[at(place_[at(coupling.held)])];
  put(rhs);
}

double HeldBlocks::coupled_work(const Eigen::VectorXd& d, const Eigen::VectorXd& p) const {
  double work = 0;
  for (const Coupling& coupling : couplings_)
    work += p.segment<6>(6 * coupling.block).dot(coupling.stiffness * d.segment<6>(6 * coupling.held));
  return work;
}

bool HeldBlocks::moved_by(const Eigen::VectorXd& p) const {
  for (const int block : blocks_)
    if (!p.segment<6>(6 * block).isZero(0)) return true;
  return false;
}

double HeldBlocks::work(const Eigen::VectorXd& force) const {
  double work = 0;
  for (std::size_t i = 0; i < blocks_.size(); ++i) work += increments_[i].dot(force.segment<6>(6 * blocks_[i]));
  return work;
}

Vec4 HeldBlocks::gap_increment(const InterfaceElement& element) const {
  Vec4 gap = Vec4::Zero();
  const int a = place_[at(element.block_a)];
  const int b = place_[at(element.block_b)];
  if (a >= 0) gap += element.rows_a * increments_[at(a)];
  if (b >= 0) gap += element.rows_b * increments_[at(b)];
  return gap;
}

bool HeldBlocks::stand_still_until(const Model& model, const State& state, double time) const {
  constexpr double round_off = 1e-14;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const Vec6& now = state.displacement[at(blocks_[i])];
    const Vec6 then = motion_of(model, model.held_blocks[i], time).displacement;
    if ((then - now).head<3>().norm() > round_off * now.head<3>().norm()) return false;
  }
  return true;
}

void HeldBlocks::set_rates(const Model& model, State& state) const {
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const Motion motion = motion_of(model, model.held_blocks[i], state.time);
    state.velocity[at(blocks_[i])] = motion.velocity;
    state.acceleration[at(blocks_[i])] = motion.acceleration;
  }
}

}  // namespace dda
