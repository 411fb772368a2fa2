#include "verification/chapters/strain_relaxation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace verify {
namespace {

using Json = SceneFolder::Scene;

constexpr double gravity = 9.81;     // m/s2
constexpr double tunnel_radius = 5;  // m
// Share of the largest load, weights and all: what is out of balance then accelerates blocks by about 1e-6 m/s2.
constexpr double settled = 1e-7;
constexpr double far_point = 20;         // m from the tunnel's wall, point 5
constexpr double beside_the_wall = 0.3;  // m, so that point 3 lies in a block at the wall

Json rock(const RelaxationReading& reading) {
  const double h = reading.half_width;
  return {
      {"boundary", {{-h, -h}, {h, -h}, {h, h}, {-h, h}}},
      {"joint_sets",
       {joint_set("rising", reading.first, reading.spacing), joint_set("falling", reading.second, reading.spacing)}},
      {"openings", {{{"name", "tunnel"}, {"circle", {{"radius", tunnel_radius}}}, {"chord_tolerance", "0.1 m"}}}},
      {"merge", {{"area", 0.2}}}};
}

Json measurements(const RelaxationReading& reading, const KeyBlocks& blocks) {
  Json list = Json::array();
  if (!blocks.wall.empty()) measure_motion(list, "block_1", {{"block", blocks.wall}});
  if (!blocks.roof.empty()) measure_motion(list, "block_2", {{"block", blocks.roof}});
  measure_stress(list, "point_3", {tunnel_radius + beside_the_wall, 0.2});
  measure_stress(list, "point_5", {std::min(tunnel_radius + far_point, reading.half_width - 2), 0.2});
  return list;
}

Json steps(const RelaxationReading& reading) {
  return {{{"name", "settle"}, {"integrator", "static"}, {"strength", "unlimited"}, {"equilibrium", settled}},
          {{"name", "excavate"},
           {"remove", {"tunnel"}},
           {"dt", reading.dt},
           {"duration", reading.duration},
           {"velocity_factor", reading.velocity_factor}}};
}

double largest(const SceneRun& run, const std::string& prefix) {
  const std::vector<double> sizes = run.size_of(prefix);
  double value = 0;
  for (std::size_t row = run.settled_row(); row < sizes.size(); ++row) value = std::max(value, sizes[row]);
  return value;
}

double largest_change(const SceneRun& run, const std::string& column) {
  const std::vector<double>& history = run.at(column);
  const std::size_t begin = run.settled_row();
  double value = 0;
  for (std::size_t row = begin; row < history.size(); ++row)
    value = std::max(value, std::abs(history[row] - history[begin]));
  return value;
}

std::size_t last_fifth(const SceneRun& run) {
  return run.times().size() - 1 - (run.times().size() - run.settled_row()) / 5;
}

double displaced(const SceneRun& run, const std::string& prefix) {
  const std::size_t begin = run.settled_row();
  const auto &x = run.at(prefix + "_x"), &y = run.at(prefix + "_y");
  double value = 0;
  for (std::size_t row = begin; row < x.size(); ++row)
    value = std::max(value, std::hypot(x[row] - x[begin], y[row] - y[begin]));
  return value;
}

double mean_speed_down(const SceneRun& run, const std::string& column) {
  const std::vector<double>& y = run.at(column);
  const std::size_t from = last_fifth(run);
  return (y[from] - y.back()) / (run.times().back() - run.times()[from]);
}

double mean_speed(const SceneRun& run, const std::string& prefix) {
  const std::size_t from = last_fifth(run);
  const auto &x = run.at(prefix + "_x"), &y = run.at(prefix + "_y");
  return std::hypot(x.back() - x[from], y.back() - y[from]) / (run.times().back() - run.times()[from]);
}

// Speed of a block in free fall after every step: what it had is multiplied by the factor after each of them.
double free_fall(const RelaxationReading& reading) {
  const auto steps = static_cast<int>(std::lround(reading.duration / reading.dt));
  const int last = steps / 5;
  double speed = 0;
  double sum = 0;
  for (int step = 0; step < steps; ++step) {
    speed = reading.velocity_factor * (speed + gravity * reading.dt);
    if (step >= steps - last) sum += speed;
  }
  return sum / last;
}

std::string search_name(const RelaxationReading& reading) { return fmt::format("relaxation-{}-blocks", reading.name); }

std::string largest_body(const Json& bodies, const auto& counts) {
  std::string name;
  double area = 0;
  for (const Json& body : bodies)
    if (counts(body) && body.at("area") > area) {
      area = body.at("area");
      name = body.at("blocks").front();
    }
  return name;
}

}  // namespace

