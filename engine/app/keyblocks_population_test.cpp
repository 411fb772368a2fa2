// Block theory against runs: random rocks with an opening, each block with a free face let go while all others are
// held, as the theory assumes. What a run does in 20 ms is compared with the motion foretold.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/geometry/box.h"
#include "engine/geometry/cut_pieces.h"
#include "engine/geometry/segment.h"
#include "engine/keyblocks/key_blocks.h"
#include "engine/scene/scene_parts.h"
#include "engine/simulation/simulation.h"

namespace dda {
namespace {

constexpr double standard_gravity = 9.81;  // m/s2
constexpr double duration = 0.02;          // s
constexpr double dt = 5e-4;                // s

nlohmann::json random_set(SeededNumbers& random, const std::string& joint) {
  const double spacing = random.number(0.8, 3);
  nlohmann::json set = {{"dip",
                         {{"mean", fmt::format("{:.2f} deg", random.number(0, 180))},
                          {"deviation", fmt::format("{:.2f} deg", random.number(0, 8))}}},
                        {"spacing", {{"mean", spacing}, {"deviation", 0.3 * spacing}}},
                        {"joint", joint}};
  if (random.chance(0.4)) {
    set["trace_length"] = random.number(2, 6);
    set["persistence"] = random.number(0.6, 0.95);
  }
  return set;
}

nlohmann::json random_opening(SeededNumbers& random) {
  nlohmann::json opening = {{"name", "tunnel"}, {"left_out", random.chance(0.5)}};
  const nlohmann::json foot = {random.number(-1, 1), random.number(-2, 0)};
  const double width = random.number(2, 5);
  const std::string shape = random.one_of(std::array<std::string, 3>{"rectangle", "horseshoe", "circle"});
  if (shape == "circle")
    opening["circle"] = {{"centre", foot}, {"radius", width / 2}};
  else
    opening[shape] = {{"foot", foot}, {"width", width}, {"height", random.number(0.8, 1.3) * width}};
  return opening;
}

// Blocks are so stiff that what they give way by is nothing beside what they move; smooth to rough joints, some with
// cohesion, which sliding does not break: block theory knows no brittle joints.
std::string random_rock(int seed) {
  SeededNumbers random(static_cast<std::uint64_t>(seed));
  const auto joint = [&random] {
    const double cohesion = random.chance(0.2) ? random.number(0, 2e4) : 0.0;
    return nlohmann::json{{"friction_angle", fmt::format("{:.2f} deg", random.number(0, 65))},
                          {"cohesion", cohesion},
                          {"residual_cohesion", cohesion}};
  };
  nlohmann::json sets = {random_set(random, "first"), random_set(random, "second")};
  if (random.chance(0.4)) sets.push_back(random_set(random, "first"));
  const nlohmann::json rock = {{"boundary", {{-8, -7}, {8, -7}, {8, 7}, {-8, 7}}},
                               {"joint_sets", sets},
                               {"openings", {random_opening(random)}},
                               {"seed", seed}};
  const nlohmann::json scene = {
      {"dda", 1},
      {"materials", {{"rock", {{"density", 2600}, {"young", 1e13}, {"poisson", 0.2}}}}},
      {"joints", {{"default", joint()}, {"first", joint()}, {"second", joint()}}},
      {"blocks", {{"rock", rock}}},
      {"supports", {{{"edge", "bottom"}}, {{"edge", "left"}}, {{"edge", "right"}}, {{"edge", "top"}}}},
      {"gravity", standard_gravity},
      {"steps", {{"dt", dt}, {"duration", duration}}}};
  return scene.dump();
}

// The body with all blocks near it, which are held.
Model let_go(const Model& rock, const KeyBlockQuestion& question, const RockBody& body) {
  Model model = rock;
  model.blocks.clear();
  model.supports.clear();
  Box near;
  for (const int block : body.blocks) {
    const Box own = bounding_box(rock.blocks[static_cast<std::size_t>(block)].shape);
    near = expanded(expanded(near, own.lower), own.upper);
  }
  for (const int block : body.blocks) model.blocks.push_back(rock.blocks[static_cast<std::size_t>(block)]);
  for (int block = 0; block < static_cast<int>(rock.blocks.size()); ++block) {
    const auto index = static_cast<std::size_t>(block);
    const bool is_of_body = std::ranges::find(body.blocks, block) != body.blocks.end();
    if (is_of_body || question.is_void[index] || !overlap(expanded(near, 0.05), bounding_box(rock.blocks[index].shape)))
      continue;
    HeldBlock held;
    held.block = static_cast<int>(model.blocks.size());
    model.held_blocks.push_back(held);
    model.blocks.push_back(rock.blocks[index]);
  }
  finish_model(model);
  return model;
}

struct Measured {
  std::string failure;               // why the run did not end; empty when it did
  Vec2 acceleration = Vec2::Zero();  // m/s2, mean: 2 u/t^2
  double turn = 0;                   // rad/s2, the same
};

Measured run(Model model) {
  Simulation simulation(std::move(model));
  while (!simulation.finished()) {
    if (simulation.step() != Status::ok) return {simulation.message()};
  }
  const double factor = 2 / (duration * duration);
  const Vec6& moved = simulation.state().displacement[0];
  return {{}, factor * moved.head<2>(), factor * moved[2]};
}

// m/s2, of a body that does not turn.
Vec2 foretold(const KeyBlock& block) {
  const FirstMotion& motion = block.motion;
  if (block.type != BlockType::key) return Vec2::Zero();
  return (motion.drive - motion.resistance) / block.body.mass * motion.direction;
}

constexpr double path = standard_gravity * duration * duration / 2;  // m, of a free fall

std::vector<Segment> edges_of(const Ring& ring) {
  std::vector<Segment> edges;
  for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
  return edges;
}

double distance(const Ring& a, const Ring& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const Segment& one : edges_of(a)) {
    for (const Segment& other : edges_of(b)) least = std::min(least, dda::distance(one, other));
  }
  return least;
}

// Rock that meets the body in a corner alone, or nearly touches it: block theory does not see it, the run does.
bool has_rock_in_its_way(const Model& rock, const KeyBlockQuestion& question, const RockBody& body) {
  for (int other = 0; other < static_cast<int>(rock.blocks.size()); ++other) {
    const auto index = static_cast<std::size_t>(other);
    const bool is_neighbour =
        std::ranges::any_of(body.joints, [&](const JointFace& face) { return face.neighbour == other; }) ||
        std::ranges::find(body.blocks, other) != body.blocks.end();
    if (is_neighbour || question.is_void[index]) continue;
    for (const int block : body.blocks) {
      const Ring& own = rock.blocks[static_cast<std::size_t>(block)].shape.outer;
      if (distance(own, rock.blocks[index].shape.outer) < path) return true;
    }
  }
  return false;
}

// Counts of what came out, by what was foretold.
const std::string not_ended = "run did not end";

struct Tally {
  std::map<std::string, int> counts;
  std::vector<std::string> unexplained;

