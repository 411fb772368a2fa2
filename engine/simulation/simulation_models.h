// For tests: scenes put together by hand, and what is asked of their runs.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "engine/contact/contact_models.h"
#include "engine/core/error.h"
#include "engine/model/model.h"
#include "engine/simulation/simulation.h"

namespace dda {

inline Stage stage_of(const Integrator& integrator, double dt, int steps, Kinematics kinematics = Kinematics::small) {
  Stage stage;
  stage.dt = dt;
  stage.duration = dt * steps;
  stage.integrator = integrator;
  stage.kinematics = kinematics;
  stage.solver = SolverRequest::cholesky;  // to round-off; PCG stops at 1e-12
  return stage;
}

// A static stage in finite kinematics that finds its own steps and ends in balance to `equilibrium`.
inline Stage settling_stage(double equilibrium, double duration = 0) {
  Stage stage = stage_of(static_integrator(), 0, 0, Kinematics::finite);
  stage.equilibrium = equilibrium;
  stage.duration = duration;
  return stage;
}

inline Material rock_of(double young) {
  Material material = rock();
  material.young = young;
  return material;
}

// A named block, its lower left corner at (left, bottom).
inline Block rectangle(const std::string& name, double left, double bottom, double width, double height) {
  Block block;
  block.name = name;
  block.shape.outer = box_ring(left, bottom, left + width, bottom + height);
  return block;
}

inline JointMaterial bond(InterfaceLaw law) {
  JointMaterial joint;
  joint.law = law;
  joint.bonded = true;
  return joint;
}

// The same but judged every step, and too strong to give way: takes the general path.
inline JointMaterial strong(InterfaceLaw law) {
  JointMaterial joint;
  joint.law = law;
  joint.tensile_strength = joint.cohesion = 1e30;
  return joint;
}

// Blocks of 1 m in a row. Not finished: loads and stages are still to come.
inline Model bar_of(int blocks, const JointMaterial& joint, const Material& material = rock()) {
  Model model;
  model.materials = {material};
  model.joints = {joint};
  for (int i = 0; i < blocks; ++i) model.blocks.emplace_back().shape.outer = box_ring(i, 0, i + 1, 0.8);
  return model;
}

enum class Pattern { stack, running_bond };

// `size` rows of as many blocks 1 m wide; in a running bond the odd ones have half blocks at both ends.
inline Model grid_of(int size, const JointMaterial& joint, Pattern pattern = Pattern::stack) {
  constexpr double height = 0.7;
  Model model;
  model.materials = {rock()};
  model.joints = {joint};
  for (int row = 0; row < size; ++row) {
    const double shift = pattern == Pattern::running_bond && row % 2 == 1 ? 0.5 : 0;
    for (double left = -shift; left < size; ++left)
      model.blocks.emplace_back().shape.outer =
          box_ring(std::max(left, 0.0), height * row, std::min(left + 1, 1.0 * size), height * (row + 1));
  }
  return model;
}

// The sentence with which a model is refused; "accepted" where it is not.
inline std::string refusal_of(Model model) {
  try {
    finish_model(model);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

inline Simulation simulation_of(Model model) {
  finish_model(model);
  return Simulation(std::move(model));
}

inline void run(Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i)
    ASSERT_EQ(simulation.step(), Status::ok) << "step " << i << ": " << simulation.message();
}

inline std::vector<Integrator> dynamic_integrators() {
  return {thesis_integrator(), trapezoidal_integrator(), hht_integrator(0.1), generalized_alpha_integrator(0.8)};
}

}  // namespace dda
