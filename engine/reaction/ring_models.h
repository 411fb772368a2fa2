// For tests: a round opening in rings of elastic rock under a stress that is the same in all directions.
#pragma once

#include <cmath>
#include <numbers>

#include "engine/model/model.h"

namespace dda {

inline constexpr double young = 10e9;  // Pa
inline constexpr double poisson = 0.25;
inline constexpr double pressure = 10e6;    // Pa, in situ, the same in all directions
inline constexpr double radius = 1;         // m, of the hole
inline constexpr double outer_radius = 10;  // m, on which the pressure stays

inline Vec2 on_circle(double size, int corner, int sectors) {
  const double angle = 2 * std::numbers::pi * corner / sectors;
  return size * Vec2(std::cos(angle), std::sin(angle));
}

inline Stage static_stage(const char* name) {
  Stage stage;
  stage.name = name;
  stage.integrator = static_integrator();
  stage.kinematics = Kinematics::small;
  stage.equilibrium = 1e-9;
  return stage;
}

// Rings of blocks about as long as they are wide around a core, which is block 0; all bonded.
inline Model rings_around_core(int sectors) {
  Model model;
  model.materials = {{"rock", 2600, young, poisson, PlaneState::strain}};
  JointMaterial bonded;
  bonded.bonded = true;
  model.joints = {bonded};
  const int rings =
      sectors * 3 / 8;  // about log(outer_radius/radius)/(2 pi) of the sectors, and twice as many of twice
  const auto size = [rings](int ring) {
    return radius * std::pow(outer_radius / radius, static_cast<double>(ring) / rings);
  };
  Block& core = model.blocks.emplace_back();
  for (int i = 0; i < sectors; ++i) core.shape.outer.push_back(on_circle(radius, i, sectors));
  for (int ring = 0; ring < rings; ++ring) {
    for (int i = 0; i < sectors; ++i) {
      const Vec2 a = on_circle(size(ring + 1), i, sectors);
      const Vec2 b = on_circle(size(ring + 1), i + 1, sectors);
      model.blocks.emplace_back().shape.outer = {on_circle(size(ring), i, sectors), a, b,
                                                 on_circle(size(ring), i + 1, sectors)};
      if (ring + 1 < rings) continue;
      const Vec2 inward = -(a + b).normalized();
      model.edge_loads.push_back({static_cast<int>(model.blocks.size()) - 1, a, b, pressure * inward, Constant{}});
    }
  }
  for (Block& block : model.blocks) block.initial_stress = {-pressure, -pressure, 0};
  model.stages = {static_stage("in situ"), static_stage("opening")};
  model.stages[1].removal.blocks = {0};
  finish_model(model);
  return model;
}

}  // namespace dda
