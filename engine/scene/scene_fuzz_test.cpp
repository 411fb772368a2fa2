// Damaged scenes are read to blocks, masses and stages that can be stepped, or refused in one sentence.
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/core/fuzz_support.h"
#include "engine/core/read_file.h"
#include "engine/scene/scene.h"

namespace dda {
namespace {

// Polygons with a hole, joints that fail, bolts, a lining, supports of all kinds, and stages that change the rock.
constexpr auto blocks = R"({"dda": 1, "title": "all kinds", "gravity": 9.81,
  "materials": {"rock": {"density": "2600 kg/m3", "young": "1 GPa", "poisson": 0.2}, "soft": {"density": 2000, "young": 1e8, "poisson": 0.3}},
  "joints": {"default": {"friction_angle": "30 deg", "normal_stiffness": "20 GPa/m"}, "mortar": {"law": "projected",
    "friction_angle": "30 deg", "cohesion": "2 kPa", "tensile_strength": "1 kPa", "residual_friction_angle": "25 deg"}},
  "joint_pairs": [{"between": ["left", "middle"], "joint": "mortar"}],
  "joint_lines": [{"points": [[2, 0], [2, 1]], "joint": "mortar"}],
  "blocks": [{"polygon": {"name": "left", "material": "rock", "vertices": [[0, 0], [1, 0], [1, 1], [0, 1]]}},
    {"polygon": {"name": "middle", "material": "rock", "vertices": [[1, 0], [2, 0], [2, 1], [1, 1]],
                 "holes": [[[1.2, 0.2], [1.6, 0.2], [1.4, 0.5]]]}},
    {"polygon": {"name": "right", "material": "soft", "vertices": [[2, 0], [3, 0], [3, 1], [2, 1]], "initial_velocity": [1, 0]}},
    {"polygon": {"name": "low", "material": "rock", "vertices": [[0.8, -0.5], [2.1, -0.5], [2.1, 0], [0.8, 0]], "initial_spin": "3 deg/s"}}],
  "fixed": ["left"],
  "supports": [{"name": "foot", "point": [3, 0.5], "block": "right", "hold": "x", "stiffness": "1 GN/m", "displacement": [1e-4, 0],
                "history": {"sine": {"frequency": "10 Hz", "cycles": 2}}},
               {"edge": {"from": [2, 0], "to": [3, 0]}, "block": "right", "until_stage": "a", "release": true}],
  "bolts": [{"name": "b", "from": [0.5, 0.9], "to": [1.5, 0.9], "young": "200 GPa", "diameter": "25 mm", "grouted": true,
             "shear_stiffness": "1 MN/m", "yield_force": "1 kN", "from_stage": "b"}],
  "linings": [{"name": "shotcrete", "along": [[1, 1], [3, 1]], "thickness": "10 cm", "young": "15 GPa",
               "compressive_strength": "20 MPa", "until_stage": {"stage": "b", "over": "10 ms"}}],
  "loads": [{"edge": {"cavity": [1.4, 0.3]}, "pressure": {"uniform": "1 kPa", "surface": 1, "gradient": "9.81 kPa/m"}, "follows": true,
             "history": {"decay": {"decay_time": "1 ms", "rise": "20 us"}}}, {"point": [2.5, 1], "force": ["1 kN", 0], "from_stage": "b"}],
  "measurements": [{"quantity": "stress_1", "point": [1.1, 0.5]}, {"quantity": "reaction", "support": "foot"},
                   {"quantity": "contact_force", "between": ["left", "middle"]}, {"quantity": "bolt_force", "bolt": "b"},
                   {"quantity": "resultant", "line": {"from": [2, 0], "to": [2, 1]}}, {"quantity": "lining_thrust", "lining": "shotcrete"}],
  "peaks": {"stage": "b", "ejected": {"distance": "0.2 m"}, "attenuation": {"source": [0, 30], "charge": "10 kg"}},
  "steps": [{"name": "a", "integrator": "static", "strength": "unlimited"},
    {"name": "b", "dt": "1 ms", "duration": "0.1 s", "remove": {"blocks": ["low"], "table": [[0, 1], [0.05, 0.2]]}},
    {"name": "c", "dt": "1 ms", "duration": "0.1 s", "add": ["low"], "joints": {"default": {"friction_angle": "20 deg"}},
     "materials": {"soft": {"density": 2100}}, "integrator": {"hht": 0.1}, "damping_rate": "5 1/s"}]})";

