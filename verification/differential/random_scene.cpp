#include "verification/differential/random_scene.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "engine/geometry/cut_pieces.h"

namespace verify {
namespace {

using Json = nlohmann::ordered_json;
using dda::SeededNumbers;
using dda::Vec2;

enum class Layout { bar, grid, polygons, rock };

// What later parts of a scene must know of earlier ones.
struct Sketch {
  Layout layout = Layout::grid;
  bool bonded = false, projected = false;
  bool on_base = false;            // a block that is held lies below all others
  std::vector<Vec2> inside;        // a point in each of some blocks
  std::vector<std::string> names;  // of these blocks
};

const std::string& any_of(SeededNumbers& random, const std::vector<std::string>& names) { return random.one_of(names); }

Json base(double left, double right) {
  return {{"polygon", {{"name", "base"}, {"vertices", {{left, -1}, {right, -1}, {right, 0}, {left, 0}}}}}};
}

Json motion(SeededNumbers& random) { return {random.number(-0.3, 0.3), random.number(-0.3, 0.3)}; }

Json bar(SeededNumbers& random, Sketch& sketch) {
  const int blocks = random.integer(2, 6);
  const double height = random.number(0.5, 1.5);
  for (int i = 0; i < blocks; ++i) {
    sketch.inside.emplace_back(i + 0.5, height / 2);
    sketch.names.push_back("bar " + std::to_string(i + 1));
  }
  Json bar = {{"length", blocks}, {"height", height}, {"block_length", 1}};
  if (random.chance(0.3)) bar["initial_velocity"] = motion(random);
  return {{{"bar", bar}}};
}

Json grid(SeededNumbers& random, Sketch& sketch) {
  const int columns = random.integer(2, 4), rows = random.integer(1, 3);
  const double width = random.number(0.5, 2), height = random.number(0.4, 1.2);
  const bool bricks = random.chance(0.4);
  for (int row = 0; row < rows; ++row) {
    const bool aside = bricks && row % 2 == 1;
    sketch.inside.emplace_back(width * (aside ? 1.0 : 0.5), height * (row + 0.5));
    sketch.names.push_back("grid " + std::to_string(row + 1) + (aside ? ".2" : ".1"));
  }
  Json blocks = {{{"grid",
                   {{"columns", columns},
                    {"rows", rows},
                    {"block_width", width},
                    {"block_height", height},
                    {"pattern", bricks ? "running_bond" : "stack"}}}}};
  if (sketch.on_base) blocks.push_back(base(-1, columns * width + 1));
  return blocks;
}

Json polygons(SeededNumbers& random, Sketch& sketch) {
  const std::vector<dda::Ring> pieces = dda::random_blocks(random, random.integer(2, 8), 0.03);
  double lowest = 0;
  for (const dda::Ring& piece : pieces)
    for (const Vec2& corner : piece) lowest = std::min(lowest, corner.y());
  const double gap = random.chance(0.5) ? 0 : random.magnitude(-4, -2);
  Json blocks = Json::array();
  for (const dda::Ring& piece : pieces) {
    Json vertices;
    dda::Ring corners;
    Vec2 middle = Vec2::Zero();
    for (const Vec2& corner : piece) {
      corners.emplace_back(corner.x(), corner.y() - lowest + gap);
      vertices.push_back({corners.back().x(), corners.back().y()});
      middle += corners.back() / static_cast<double>(piece.size());
    }
    const std::string name = "piece " + std::to_string(blocks.size() + 1);
    if (dda::locate({corners, {}}, middle, 1e-3) == dda::Location::inside) {
      sketch.inside.push_back(middle);
      sketch.names.push_back(name);
    }
    Json polygon = {{"name", name}, {"vertices", vertices}};
    if (random.chance(0.3)) polygon["initial_velocity"] = motion(random);
    if (random.chance(0.2)) polygon["initial_spin"] = random.number(-0.5, 0.5);
    blocks.push_back({{"polygon", polygon}});
  }
  if (sketch.on_base) blocks.push_back(base(-2, 2));
  return blocks;
}

Json rock(SeededNumbers& random, Sketch& sketch) {
  const double width = random.number(3, 5), height = random.number(2, 3);
  Json sets;
  const double dip = random.number(-20, 20);
  for (const double turn : {0.0, random.number(50, 130)})
    sets.push_back(
        {{"joint", "default"}, {"dip", std::to_string(dip + turn) + " deg"}, {"spacing", random.number(0.7, 1.5)}});
  Json blocks = {{{"rock",
                   {{"boundary", {{0, 0}, {width, 0}, {width, height}, {0, height}}},
                    {"joint_sets", sets},
                    {"seed", random.integer(1, 1000)},
                    {"merge", {{"area", 0.02}}}}}}};
  if (sketch.on_base) blocks.push_back(base(-1, width + 1));
  return blocks;
}

Json dry_joint(SeededNumbers& random, Sketch& sketch) {
  Json joint = {{"friction_angle", std::to_string(random.number(0, 45)) + " deg"}};
  if (random.chance(0.3)) {
    joint["cohesion"] = random.magnitude(3, 6);
    joint["tensile_strength"] = random.magnitude(3, 6);
  }
  sketch.projected = random.chance(0.15);
  joint["law"] = sketch.projected ? "projected" : random.chance(0.7) ? "classical" : "consistent";
  if (joint["law"] != "classical") return joint;
  if (random.chance(0.2))
    joint["normal_stiffness"] = random.chance(0.5) ? Json("auto") : Json(random.magnitude(9, 11));
  else
    joint["spring_over_young"] = random.magnitude(-1, 2);
  if (random.chance(0.2)) joint["contact_damping"] = random.number(0, 1);
  if (random.chance(0.1)) joint["dilation_angle"] = "4 deg";
  return joint;
}

Json bonded_joint(SeededNumbers& random) {
  const std::vector<std::string> laws = {"classical", "consistent", "cubic"};
  return {{"bonded", true}, {"law", any_of(random, laws)}};
}

Json history(SeededNumbers& random) {
  switch (random.integer(0, 3)) {
    case 0: return {{"sine", {{"frequency", random.magnitude(1, 2.5)}, {"cycles", random.integer(1, 3)}}}};
    case 1: return {{"triangle", {{"rise", random.magnitude(-3, -1.5)}, {"fall", random.magnitude(-3, -1.5)}}}};
    case 2: return {{"decay", {{"decay_time", random.magnitude(-3, -1.5)}, {"rise", 1e-3}}}};
    default: return {{"table", {{0, 0}, {random.magnitude(-3, -1), 1}, {1, random.number(0, 1)}}}};
  }
}

void add_loads(SeededNumbers& random, const Sketch& sketch, Json& scene) {
  if (sketch.layout != Layout::polygons && random.chance(0.5)) {
    Json load = {{"edge", sketch.on_base || random.chance(0.5) ? "top" : "left"}, {"pressure", random.magnitude(3, 6)}};
    if (random.chance(0.8)) load["history"] = history(random);
    scene["loads"].push_back(load);
  }
  if (!sketch.inside.empty() && random.chance(0.3)) {
    const auto i = static_cast<std::size_t>(random.integer(0, static_cast<int>(sketch.inside.size()) - 1));
    scene["loads"].push_back({{"point", {sketch.inside[i].x(), sketch.inside[i].y()}},
                              {"block", sketch.names[i]},
                              {"force", {random.number(-1e4, 1e4), random.number(-1e4, 1e4)}},
                              {"history", history(random)}});
  }
}

void add_holds(SeededNumbers& random, const Sketch& sketch, Json& scene) {
  if (sketch.on_base) {
    if (random.chance(0.7))
      scene["fixed"] = {"base"};
    else
      scene["supports"].push_back(
          {{"block", "base"}, {"acceleration", {random.number(-2, 2), 0}}, {"history", history(random)}});
    return;
  }
  if (sketch.layout == Layout::polygons) return;
  const std::vector<std::string> ways = {"normal", "xy", "y"};
  if (random.chance(0.7)) scene["supports"].push_back({{"edge", "bottom"}, {"hold", any_of(random, ways)}});
  if (random.chance(0.3)) scene["viscous_boundaries"].push_back({{"edge", "right"}});
}

void add_bolts(SeededNumbers& random, const Sketch& sketch, Json& scene) {
  if (sketch.inside.size() < 2 || !random.chance(0.25)) return;
  const Vec2& from = sketch.inside.front();
  const Vec2& to = sketch.inside.back();
  Json bolt = {{"from", {from.x(), from.y()}}, {"to", {to.x(), to.y()}}, {"stiffness", random.magnitude(6, 8)}};
  bolt["grouted"] = sketch.layout != Layout::polygons && random.chance(0.3);
  if (random.chance(0.5)) bolt["pretension"] = random.magnitude(3, 5);
  if (random.chance(0.3)) bolt["yield_force"] = random.magnitude(5, 6);
  scene["bolts"].push_back(bolt);
}

Json integrator(SeededNumbers& random, const Sketch& sketch) {
  const int kind = random.integer(sketch.projected ? 2 : 0, 4);
  if (kind == 0) return "trapezoidal";
  if (kind == 1) return "energy_conserving";
  if (kind == 2) return "thesis";
  if (kind == 3) return {{"hht", 0.1}};
  return {{"generalized_alpha", random.chance(0.5) ? 0.0 : 0.8}};
}

Json dynamic_stage(SeededNumbers& random, const Sketch& sketch, const std::string& name) {
  const double dt = random.magnitude(-4.5, -2.5);
  Json stage = {{"name", name}, {"dt", dt}, {"duration", dt * random.integer(8, 30)}};
  stage["integrator"] = integrator(random, sketch);
  stage["kinematics"] = random.chance(sketch.bonded ? 0.7 : sketch.projected ? 0.5 : 0.3) ? "small" : "finite";
  if (random.chance(0.15)) stage["damping_rate"] = random.number(1, 50);
  if (random.chance(0.1)) stage["velocity_factor"] = random.number(0.9, 1);
  return stage;
}

void add_stages(SeededNumbers& random, const Sketch& sketch, Json& scene) {
  Json& stages = scene["steps"];
  if (random.chance(0.35)) {
    Json settle = {{"name", "settle"}, {"integrator", "static"}, {"dt", 0.01}, {"duration", 0.05}};
    if (random.chance(0.5)) settle["strength"] = "unlimited";
    if (sketch.projected && random.chance(0.5)) settle["kinematics"] = "small";
    stages.push_back(settle);
  }
  stages.push_back(dynamic_stage(random, sketch, "motion"));
  if (sketch.names.size() < 2 || !random.chance(0.3)) return;
  stages.push_back(dynamic_stage(random, sketch, "later"));
  if (!scene.contains("loads") && !scene.contains("bolts") && random.chance(0.6))
    stages.back()["remove"] = {sketch.names.back()};
}

}  // namespace

nlohmann::ordered_json random_scene(std::uint64_t seed) {
  SeededNumbers random(seed);
  Sketch sketch;
  constexpr std::array layouts{Layout::bar, Layout::grid, Layout::grid, Layout::polygons, Layout::rock};
  sketch.layout = random.one_of(layouts);
  sketch.bonded = sketch.layout == Layout::bar ? random.chance(0.7) : random.chance(0.3);
  sketch.on_base = sketch.layout != Layout::bar && random.chance(0.6);
  Json scene = {{"dda", 1}, {"title", "seed " + std::to_string(seed)}};
  if (random.chance(0.5)) scene["plane"] = "strain";
  scene["materials"]["rock"] = {{"density", random.number(1800, 3000)},
                                {"young", random.magnitude(8.5, 10.8)},
                                {"poisson", random.chance(0.3) ? 0.0 : random.number(0.1, 0.4)}};
  scene["joints"]["default"] = sketch.bonded ? bonded_joint(random) : dry_joint(random, sketch);
  switch (sketch.layout) {
    case Layout::bar: scene["blocks"] = bar(random, sketch); break;
    case Layout::grid: scene["blocks"] = grid(random, sketch); break;
    case Layout::polygons: scene["blocks"] = polygons(random, sketch); break;
    case Layout::rock: scene["blocks"] = rock(random, sketch); break;
  }
  add_holds(random, sketch, scene);
  if (scene.contains("fixed") || scene.contains("supports") ? random.chance(0.7) : random.chance(0.2))
    scene["gravity"] = 9.81;
  if (random.chance(0.15)) scene["stress_field"] = {{"xx", -random.magnitude(4, 6)}, {"yy", -random.magnitude(4, 6)}};
  add_loads(random, sketch, scene);
  add_bolts(random, sketch, scene);
  add_stages(random, sketch, scene);
  return scene;
}

}  // namespace verify