std::string relaxation_run(const RelaxationReading& reading, double stress) {
  return fmt::format("relaxation-{}-{:g}MPa", reading.name, stress / 1e6);
}

std::vector<double> relaxation_stresses() { return {0, 10e6, 30e6, 50e6}; }

KeyBlocks key_blocks_of(const Json& bodies) {
  const auto is = [](const Json& body, const char* type) { return body.at("type") == type; };
  const auto at = [](const Json& body, std::size_t axis) { return body.at("centroid").at(axis).get<double>(); };
  return {largest_body(bodies, [&](const Json& b) { return is(b, "II") && at(b, 0) < -tunnel_radius / 2; }),
          largest_body(bodies, [&](const Json& b) { return is(b, "I") && at(b, 1) > tunnel_radius / 2; })};
}

Json relaxation_scene(const RelaxationReading& reading, double stress, const KeyBlocks& blocks) {
  Json scene = {
      {"dda", 1},
      {"title", fmt::format("Strain relaxation, {:g} MPa, {}", stress / 1e6, reading.name)},
      {"description", "Section 6.1 of Zelig (2015): " + reading.difference},
      {"scheme", reading.scheme},
      {"gravity", gravity},
      {"materials", {{"rock", {{"density", 2563}, {"young", "25 GPa"}, {"poisson", 0.333}}}}},
      {"joints", {{"default", {{"friction_angle", "65 deg"}, {"law", "classical"}, {"spring_over_young", 10}}}}},
      {"blocks", {{"rock", rock(reading)}}}};
  if (stress > 0) {
    scene["stress_field"] = {{"xx", -stress}, {"yy", -stress}};
    scene["loads"] = {{{"edge", "outside"}, {"traction", "in-situ"}}};
  }
  scene["supports"] = held_while_settling(reading.sides_held);
  scene["viscous_boundaries"] = {{{"edge", "outside"}, {"from_stage", "excavate"}}};
  scene["measurements"] = measurements(reading, blocks);
  scene["steps"] = steps(reading);
  return scene;
}

RelaxationOutcome relaxation_outcome(const RelaxationReading& reading, double stress, const SceneRun& run) {
  return {stress,
          largest(run, "block_1_velocity"),
          largest(run, "block_1_acceleration"),
          displaced(run, "block_1_displacement"),
          mean_speed(run, "block_1_displacement"),
          mean_speed_down(run, "block_2_displacement_y"),
          free_fall(reading),
          std::max(largest_change(run, "point_3_xx"), largest_change(run, "point_3_yy")),
          std::max(largest_change(run, "point_5_xx"), largest_change(run, "point_5_yy"))};
}

namespace {

// Scenes of the readings in which block theory finds both key blocks.
std::vector<std::string> put_scenes(const SceneFolder& folder, std::vector<RelaxationResult>& results) {
  std::vector<std::string> names;
  for (RelaxationResult& result : results) {
    const KeyBlocks blocks = key_blocks_of(folder.key_blocks(search_name(result.reading)));
    if (blocks.wall.empty() || blocks.roof.empty()) {
      result.missing = "block theory finds no key block at the left wall or in the roof";
      continue;
    }
    for (const double stress : relaxation_stresses()) {
      names.push_back(relaxation_run(result.reading, stress));
      folder.put(names.back(), relaxation_scene(result.reading, stress, blocks));
    }
  }
  return names;
}

void read_outcomes(const SceneFolder& folder, RelaxationResult& result, std::vector<std::string>& failures) {
  if (!result.missing.empty()) return;
  for (const double stress : relaxation_stresses()) {
    const SceneRun run = folder.read(relaxation_run(result.reading, stress));
    if (run.ok()) {
      result.outcomes.push_back(relaxation_outcome(result.reading, stress, run));
      continue;
    }
    failures.push_back(fmt::format("{}: {}, {}", run.name, run.status, run.message));
    result.missing += fmt::format("{}{:g} MPa: {}", result.missing.empty() ? "" : ", ", stress / 1e6, run.status);
  }
}

}  // namespace

std::vector<RelaxationResult> run_relaxation(const SceneFolder& folder, const std::vector<RelaxationReading>& readings,
                                             std::vector<std::string>& failures) {
  std::vector<RelaxationResult> results;
  std::vector<std::string> searches;
  for (const RelaxationReading& reading : readings) {
    results.push_back({reading, {}, ""});
    searches.push_back(search_name(reading));
    folder.put(searches.back(), relaxation_scene(reading, 0, {}));
  }
  folder.find_key_blocks(searches, "tunnel");
  folder.run(put_scenes(folder, results));
  for (RelaxationResult& result : results) read_outcomes(folder, result, failures);
  return results;
}

}  // namespace verify