// Bonded grids and rings between absorbing edges, with layers, tables of place, and waves.
constexpr auto waves = R"({"dda": 1, "plane": "strain", "scheme": "accurate", "target_frequency": "200 Hz",
  "materials": {"rock": {"density": 2600, "young": "10 GPa", "poisson": 0.2}}, "joints": {"default": {"bonded": true, "law": "consistent", "penalty": 5}},
  "blocks": [{"grid": {"name": "low", "origin": [0, -4], "columns": 3, "rows": 2, "block_width": 1, "block_height": 1, "pattern": "running_bond"}},
             {"rings": {"name": "ring", "centre": [9, 0], "radii": [0.65, 1.306563], "sectors": 8, "first_corner": "22.5 deg"}},
             {"bar": {"name": "bar", "origin": [0, 20], "length": "4 m", "height": 1, "block_length": 2}}],
  "stress_field": {"xx": "-1 MPa", "surface": 30, "layers": [{"down_to": 0, "gradient": "25 kPa/m", "k0": 0.5}, {"density": 2600}]},
  "gravity": [0, "-1 g"],
  "initial_fields": [{"group": "bar", "x": [0, 4], "y": [20.5], "velocity_x": [[0, 1]], "strain_rate_xx": [[0.1, 0.2]]}],
  "supports": [{"edge": "bottom", "hold": "normal", "acceleration": [0, 1], "history": {"table": [[0, 0], [0.01, 1], [0.02, 0]]}}],
  "viscous_boundaries": [{"edge": {"from": [0, 20], "to": [0, 21]}, "normal_speed": "bar", "carries_initial_stress": true, "ratio": 0.9}],
  "loads": [{"edge": {"from": [0, -2], "to": [3, -2]}, "traction": "in-situ"},
            {"edge": {"from": [4, 20], "to": [4, 21]}, "force": ["1 MN", 0], "history": {"triangle": {"rise": "1 ms", "fall": "2 ms"}}}],
  "measurements": [{"quantity": "velocity_x", "group": "bar"}, {"quantity": "traction_normal", "point": [2, 20.5]}],
  "steps": {"dt": "auto", "duration": "5 ms", "kinematics": "small", "damping": {"ratio": 0.02, "frequencies": [50, "200 Hz"]}}})";

// Rock that joint sets, lines, an opening with rings, and grains cut.
constexpr auto rock =
    R"({"dda": 1, "materials": {"rock": {"density": 2600, "young": "1 GPa", "poisson": 0.2}, "dyke": {"density": 2600, "young": "1 GPa", "poisson": 0.2}},
  "joints": {"default": {"friction_angle": "30 deg"}, "grain": {"cohesion": "1 MPa"}, "mesh": {"bonded": true}},
  "blocks": {"rock": {"boundary": [[0, 0], [6, 0], [6, 6], [0, 6]], "material": "rock", "seed": 3, "tolerance": 0.002,
    "lines": [{"points": [[0, 1], [6, 1.2]], "joint": "default"}],
    "joint_sets": [{"name": "bedding", "dip": "10 deg", "spacing": "2 m", "joint": "default"},
      {"name": "cross", "dip": {"mean": "80 deg", "deviation": "4 deg", "distribution": "uniform"}, "spacing": {"mean": "2 m", "distribution": "exponential"},
       "trace_length": "3 m", "persistence": 0.7, "ends_at": ["bedding"], "joint": "default"}],
    "openings": [{"name": "tunnel", "horseshoe": {"foot": [3, 2], "width": "2 m", "height": "2 m"}, "rings": {"count": 1, "thickness": "0.3 m", "joint": "mesh"}}],
    "fill": [{"voronoi": {"size": 1, "graded": {"size": 0.8}, "relax": 2}, "joint": "grain", "region": [[4, 4], [6, 4], [6, 6], [4, 6]]}],
    "regions": [{"outline": [[0, 5], [1, 5], [1, 6], [0, 6]], "material": "dyke"}], "merge": {"area": 0.01, "angle": "5 deg"}}},
  "supports": [{"edge": "outside"}], "steps": [{"name": "in situ", "integrator": "static"}, {"name": "open", "remove": ["tunnel"], "duration": "0.1 s"}]})";

