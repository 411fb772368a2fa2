// The scenes that benchmarks and the instruction-count workload step.
#pragma once

#include <optional>
#include <string_view>

#include "engine/model/model.h"

namespace dda::benchmarks {

enum class Joints {
  consistent,      // bonded, Nitsche at mid-edge
  cubic,           // bonded, along chains the cubic law
  bonded_springs,  // bonded, corner springs
  strong_springs,  // corner springs with the thesis's strength, judged every step, never exceeded
};

// The P bar of the thesis: 100 m long, 1 m high, one cycle of 100 Hz at its left end, small kinematics, dt = 1e-5 s.
Model bar(int blocks, Joints joints);

// A square of side x side bonded or strong unit blocks, each with its own initial velocity, so that no contact is at
// rest. dt = 1e-5 s.
Model grid(int side, Joints joints, Kinematics kinematics);

// A dry brick wall under its weight: unit-high rows in running bond on a held bottom row, no cohesion, no tension;
// contacts change while it settles. dt = 1e-3 s.
Model dry_wall(int columns, int rows);

// One of the above by its name, for command lines; empty for a name that is none of scene_names.
inline constexpr std::string_view scene_names =
    "bar-consistent bar-cubic bar-springs grid-consistent grid-springs grid-finite";
std::optional<Model> small_scene(std::string_view name);

}  // namespace dda::benchmarks
