#include "verification/stability/scenes.h"

#include <cmath>
#include <numbers>

#include "engine/geometry/cut_pieces.h"

namespace verify {
namespace {

using Json = nlohmann::ordered_json;

constexpr double degree = std::numbers::pi / 180;
constexpr double base_depth = 1;  // m

Json integrator_of(const std::string& name) {
  const std::size_t space = name.find(' ');
  if (space == std::string::npos) return name;
  return {{name.substr(0, space), std::stod(name.substr(space))}};
}

Json material(double density, double poisson) {
  return {{"density", density}, {"young", rock_young}, {"poisson", poisson}};
}

Json materials(const Setting& setting, double poisson) {
  return {{"heavy", material(rock_density, poisson)}, {"light", material(rock_density / setting.mass_ratio, poisson)}};
}

Json dry(const Setting& setting, double friction) {
  return {{"law", "classical"}, {"friction_angle", friction * degree}, {"spring_over_young", setting.penalty}};
}

Json box(const std::string& name, double left, double bottom, double right, double top,
         const std::string& material = "heavy") {
  return {{"polygon",
           {{"name", name},
            {"material", material},
            {"vertices", {{left, bottom}, {right, bottom}, {right, top}, {left, top}}}}}};
}

Json moving_stage(const Setting& setting) {
  return {{"name", "motion"},
          {"dt", setting.dt},
          {"duration", setting.dt * steps_of(setting)},
          {"integrator", integrator_of(setting.integrator)}};
}

Json scene_with(const Setting& setting, double poisson) {
  return {{"dda", 1}, {"title", words_for(setting)}, {"materials", materials(setting, poisson)}};
}

Json pulse(const Setting& setting) {
  Json scene = scene_with(setting, 0);
  scene["joints"]["default"] = {{"law", "classical"}, {"bonded", true}, {"spring_over_young", setting.penalty}};
  for (int i = 0; i < pulse_columns; ++i)
    scene["blocks"].push_back({{"grid",
                                {{"name", "column " + std::to_string(i + 1)},
                                 {"material", i % 2 == 0 ? "heavy" : "light"},
                                 {"origin", {i, 0}},
                                 {"columns", 1},
                                 {"rows", pulse_rows},
                                 {"block_width", 1},
                                 {"block_height", row_height(setting)}}}});
  scene["loads"] = {{{"edge", "left"},
                     {"traction", {pulse_peak, 0}},
                     {"history", {{"triangle", {{"rise", pulse_rise}, {"fall", pulse_rise}}}}}}};
  scene["steps"] = moving_stage(setting);
  scene["steps"]["kinematics"] = "small";
  return scene;
}

constexpr int light_rows = wall_rows / 2;

Json bricks(const Setting& setting, const std::string& name, double bottom, const std::string& material) {
  return {{"grid",
           {{"name", name},
            {"material", material},
            {"origin", {0, bottom}},
            {"columns", 3},
            {"rows", light_rows},
            {"block_width", wall_width / 3},
            {"block_height", row_height(setting)},
            {"pattern", "running_bond"}}}};
}

Json wall(const Setting& setting) {
  Json scene = scene_with(setting, 0.2);
  scene["gravity"] = weight_pull;
  scene["joints"]["default"] = dry(setting, 35);
  scene["blocks"] = {box("base", -1, -base_depth, wall_width + 1, 0), bricks(setting, "below", 0, "light"),
                     bricks(setting, "above", light_rows * row_height(setting), "heavy")};
  scene["fixed"] = {"base"};
  scene["measurements"] = {{{"quantity", "reaction"}, {"block", "base"}}};
  scene["steps"] = {{{"name", "settle"}, {"integrator", "static"}}, moving_stage(setting)};
  return scene;
}

Json incline(const Setting& setting) {
  const Extent size = slider_extent(setting);
  Json scene = scene_with(setting, 0.2);
  scene["gravity"] = {weight_pull * std::sin(incline_angle * degree), -weight_pull * std::cos(incline_angle * degree)};
  scene["joints"] = {{"default", dry(setting, incline_friction)}, {"rough", dry(setting, 40)}};
  scene["joint_pairs"] = {{{"between", {"light", "heavy"}}, {"joint", "rough"}},
                          {{"between", {"slider", "base"}}, {"joint", "default"}}};
  scene["blocks"] = {box("base", -size.width, -base_depth, 3 + 2 * size.width, 0),
                     box("slider", 0, 0, size.width, size.height, "light"),
                     box("rider", 0, size.height, size.width, 2 * size.height)};
  scene["fixed"] = {"base"};
  scene["steps"] = {{{"name", "settle"}, {"integrator", "static"}, {"strength", "unlimited"}}, moving_stage(setting)};
  return scene;
}

// Rock that is cut into pieces, not too small, above the floor of a box.
Json pile(const Setting& setting) {
  const Extent scale = pile_scale(setting);
  dda::SeededNumbers random(7);  // three pieces
  const std::vector<dda::Ring> pieces = dda::random_blocks(random, 5, 0.05);
  double lowest = 0;
  for (const dda::Ring& piece : pieces)
    for (const dda::Vec2& corner : piece) lowest = std::min(lowest, corner.y());
  Json scene = scene_with(setting, 0.2);
  scene["gravity"] = weight_pull;
  scene["joints"]["default"] = dry(setting, 30);
  const double half = pile_box * scale.width, thick = base_depth;
  scene["blocks"] = {box("floor", -half - thick, -thick, half + thick, 0), box("left", -half - thick, 0, -half, 3),
                     box("right", half, 0, half + thick, 3)};
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Json vertices;
    for (const dda::Vec2& corner : pieces[i])
      vertices.push_back({scale.width * corner.x(), pile_gap + scale.height * (corner.y() - lowest)});
    scene["blocks"].push_back({{"polygon",
                                {{"name", "piece " + std::to_string(i + 1)},
                                 {"material", i % 2 == 0 ? "heavy" : "light"},
                                 {"vertices", vertices}}}});
  }
  scene["fixed"] = {"floor", "left", "right"};
  scene["steps"] = moving_stage(setting);
  return scene;
}

}  // namespace

double row_height(const Setting& setting) { return (setting.problem == ChartProblem::wall ? 0.5 : 1) / setting.aspect; }

Extent slider_extent(const Setting& setting) {
  return {2 * std::sqrt(setting.aspect), 0.5 / std::sqrt(setting.aspect)};
}

Extent pile_scale(const Setting& setting) { return {std::sqrt(setting.aspect), 1 / std::sqrt(setting.aspect)}; }

nlohmann::ordered_json scene_of(const Setting& setting) {
  switch (setting.problem) {
    case ChartProblem::pulse: return pulse(setting);
    case ChartProblem::wall: return wall(setting);
    case ChartProblem::incline: return incline(setting);
    case ChartProblem::pile: return pile(setting);
  }
  return {};
}

}  // namespace verify
