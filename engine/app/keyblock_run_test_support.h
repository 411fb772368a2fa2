// A body of rock let go while all others are held, as block theory assumes, and what a run makes of it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "engine/app/closed_places_test_support.h"
#include "engine/geometry/box.h"
#include "engine/keyblocks/key_blocks.h"
#include "engine/simulation/simulation.h"

namespace dda {

inline constexpr double standard_gravity = 9.81;  // m/s2
inline constexpr double run_duration = 0.02;      // s
inline constexpr double run_dt = 5e-4;            // s
inline constexpr double close_dt = run_dt / 5;    // s, of runs that are looked at closely
inline constexpr double fall_path = standard_gravity * run_duration * run_duration / 2;  // m, of a free fall

struct LetGo {
  Model model;              // block 0 is free, all others are held
  std::vector<int> blocks;  // their numbers in the rock
};

// The body, one block, with all blocks near it: the rock here has no bonded joints.
inline LetGo let_go(const Model& rock, const KeyBlockQuestion& question, const RockBody& body) {
  LetGo part{rock, body.blocks};
  const Box near = bounding_box(rock.blocks[static_cast<std::size_t>(body.blocks.front())].shape);
  for (int block = 0; block < static_cast<int>(rock.blocks.size()); ++block) {
    const auto index = static_cast<std::size_t>(block);
    const bool is_near = overlap(expanded(near, 0.05), bounding_box(rock.blocks[index].shape));
    if (is_near && !question.is_void[index] && block != body.blocks.front()) part.blocks.push_back(block);
  }
  part.model.blocks.clear();
  part.model.supports.clear();
  for (const int block : part.blocks) {
    part.model.blocks.push_back(rock.blocks[static_cast<std::size_t>(block)]);
    HeldBlock held;
    held.block = static_cast<int>(part.model.blocks.size()) - 1;
    if (held.block > 0) part.model.held_blocks.push_back(held);
  }
  finish_model(part.model);
  return part;
}

// What the centroid is accelerated by, m/s2, and the body about it, rad/s2.
struct Rates {
  Vec2 acceleration = Vec2::Zero();
  double turn = 0;
};

struct Measured {
  std::string failure;  // why the run did not end; empty when it did
  Rates mean;           // 2 u/t^2, of what initial velocity does not make
  // The last tenth of the time, in which contacts hardly change any more: change of velocity, and velocity after it.
  Rates late;
  Vec6 late_velocity = Vec6::Zero();
  int late_steps = 0;
  std::vector<Touched> touched;
  bool has_parted = false;  // from a face that it had when it was let go: what touches there now are corners
};

// Steps until a time (s); false when a step fails. `seen` is told after each step whether it was cut.
template <typename Seen>
bool step_until(Simulation& simulation, double time, const Seen& seen) {
  constexpr double round_off = 1e-9;  // s
  while (simulation.state().time < time - round_off) {
    const std::int64_t parts = simulation.counters().steps;
    if (simulation.step() != Status::ok) return false;
    seen(simulation.counters().steps > parts + 1);
  }
  return true;
}

inline std::ptrdiff_t faces_of(const Simulation& simulation) {
  return std::ranges::count_if(simulation.contacts().interfaces, [](const Interface& each) { return each.length > 0; });
}

// The body begins with `velocity` (m/s), and is looked at for `duration` (s).
inline Measured run_let_go(const LetGo& part, double dt, const Vec2& velocity = Vec2::Zero(),
                           double duration = run_duration) {
  const double early = 0.9 * duration;
  Model model = part.model;
  model.stages.front().dt = dt;
  model.blocks.front().initial_velocity = velocity;
  Simulation simulation(std::move(model));
  Measured measured;
  const std::ptrdiff_t faces = faces_of(simulation);
  bool goes_on = step_until(simulation, early, [](bool) {});
  const Vec6 velocity_before = simulation.state().velocity[0];
  goes_on = goes_on && step_until(simulation, duration, [&](bool was_cut) {
              note_contacts(simulation, part.blocks, fall_path, was_cut, measured.touched);
              ++measured.late_steps;
            });
  measured.has_parted = faces_of(simulation) < faces;
  if (!goes_on) measured.failure = simulation.message();
  const Vec6& moved = simulation.state().displacement[0];
  measured.late_velocity = simulation.state().velocity[0];
  const Vec6 change = (measured.late_velocity - velocity_before) / (duration - early);
  const double factor = 2 / (duration * duration);
  measured.mean = {factor * (moved.head<2>() - duration * velocity), factor * moved[2]};
  measured.late = {change.head<2>(), change[2]};
  return measured;
}

}  // namespace dda