  void add(const std::string& what) { ++counts[what]; }
};

constexpr double agreement = 0.02;  // of g: friction while the first contacts close, and the path of 2 mm

// A body is to move by no more than a tenth of its size, or it leaves its faces within the run.
bool is_too_small(const RockBody& body) { return std::sqrt(body.area) < 10 * path; }

void judge_body(const SceneParts& scene, const KeyBlockQuestion& question, const KeyBlock& block, int seed,
                Tally& tally) {
  tally.add("all");
  if (is_too_small(block.body)) return tally.add("too small for the run");
  const Measured measured = run(let_go(scene.model, question, block.body));
  const std::string kind = fmt::format("{} {}", numeral(block.type), to_string(block.motion.mode));
  const Vec2 expected = foretold(block);
  const double error = (measured.acceleration - expected).norm() / standard_gravity;
  const double turned = std::abs(measured.turn) * std::sqrt(block.body.area) / standard_gravity;
  tally.add(kind);
  if (!measured.failure.empty())
    tally.add(not_ended);
  else if (error < agreement)
    tally.add(block.turns ? "agrees, though foretold to turn" : "agrees");
  else if (block.turns && turned > agreement)
    tally.add("differs, turns as foretold");
  else if (has_rock_in_its_way(scene.model, question, block.body))
    tally.add("differs, rock beyond a corner or a gap");
  else {
    tally.add("differs");
    const bool cohesive =
        std::ranges::any_of(block.body.joints, [](const JointFace& face) { return face.cohesion_force > 0; });
    tally.unexplained.push_back(fmt::format(
        "seed {} {} {}{}: fos {:.4g}, foretold ({:.4f}, {:.4f}), measured ({:.4f}, {:.4f}) turn {:.4f}, area "
        "{:.3g}, {} faces",
        seed, name_of(block.body, scene.model), kind, cohesive ? " (with cohesion)" : "", block.motion.factor_of_safety,
        expected.x(), expected.y(), measured.acceleration.x(), measured.acceleration.y(), measured.turn,
        block.body.area, block.body.joints.size()));
  }
}

Tally population(int first, int last) {
  Tally tally;
  for (int seed = first; seed < last; ++seed) {
    SceneParts scene;
    try {
      scene = parse_scene_parts(random_rock(seed), fmt::format("rock {}", seed));
    } catch (const std::exception& error) {
      tally.add("scene refused");
      tally.unexplained.push_back(error.what());
      continue;
    }
    KeyBlockQuestion question;
    for (const std::string& group : scene.groups) question.is_void.push_back(group == "tunnel");
    for (const KeyBlock& block : key_blocks(scene.model, question).blocks)
      judge_body(scene, question, block, seed, tally);
  }
  for (const auto& [what, count] : tally.counts) fmt::print("{:>6}  {}\n", count, what);
  for (const std::string& what : tally.unexplained) fmt::print("{}\n", what);
  return tally;
}

// Runs that do not end compare nothing: none of those on a thousand rocks; 0.26 % disagree
// (engine/keyblocks/README.md).
void expect_agreement(int first, int last, double most_unexplained) {
  Tally tally = population(first, last);
  EXPECT_LE(static_cast<double>(tally.unexplained.size()), most_unexplained * tally.counts["all"]);
  EXPECT_LE(tally.counts[not_ended], tally.counts["all"] / 50);
  EXPECT_GE(tally.counts["agrees"], tally.counts["all"] * 9 / 10);
}

// One of them is held for two steps by friction between its two faces, as it could be, before it slides.
TEST(KeyBlocksPopulation, RunsDoWhatIsForetold) { expect_agreement(1, 101, 0.003); }

TEST(KeyBlocksPopulation, DISABLED_AThousandRocks) { expect_agreement(1000, 2000, 0.003); }

}  // namespace
}  // namespace dda
