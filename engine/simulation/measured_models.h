// For tests: scenes that are measured, and what is measured in them.
#pragma once

#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "engine/model/quantity_names.h"
#include "engine/simulation/probes.h"
#include "engine/simulation/simulation_models.h"

namespace dda {

inline Measurement& measure(Model& model, Quantity quantity) {
  Measurement& measurement = model.measurements.emplace_back();
  measurement.quantity = quantity;
  measurement.name = std::to_string(model.measurements.size());
  return measurement;
}

// At the centroid of a block, which a finished model knows.
inline void measure(Model& model, Quantity quantity, int block) {
  finish_model(model);
  Measurement& measurement = measure(model, quantity);
  measurement.block = block;
  measurement.point = model.blocks[static_cast<std::size_t>(block)].moments.centroid;
}

inline void measure(Model& model, Quantity quantity, const std::vector<int>& blocks) {
  measure(model, quantity).blocks = blocks;
}

inline std::vector<double> sampled(const Simulation& simulation) {
  const Probes probes(simulation);
  std::vector<double> values(probes.size());
  probes.sample(simulation, values);
  return values;
}

// Bricks between dry joints on a floor that is held and shaken, under their weight and loads drawn at random; the right
// side leans on a prop, a spring in x. Block 0 is the floor.
inline Model shaken_wall(Kinematics kinematics, unsigned seed = 1) {
  constexpr int size = 3;
  JointMaterial joint;
  joint.law = InterfaceLaw::classical;
  joint.friction_angle = 0.6;
  Model model = grid_of(size, joint, Pattern::running_bond);
  model.blocks.insert(model.blocks.begin(), rectangle("floor", -1, -1, size + 2, 1));
  model.gravity = {0, -10};
  model.held_blocks.resize(1);
  model.held_blocks[0].amplitude = {2, 0};
  model.held_blocks[0].kind = MotionKind::acceleration;
  model.held_blocks[0].history = SineCycles{20, 10, 0};
  finish_model(model);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> force(-3e3, 3e3);
  std::uniform_real_distribution<double> frequency(20, 200);
  for (int i = 1; i < static_cast<int>(model.blocks.size()); ++i) {
    const Vec2 centroid = model.blocks[static_cast<std::size_t>(i)].moments.centroid;
    model.point_loads.push_back(
        {i, centroid + Vec2(0.1, 0.2), {force(random), force(random)}, SineCycles{frequency(random), 20, 0}});
  }
  model.supports = {{static_cast<int>(model.blocks.size()) - 1, {size, 1.6}, true, false, 1e8, Vec2::Zero(), {}}};
  model.stages = {stage_of(thesis_integrator(), 1e-4, 200, kinematics)};
  return model;
}

// Something of every subject but bolts.
inline void measure_everything(Model& model) {
  finish_model(model);
  measure(model, Quantity::stress_1, 1);
  measure(model, Quantity::velocity_x, std::vector<int>{1, 2, 3});
  measure(model, Quantity::kinetic_energy, std::vector<int>{1, 2, 3});
  Measurement& reaction = measure(model, Quantity::reaction);
  reaction.blocks = {0};
  reaction.supports = {0};
  Measurement& contact = measure(model, Quantity::contact_force);
  contact.blocks = {0};
  contact.others = {1, 2, 3};
  Measurement& resultant = measure(model, Quantity::resultant);
  resultant.from = {-1, 0.7};
  resultant.to = {4, 0.7};
  measure(model, Quantity::contacts);
}

}  // namespace dda
