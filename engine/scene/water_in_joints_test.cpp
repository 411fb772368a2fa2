// Pressure of water in joints: on both of their faces, by a water table, in the stages in which both blocks are there.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/geometry/cut_pieces.h"
#include "engine/scene/scene.h"

namespace dda {
namespace {

constexpr double gradient = 9810;  // Pa/m

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }
double length_of(const EdgeLoad& load) { return (load.to - load.from).norm(); }

// Four-sided rock of 10 to 20 m cut by two joint sets.
std::string rock(SeededNumbers& random) {
  const auto corner = [&](double x, double y) {
    return fmt::format("[{:.3f}, {:.3f}]", x + random.number(-4, 4), y + random.number(-4, 4));
  };
  const auto set = [&](double dip) {
    return fmt::format(R"({{"dip": "{:.2f} deg", "spacing": {:.3f}, "joint": "set"}})", dip + random.number(-30, 30),
                       random.number(2, 5));
  };
  return fmt::format(R"({{"rock": {{"name": "rock", "boundary": [{}, {}, {}, {}], "joint_sets": [{}, {}]}}}})",
                     corner(-8, -8), corner(8, -8), corner(8, 8), corner(-8, 8), set(0), set(90));
}

const std::string dry = R"("friction_angle": "30 deg")";

Model wet(const std::string& blocks, const std::string& loads, const std::string& steps,
          const std::string& joint = dry) {
  const bool is_cut = blocks.find("joint_sets") != std::string::npos;
  const std::string set = is_cut ? R"(, "set": {"friction_angle": "20 deg"})" : "";
  return parse_scene(R"({"dda": 1, "materials": {"rock": {"density": 2650, "young": 5e10, "poisson": 0.25}},
    "joints": {"default": {)" +
                         joint + "}" + set + R"(}, "blocks": )" + blocks + R"(, "loads": )" + loads + R"(, "steps": )" +
                         steps + "}",
                     "scene.json");
}

const std::string settle = R"({"integrator": "static"})";

struct Pull {
  Vec2 force = Vec2::Zero();  // N per m of thickness
  double moment = 0;          // N about the centroid
  double largest = 0;         // of the forces on single stretches
};

Pull pull_on(int block, const Model& model) {
  const Vec2 centroid = model.blocks[static_cast<std::size_t>(block)].moments.centroid;
  Pull pull;
  for (const EdgeLoad& load : model.edge_loads) {
    if (load.block != block) continue;
    const Vec2 force = length_of(load) * load.traction;
    pull.force += force;
    pull.moment += cross((load.from + load.to) / 2 - centroid, force) +
                   cross(load.to - load.from, length_of(load) * load.rise) / 6;
    pull.largest = std::max(pull.largest, force.norm());
  }
  return pull;
}

TEST(WaterInJoints, LiftsEveryBlockByTheWaterInItsPlace) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SeededNumbers random(seed);
    const std::string pressure = R"("pressure": {"surface": 15, "gradient": 9810})";
    const Model model = wet(
        rock(random), R"([{"edge": "joints", )" + pressure + R"(}, {"edge": "outside", )" + pressure + "}]", settle);
    ASSERT_GT(model.blocks.size(), 4U) << "seed " << seed;
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
      const Pull pull = pull_on(static_cast<int>(i), model);
      const double round_off = 1e-9 * pull.largest;  // corners of neighbours are the same to their last digits
      EXPECT_NEAR(pull.force.x(), 0, round_off) << "seed " << seed << ", block " << i;
      EXPECT_NEAR(pull.force.y(), gradient * model.blocks[i].moments.area, round_off) << "seed " << seed;
      EXPECT_NEAR(pull.moment, 0, 10 * round_off) << "seed " << seed << ", block " << i;
    }
  }
}

// The table in words of its own.
double depth_below_table(const Vec2& place) {
  const double x = std::clamp(place.x(), -5.0, 6.0);
  const double level = x < 1 ? 4 - (x + 5) * 0.5 : 1 - (x - 1) * 0.6;
  return std::max(0.0, level - place.y());
}

TEST(WaterInJoints, PressesBothFacesByTheDepthBelowTheWaterTable) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SeededNumbers random(seed);
    const Model model =
        wet(rock(random),
            R"([{"edge": "joints", "pressure": {"surface": [[-5, 4], [1, 1], [6, -2]], "gradient": "9.81 kPa/m"}}])",
            settle);
    Vec2 all = Vec2::Zero();
    double wetted = 0;
    for (const EdgeLoad& load : model.edge_loads) {
      all += length_of(load) * load.traction;
      wetted += length_of(load);
      const Vec2 along = (load.to - load.from).normalized();
      const Vec2 inward(-along.y(), along.x());
      for (const double share : {0.0, 0.25, 0.5, 1.0}) {
        const Vec2 own = load.traction + (2 * share - 1) * load.rise;
        const double pressure = gradient * depth_below_table(load.from + share * (load.to - load.from));
        EXPECT_NEAR((own - pressure * inward).norm(), 0, 1e-6) << "seed " << seed;
      }
    }
    EXPECT_GT(wetted, 20) << "seed " << seed;
    EXPECT_NEAR(all.norm(), 0, 1e-6) << "seed " << seed;
  }
}

