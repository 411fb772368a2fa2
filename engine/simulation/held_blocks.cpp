#include "engine/simulation/held_blocks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "engine/geometry/rotation.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

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

void add_motion(const MotionFactors& factors, const Model& model, const HeldBlock& held, Motion& motion) {
  motion.displacement.head<2>() += factors.displacement * held.amplitude;
  motion.velocity.head<2>() += factors.velocity * held.amplitude;
  motion.acceleration.head<2>() += factors.acceleration * held.amplitude;
  if (held.turn != 0) add_turn(factors, held, model.blocks[at(held.block)].moments.centroid - held.about, motion);
}

Motion motion_of(const Model& model, const HeldMotions& motions, double time) {
  Motion sum;
  for (const HeldBlock& held : motions)
    if (moves(held)) add_motion(motion_at(held.kind, held.history, time), model, held, sum);
  return sum;
}

// A block that turns goes by the angle in between.
Vec6 displacement_of(const Model& model, const HeldMotions& motions, const LoadTime& time) {
  Motion sum;
  for (const HeldBlock& held : motions) {
    if (!moves(held)) continue;
    const auto factor = [&](double then) { return motion_at(held.kind, held.history, then).displacement; };
    add_motion({.displacement = time.of(factor)}, model, held, sum);
  }
  return sum.displacement;
}

}  // namespace

HeldUnknowns make_held_unknowns(const Model& model, const std::vector<bool>& absent) {
  HeldUnknowns unknowns;
  unknowns.place.assign(model.held_blocks.empty() ? 0 : model.blocks.size(), -1);
  for_each_held_block(model, [&](const HeldMotions& motions) {
    hold_still(motions[0].block, model.blocks.size(), unknowns);
    unknowns.move = unknowns.move || std::ranges::any_of(motions, moves);
  });
  for (std::size_t i = 0; i < absent.size(); ++i)
    if (absent[i]) hold_still(static_cast<int>(i), absent.size(), unknowns);
  return unknowns;
}

void hold_still(int block, std::size_t blocks, HeldUnknowns& held) {
  if (held.holds(block)) return;
  held.place.resize(blocks, -1);
  held.place[at(block)] = static_cast<int>(held.blocks.size());
  held.blocks.push_back(block);
  held.increments.emplace_back(Vec6::Zero());
}

int steps_of_motion(const Model& model, double start, double end, double most, double most_turn) {
  constexpr int looks = 64, most_steps = 300;
  double smallest = std::numeric_limits<double>::infinity();
  for (const Block& block : model.blocks) smallest = std::min(smallest, std::sqrt(block.moments.area));
  double steps = 1;
  for_each_held_block(model, [&](const HeldMotions& motions) {
    if (!std::ranges::any_of(motions, moves)) return;
    const Polygon& shape = model.blocks[at(motions[0].block)].shape;
    const double radius = extent_along(shape.outer, Vec2::UnitX()) + extent_along(shape.outer, Vec2::UnitY());
    Vec6 before = motion_of(model, motions, start).displacement;
    for (int look = 1; look <= looks; ++look) {
      const Vec6 then = displacement_of(model, motions, {start, end, static_cast<double>(look) / looks});
      const Vec6 way = then - before;
      before = then;
      steps = std::max(steps, looks * (way.head<2>().norm() + radius * std::abs(way(2))) / (most * smallest));
      steps = std::max(steps, looks * std::abs(way(2)) / most_turn);
    }
  });
  return static_cast<int>(std::ceil(std::min(steps, static_cast<double>(most_steps))));
}

Vec6 prescribed_displacement(const Model& model, const HeldMotions& motions, double time) {
  return motion_of(model, motions, time).displacement;
}

void aim(const Model& model, const State& state, const LoadTime& time, HeldUnknowns& held) {
  for_each_held_block(model, [&](const HeldMotions& motions) {
    const std::size_t block = at(motions[0].block);
    Vec6& increments = held.increments[at(held.place[block])];
    increments = displacement_of(model, motions, time) - state.displacement[block];
    increments.tail<3>().setZero();
  });
}

bool held_blocks_stand_still_until(const Model& model, const State& state, double time) {
  constexpr double round_off = 1e-14;
  bool still = true;
  for_each_held_block(model, [&](const HeldMotions& motions) {
    if (!still) return;
    const Vec6& now = state.displacement[at(motions[0].block)];
    const Vec6 then = motion_of(model, motions, time).displacement;
    still = !((then - now).head<3>().norm() > round_off * now.head<3>().norm());
  });
  return still;
}

void set_held_rates(const Model& model, State& state) {
  for_each_held_block(model, [&](const HeldMotions& motions) {
    const Motion motion = motion_of(model, motions, state.time);
    state.velocity[at(motions[0].block)] = motion.velocity;
    state.acceleration[at(motions[0].block)] = motion.acceleration;
  });
}

}  // namespace dda
