#include "scenes.h"

#include <cstddef>
#include <numbers>
#include <random>

#include "engine/builder/generators.h"

namespace dda::benchmarks {
namespace {

// Long enough for any benchmark: stages end by their step count only.
constexpr double steps_without_end = 1e12;

Material rock() { return {"rock", 2650, 50e9, 0.25, PlaneState::stress}; }

JointMaterial joint_of(Joints joints) {
  JointMaterial joint;
  joint.name = "joint";
  joint.bonded = joints != Joints::strong_springs;
  joint.law = joints == Joints::consistent ? InterfaceLaw::consistent
              : joints == Joints::cubic    ? InterfaceLaw::cubic
                                           : InterfaceLaw::classical;
  joint.friction_angle = 35 * std::numbers::pi / 180;
  joint.cohesion = 24e6;
  joint.tensile_strength = 18e6;
  return joint;
}

Stage stage_of(double dt, Kinematics kinematics, const Integrator& integrator) {
  Stage stage;
  stage.dt = dt;
  stage.duration = steps_without_end * dt;
  stage.kinematics = kinematics;
  stage.integrator = integrator;
  return stage;
}

}  // namespace

Model bar(int blocks, Joints joints) {
  Model model;
  model.materials.push_back(rock());
  model.joints.push_back(joint_of(joints));
  append_bar(model, {.length = 100, .height = 1, .block_length = 100.0 / blocks});
  model.edge_loads.push_back({0, {0, 1}, {0, 0}, {1e6, 0}, SineCycles{.frequency = 100}});
  const bool accurate = joints == Joints::cubic;
  model.stages.push_back(
      stage_of(1e-5, Kinematics::small, accurate ? generalized_alpha_integrator(0.8) : thesis_integrator()));
  model.stages.back().correct_time_dispersion = accurate;
  finish_model(model);
  return model;
}

Model grid(int side, Joints joints, Kinematics kinematics) {
  Model model;
  model.materials.push_back(rock());
  model.joints.push_back(joint_of(joints));
  append_grid(model, {.columns = side, .rows = side, .block_width = 1, .block_height = 1});
  std::mt19937 generator(1);
  // 1 cm/s makes stresses of 0.1 MPa: far below the joints' strength.
  const auto speed = [&] { return 1e-2 * (static_cast<double>(generator() % 2001) / 1000 - 1); };
  for (Block& block : model.blocks) {
    block.initial_velocity.x() = speed();
    block.initial_velocity.y() = speed();
  }
  model.stages.push_back(stage_of(1e-5, kinematics, trapezoidal_integrator()));
  finish_model(model);
  return model;
}

Model dry_wall(int columns, int rows) {
  Model model;
  model.materials.push_back(rock());
  JointMaterial joint = joint_of(Joints::strong_springs);
  joint.cohesion = 0;
  joint.tensile_strength = 0;
  model.joints.push_back(joint);
  append_grid(
      model,
      {.columns = columns, .rows = rows, .block_width = 2, .block_height = 1, .pattern = GridPattern::running_bond});
  model.gravity = {0, -9.81};
  for (int column = 0; column < columns; ++column) {
    const double left = 2.0 * column;
    for (const double x : {left, left + 2}) {
      PointSupport& support = model.supports.emplace_back();
      support.block = column;
      support.point = {x, 0};
      support.stiffness = 10 * rock().young;
    }
  }
  model.stages.push_back(stage_of(1e-3, Kinematics::finite, thesis_integrator()));
  finish_model(model);
  return model;
}

std::optional<Model> small_scene(std::string_view name) {
  if (name == "bar-consistent") return bar(200, Joints::consistent);
  if (name == "bar-cubic") return bar(200, Joints::cubic);
  if (name == "bar-springs") return bar(200, Joints::strong_springs);
  if (name == "grid-consistent") return grid(20, Joints::consistent, Kinematics::small);
  if (name == "grid-springs") return grid(20, Joints::strong_springs, Kinematics::small);
  if (name == "grid-finite") return grid(20, Joints::strong_springs, Kinematics::finite);
  return std::nullopt;
}

}  // namespace dda::benchmarks