const std::string three_boxes = R"([{"polygon": {"name": "left", "vertices": [[0, 0], [1, 0], [1, 1], [0, 1]]}},
  {"polygon": {"name": "key", "vertices": [[1, 0], [2, 0], [2, 1], [1, 1]]}},
  {"polygon": {"name": "right", "vertices": [[2, 0], [3, 0], [3, 1], [2, 1]]}},
  {"polygon": {"name": "floor", "vertices": [[0, -1], [3, -1], [3, 0], [0, 0]]}}])";

struct Span {
  int first, last;
  bool operator==(const Span&) const = default;
};

std::vector<Span> spans_on(const std::string& name, const Model& model) {
  std::vector<Span> spans;
  for (const EdgeLoad& load : model.edge_loads)
    if (model.blocks[static_cast<std::size_t>(load.block)].name == name)
      spans.push_back({load.stages.first, load.stages.last});
  std::ranges::sort(spans, {}, [](const Span& span) { return std::pair(span.first, span.last); });
  return spans;
}

std::string stages_that(const std::string& change, const std::string& change_back) {
  return R"([{"name": "in situ", "integrator": "static"}, {"name": "dug", "integrator": "static", )" + change +
         R"(}, {"name": "filled", "integrator": "static")" + change_back +
         R"(}, {"name": "end", "integrator": "static"}])";
}

TEST(WaterInJoints, ActsWhileBothBlocksAreThere) {
  const std::string steps = stages_that(R"("remove": ["key"])", R"(, "add": ["key"])");
  const std::string always = R"([{"edge": "joints", "pressure": "1 kPa"}])";
  const Model model = wet(three_boxes, always, steps);
  EXPECT_EQ(spans_on("left", model), (std::vector<Span>{{0, -1}, {0, 0}}));
  EXPECT_EQ(spans_on("key", model), (std::vector<Span>{{0, 0}, {0, 0}, {0, 0}}));
  const Model laid = wet(three_boxes, always, stages_that(R"("add": ["key"])", ""));
  EXPECT_EQ(spans_on("left", laid), (std::vector<Span>{{0, -1}, {1, -1}}));
  EXPECT_EQ(spans_on("key", laid), (std::vector<Span>{{1, -1}, {1, -1}, {1, -1}}));
  const std::string rain = R"([{"edge": "joints", "pressure": "1 kPa", "from_stage": "dug", "until_stage": "filled"}])";
  EXPECT_EQ(spans_on("left", wet(three_boxes, rain, steps)), (std::vector<Span>{{1, 2}}));
  EXPECT_EQ(spans_on("key", wet(three_boxes, rain, steps)), (std::vector<Span>{}));
  EXPECT_EQ(
      spans_on("left", wet(three_boxes, rain, stages_that(R"("kinematics": "finite")", R"(, "remove": ["key"])"))),
      (std::vector<Span>{{1, 1}, {1, 2}}));
}

std::string refusal_of(const std::string& blocks, const std::string& loads, const std::string& joint = dry) {
  try {
    (void)wet(blocks, loads, settle, joint);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(WaterInJoints, IsOfTheJointsAndBlocksThatAreNamed) {
  SeededNumbers random(3);
  const std::string cut = rock(random);
  const auto loads = [](const std::string& edge, const std::string& more = "") {
    return R"([{"edge": )" + edge + R"(, "pressure": "1 kPa")" + more + "}]";
  };
  const std::size_t all = wet(cut, loads(R"("joints")"), settle).edge_loads.size();
  EXPECT_GT(all, 10U);
  EXPECT_EQ(wet(cut, loads(R"({"joints": ["set"]})"), settle).edge_loads.size(), all);
  EXPECT_EQ(wet(three_boxes, loads(R"("joints")", R"(, "block": "left")"), settle).edge_loads.size(), 2U);
  const std::string bonded = refusal_of(three_boxes, loads(R"("joints")"), R"("bonded": true)");
  EXPECT_NE(bonded.find("which can open"), std::string::npos) << bonded;
  const std::vector<std::pair<std::string, std::string>> refusals = {
      {loads(R"({"joints": ["default"]})"), "joints along which blocks touch in these stages"},
      {loads(R"({"joints": ["sett"]})"), "(perhaps \"set\")"},
      {loads(R"({"joints": []})"), "loads[0].edge.joints"},
      {loads(R"({"joints": ["set"], "from": [0, 0]})"), "beside joints"},
      {loads(R"("joints")", R"(, "block": "nobody")"), "loads[0].block"},
      {R"([{"edge": "joints", "traction": [1, 0]}])", "in joints, which take a pressure"},
      {R"([{"edge": "joints", "pressure": {"surface": [[0, 1], [0, 2]], "gradient": 1}}])", "further to the right"},
      {R"([{"edge": "joints", "pressure": {"surface": [[0, 1]], "gradient": 1}}])", "surface"},
      {R"([{"edge": "joints", "pressure": {"surface": -99, "gradient": 1}}])", "nowhere on the edge above 0"}};
  for (const auto& [load, part] : refusals)
    EXPECT_NE(refusal_of(cut, load).find(part), std::string::npos) << load << refusal_of(cut, load);
}

}  // namespace
}  // namespace dda