const std::vector<std::string>& corpus() {
  static const std::vector<std::string> scenes{blocks, waves, blocks,
                                               waves,  rock,  read_file(DDA_DOCS_DIR "/examples/p_bar_2m_thesis.json")};
  return scenes;
}

void collect(nlohmann::ordered_json& node, std::vector<nlohmann::ordered_json*>& nodes) {
  nodes.push_back(&node);
  for (auto& child : node)
    if (node.is_structured()) collect(child, nodes);
}

// Another value of the scene, of the same kind if one is soon found, or an odd one.
nlohmann::ordered_json other_than(const nlohmann::ordered_json& node, const std::vector<nlohmann::ordered_json*>& nodes,
                                  Mutator& mutator) {
  static const std::vector<nlohmann::ordered_json> numbers{0,      -1,    1,    2,    3,   1e5,
                                                           1e-320, 1e308, 1e-9, -1e9, 0.5, 1.0000001};
  static const std::vector<nlohmann::ordered_json> others{nullptr, true, "", "1 MPa", "5 deg", "default", {0, 0}};
  if (mutator.one_in(16)) return mutator.one_of(others);
  if (node.is_number() && mutator.one_in(2)) return mutator.one_of(numbers);
  if (node.is_number() && mutator.one_in(2)) return node.get<double>() * mutator.one_of(numbers).get<double>();
  const nlohmann::ordered_json* other = mutator.one_of(nodes);
  for (int tries = 0; tries < 20 && other->type() != node.type(); ++tries) other = mutator.one_of(nodes);
  return *other;
}

// The scene with one to three of its values exchanged or gone: text that is still JSON, more of which comes as far as
// the model.
std::string with_other_values(const std::string& text, Mutator& mutator) {
  auto scene = nlohmann::ordered_json::parse(text);
  for (std::size_t i = 1 + mutator.below(3); i > 0; --i) {
    std::vector<nlohmann::ordered_json*> nodes;
    collect(scene, nodes);
    nlohmann::ordered_json& node = *nodes[mutator.below(nodes.size())];
    if (!node.empty() && node.is_structured() && mutator.one_in(2))
      node.erase(std::next(node.begin(), static_cast<std::ptrdiff_t>(mutator.below(node.size()))));
    else if (&node != &scene)
      node = other_than(node, nodes, mutator);
  }
  return scene.dump();
}

void expect_can_be_stepped(const Model& model) {
  EXPECT_FALSE(model.blocks.empty());
  EXPECT_FALSE(model.stages.empty());
  for (const Block& block : model.blocks) {
    EXPECT_TRUE(std::isfinite(block.moments.area) && block.moments.area > 0) << block.name;
    EXPECT_TRUE(block.initial_stress.allFinite() && block.initial_velocity.allFinite()) << block.name;
  }
  for (std::size_t i = 0; i < model.blocks.size(); ++i) EXPECT_GT(model.mass_of(static_cast<int>(i)), 0);
  for (const Stage& stage : model.stages) {
    EXPECT_TRUE(std::isfinite(stage.dt) && stage.dt >= 0) << stage.name;
    EXPECT_TRUE(std::isfinite(stage.duration) && stage.duration >= 0) << stage.name;
  }
}

// A few words ask for millions of blocks, so what is allocated has no bound by the size of the text.
TEST(SceneFuzz, DamagedScenes) {
  const auto tally = fuzz({.inputs = 1500, .most_bytes = std::size_t{1} << 24}, [](Mutator& mutator) {
    const std::string& scene = mutator.one_of(corpus());
    expect_can_be_stepped(
        parse_scene(mutator.one_in(2) ? mutator.text(scene) : with_other_values(scene, mutator), "scene.json"));
  });
  expect_both(tally);
}

// All of them are scenes before they are damaged.
TEST(SceneFuzz, CorpusIsRead) {
  for (const std::string& scene : corpus()) EXPECT_NO_THROW(expect_can_be_stepped(parse_scene(scene, "scene.json")));
}

}  // namespace
}  // namespace dda
