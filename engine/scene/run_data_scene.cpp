#include "engine/scene/run_data_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <string>
#include <utility>

#include "engine/core/error.h"
#include "engine/drawing/layers.h"
#include "engine/geometry/box.h"

namespace dda {
namespace {

using nlohmann::json;

constexpr double gravities_alike = 0.01;  // of the larger: unit weights and densities are written with few digits

std::string material_word(std::size_t number) { return fmt::format("material {}", number); }
std::string joint_word(std::size_t number) { return fmt::format("joint {}", number); }

// 3 of "material 3", "joint 3" and "joint joint 3".
std::size_t number_at_end(const std::string& word) { return std::stoul(word.substr(word.rfind(' ') + 1)); }

double gravity_of(const BlockMaterialData& material) { return material.unit_weight / material.density; }

// A scene has one gravity.
json gravity_of(const RunData& data) {
  const double gravity = gravity_of(data.materials.front());
  for (const BlockMaterialData& material : data.materials) {
    const double other = gravity_of(material);
    if (std::abs(other - gravity) > gravities_alike * std::max(std::abs(gravity), std::abs(other)))
      throw InputError("", material.origin, fmt::format("a unit weight of {:.4g} times the density", other),
                       fmt::format("{:.4g} times, as of the first material: a scene has one gravity", gravity));
  }
  return {0, -gravity};
}

json material_of(const BlockMaterialData& material) {
  return {{"density", material.density}, {"young", material.young}, {"poisson", material.poisson}};
}

json joint_of(const JointMaterialData& joint, double spring) {
  json entry = {{"friction_angle", joint.friction_deg * std::numbers::pi / 180}, {"cohesion", joint.cohesion}};
  if (joint.tension > 0) entry["tensile_strength"] = joint.tension;
  if (spring > 0) entry["normal_spring"] = spring;
  return entry;
}

// Numbers of joints in the names of layers, "joint 3" or "joint joint 3", with those layers.
std::map<std::string, std::size_t> joints_drawn(const RunData& data, const LineDrawing& drawing) {
  std::map<std::string, std::size_t> numbers;
  for (const DrawnLine& line : drawing.lines) {
    const auto named = named_layer(line.layer);
    if (!named || named->role != LayerRole::rock || numbers.contains(line.layer)) continue;
    const auto number = number_at_end(named->name);
    if (number > data.joints.size() || number == 0)
      throw InputError("", line.origin, fmt::format("of the joint material {}", number),
                       fmt::format("one of the {} of {}", data.joints.size(), data.name));
    numbers[line.layer] = number;
  }
  return numbers;
}

void check_materials(const RunData& data, const LineDrawing& drawing) {
  for (const DrawnLine& line : drawing.lines) {
    if (line.material.empty()) continue;
    const auto number = number_at_end(line.material);
    if (number > data.materials.size())
      throw InputError("", line.origin, fmt::format("of the block material {}", number),
                       fmt::format("one of the {} of {}", data.materials.size(), data.name));
  }
  const auto lines = drawing.passed_over.find("material line");
  if (data.materials.size() > 1 && lines != drawing.passed_over.end())
    throw InputError("", drawing.name, fmt::format("lines with {} material lines among them", lines->second),
                     "the blocks that dc made of it (blck), which have their materials");
}

// In the time of a step nothing moves further than the data allow: what is there at the start, or the weight, stress or
// load that is largest, drives it. This is how df begins.
double first_step(const RunData& data, const std::vector<Block>& blocks) {
  Box box;
  double area = 0;
  for (const Block& block : blocks) {
    for (const Vec2& corner : block.shape.outer) box = expanded(box, corner);
    area += area_moments(block.shape).area / static_cast<double>(blocks.size());
  }
  const double way = data.displacement_ratio * (box.upper.y() - box.lower.y()) / 2;
  const double density = data.materials.front().density;
  double velocity = 0, acceleration = 0, load = 0;
  for (const BlockMaterialData& material : data.materials) {
    velocity = std::max({velocity, std::abs(material.velocity.x()), std::abs(material.velocity.y())});
    acceleration = std::max(acceleration, std::abs(gravity_of(material)));
    for (const double stress : material.stress)
      acceleration = std::max(acceleration, 4 * std::abs(stress) / (std::sqrt(area) * density));
  }
  for (const PointTable& table : data.points) {
    for (const auto& row : table.rows) load = std::max({load, std::abs(row[1]), std::abs(row[2])});
  }
  acceleration = std::max(acceleration, load / (area * density));
  if (acceleration == 0 && velocity == 0) return 0;
  return 2 * way / (velocity + std::sqrt(velocity * velocity + 2 * acceleration * way));
}

json steps_of(const RunData& data, const std::vector<Block>& blocks) {
  double step = first_step(data, blocks);
  if (data.longest_step > 0) step = step > 0 ? std::min(step, data.longest_step) : data.longest_step;
  if (step == 0)
    throw InputError("", data.name, "of blocks without weight, stress, velocity or load, and 0 for the longest step",
                     "a longest step above 0");
  json stage = {{"name", "run"}, {"dt", step}, {"duration", data.steps * step}};
  if (data.velocity_share == 0)
    stage["integrator"] = "static";
  else if (data.velocity_share < 1)
    stage["velocity_factor"] = data.velocity_share;
  return json::array({std::move(stage)});
}

void add_state(const BlockMaterialData& material, json& polygon) {
  const bool has_stress = std::ranges::any_of(material.stress, [](double stress) { return stress != 0; });
  if (has_stress)
    polygon["initial_stress"] = {{"xx", material.stress[0]}, {"yy", material.stress[1]}, {"xy", material.stress[2]}};
  if (material.velocity != Vec2::Zero()) polygon["initial_velocity"] = {material.velocity.x(), material.velocity.y()};
  if (material.spin != 0) polygon["initial_spin"] = material.spin;
}

json history_of(const PointTable& table, std::size_t component) {
  json rows = json::array();
  for (const auto& row : table.rows) rows.push_back({row[0], row[component]});
  return {{"table", std::move(rows)}};
}

bool is_nothing(const PointTable& table, std::size_t component) {
  return std::ranges::all_of(table.rows, [component](const auto& row) { return row[component] == 0; });
}

}  // namespace

int fixed_and_loaded(const LineDrawing& drawing) {
  const auto is_either = [](const DrawnPoint& point) {
    return point.layer == role_names()[static_cast<std::size_t>(LayerRole::fix_point)] ||
           point.layer == role_names()[static_cast<std::size_t>(LayerRole::load_point)];
  };
  return static_cast<int>(std::ranges::count_if(drawing.points, is_either));
}

void take_materials_and_joints(const RunData& data, const LineDrawing& drawing, json& scene) {
  check_materials(data, drawing);
  scene["scheme"] = "thesis";
  scene["gravity"] = gravity_of(data);
  scene["materials"] = json::object();
  for (std::size_t i = 0; i < data.materials.size(); ++i)
    scene["materials"][material_word(i + 1)] = material_of(data.materials[i]);
  json& rock = scene["blocks"]["rock"];
  if (data.materials.size() > 1) rock["material"] = material_word(1);
  scene["joints"] = {{"default", joint_of(data.joints.front(), data.spring)}};
  for (const auto& [layer, number] : joints_drawn(data, drawing)) {
    if (!drawing.encloses || !rock["drawing"]["layers"].contains(layer))
      scene["joints"][joint_word(number)] = joint_of(data.joints[number - 1], data.spring);
    if (drawing.encloses && !rock["drawing"]["layers"].contains(layer))
      rock["drawing"]["layers"][layer] = {{"as", "rock"}, {"joint", joint_word(number)}};
  }
}

void take_steps_and_state(const RunData& data, const std::vector<Block>& blocks, json& scene) {
  scene["steps"] = steps_of(data, blocks);
  for (json& entry : scene["blocks"]) {
    json& polygon = entry["polygon"];
    const std::string material = polygon.value("material", material_word(1));
    add_state(data.materials.at(number_at_end(material) - 1), polygon);
  }
}

void add_loads(const PointTable& table, const json& place, json& scene) {
  const json directions = {{1, 0}, {0, 1}};
  for (std::size_t i = 0; i < 2; ++i) {
    if (is_nothing(table, i + 1)) continue;
    json load = place;
    load["force"] = directions[i];
    load["history"] = history_of(table, i + 1);
    scene["loads"].push_back(std::move(load));
  }
}

void add_moved_supports(const PointTable& table, const json& place, json& scene) {
  const json directions = {{1, 0}, {0, 1}};
  for (std::size_t i = 0; i < 2; ++i) {
    json support = place;
    support["hold"] = i == 0 ? "x" : "y";
    if (!is_nothing(table, i + 1)) {
      support["displacement"] = directions[i];
      support["history"] = history_of(table, i + 1);
    }
    scene["supports"].push_back(std::move(support));
  }
}

}  // namespace dda
