// Supports, whole blocks, records and bolts as scenes write them.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <tuple>

#include "engine/core/error.h"
#include "engine/core/temporary_folder.h"
#include "engine/scene/bad_scene_test_support.h"

namespace dda {
namespace {

// A base 4 m wide, below a row of four blocks of 1 m by 2 m.
Model scene_with(const std::string& member, const std::filesystem::path& folder = {}) {
  return parse_scene(R"({"dda": 1, "materials": {"rock": {"density": 2500, "young": "40 GPa", "poisson": 0.25}},
    "blocks": [{"polygon": {"name": "base", "vertices": [[0, -1], [4, -1], [4, 0], [0, 0]]}},
               {"grid": {"name": "wall", "columns": 4, "rows": 1, "block_width": 1, "block_height": 2}}],
    "steps": {"dt": 0.01, "duration": 1}, )" +
                         member + "}",
                     "scene.json", folder);
}

class RecordFolder {
 public:
  RecordFolder() {
    std::filesystem::create_directories(folder_ / "records");
    std::ofstream(folder_ / "records" / "quake.csv") << "t,ax,ay [g]\n0,0,0\n0.5,0.2,0.1\n1,0,0\n";
  }
  [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

TEST(Scene, FixedBlocksAndGroups) {
  const Model model = scene_with(R"("fixed": ["base", "wall 1.2"])");
  ASSERT_EQ(model.held_blocks.size(), 2U);
  EXPECT_EQ(model.held_blocks[1].block, 2);
  EXPECT_TRUE(model.held_blocks[1].amplitude.isZero(0));
  EXPECT_EQ(scene_with(R"("fixed": ["wall"])").held_blocks.size(), 4U);
}

TEST(Scene, WholeBlocksMoveAndTurnAboutTheirCommonCentroid) {
  const Model model = scene_with(R"("supports": [{"block": "wall", "displacement": ["1 mm", 0], "rotation": "2 deg"},
                                                 {"block": "base", "velocity": [0, 0.5], "spin": 3, "about": [1, 2],
                                                  "history": {"sine": {"frequency": 2}}}])");
  ASSERT_EQ(model.held_blocks.size(), 5U);
  for (int i = 0; i < 4; ++i)
    EXPECT_LT((model.held_blocks[static_cast<std::size_t>(i)].about - Vec2(2, 1)).norm(), 1e-15);
  EXPECT_EQ(model.held_blocks[0].amplitude, Vec2(0.001, 0));
  EXPECT_DOUBLE_EQ(model.held_blocks[0].turn, 2 * std::numbers::pi / 180);
  EXPECT_EQ(model.held_blocks[4].kind, MotionKind::velocity);
  EXPECT_EQ(model.held_blocks[4].turn, 3);
  EXPECT_EQ(model.held_blocks[4].about, Vec2(1, 2));
  EXPECT_TRUE(std::holds_alternative<SineCycles>(model.held_blocks[4].history));
}

// Each component of a record moves the base by a support of its own, of a block or of a group.
TEST(Scene, SeveralMotionsOfABlockFollowEachOther) {
  const RecordFolder folder;
  const std::string record = R"("history": {"record": {"file": "records/quake.csv", "time": "t", "unit": "g", )";
  const Model model = scene_with(R"("supports": [{"block": "wall", "acceleration": [1, 0], )" + record +
                                     R"("value": "ax"}}}, {"block": "base", "spin": 0.1},
      {"block": "wall", "acceleration": [0, 1], )" +
                                     record + R"("value": "ay"}}}],
      "measurements": [{"name": "held", "quantity": "reaction"}])",
                                 folder.path());
  ASSERT_EQ(model.held_blocks.size(), 9U);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(model.held_blocks[i].block, model.held_blocks[i / 2 * 2].block);
    EXPECT_EQ(model.held_blocks[i].amplitude, i % 2 == 0 ? Vec2(1, 0) : Vec2(0, 1));
  }
  EXPECT_EQ(model.measurements[0].blocks, (std::vector<int>{0, 1, 2, 3, 4}));  // each once
}

TEST(Scene, ATurnMayStandAlone) {
  const Model model =
      scene_with(R"("supports": [{"block": "base", "rotation": "2 deg", "history": {"table": [[0, 0], [1, 1]]}}])");
  EXPECT_TRUE(std::holds_alternative<PiecewiseLinear>(model.held_blocks.at(0).history));
  EXPECT_EQ(model.held_blocks[0].kind, MotionKind::displacement);
}

TEST(Scene, RecordsAreReadBesideTheSceneAndShared) {
  const Model model = scene_with(R"("supports": [
      {"block": "base", "acceleration": [1, 0],
       "history": {"record": {"file": "records/quake.csv", "value": "ax", "unit": "g", "start": "2 s"}}},
      {"edge": "top", "hold": "x", "acceleration": ["1 g", 0],
       "history": {"record": {"file": "records/quake.csv", "value": "ax", "scale": 2}}}],
    "loads": [{"edge": "left", "pressure": "1 MPa", "block": "wall 1.1",
               "history": {"record": {"file": "records/quake.csv", "value": "ay", "unit": "-"}}}])",
                                 RecordFolder().path());
  const auto of_base = std::get<Recorded>(model.held_blocks.at(0).history);
  EXPECT_EQ(of_base.start, 2);
  EXPECT_DOUBLE_EQ(of_base.recording->peak(), 0.2 * 9.80665);
  EXPECT_EQ(of_base.recording->name(), "quake.csv");
  EXPECT_EQ(model.held_blocks[0].kind, MotionKind::acceleration);
  ASSERT_EQ(model.supports.size(), 8U);
  EXPECT_DOUBLE_EQ(model.supports[0].amplitude.x(), 9.80665);
  const auto first = std::get<Recorded>(model.supports[0].history);
  EXPECT_EQ(first.recording->peak(), 0.4);
  for (const PointSupport& support : model.supports)
    EXPECT_EQ(std::get<Recorded>(support.history).recording, first.recording);
  EXPECT_EQ(std::get<Recorded>(model.edge_loads.at(0).history).recording->peak(), 0.1);
}

TEST(Scene, RollersAcrossAnEdge) {
  const Model model = parse_scene(R"({"dda": 1, "materials": {"m": {"density": 1, "young": 1, "poisson": 0}},
    "blocks": {"polygon": {"vertices": [[0, 0], [4, 3], [0, 3]]}}, "steps": {"dt": 1, "duration": 1},
    "supports": [{"edge": {"from": [0, 0], "to": [4, 3]}, "hold": "normal"}]})",
                                  "scene.json");
  ASSERT_EQ(model.supports.size(), 2U);
  EXPECT_LT((model.supports[0].direction - Vec2(-0.6, 0.8)).norm(), 1e-15);
}

// Both ends across the edge, its middle along it: the block may strain along a clamped edge.
TEST(Scene, ClampedEdgeLeavesItsStrainFree) {
  const Model model = parse_scene(R"({"dda": 1, "materials": {"m": {"density": 1, "young": 1, "poisson": 0}},
    "blocks": {"polygon": {"vertices": [[0, 0], [4, 3], [0, 3]]}}, "steps": {"dt": 1, "duration": 1},
    "supports": [{"edge": {"from": [0, 0], "to": [4, 3]}, "stiffness": 8}]})",
                                  "scene.json");
  ASSERT_EQ(model.supports.size(), 3U);
  double across = 0;
  double along = 0;
  for (const PointSupport& support : model.supports) {
    across += support.stiffness * std::pow(support.direction.dot(Vec2(-0.6, 0.8)), 2);
    along += support.stiffness * std::pow(support.direction.dot(Vec2(0.8, 0.6)), 2);
  }
  EXPECT_NEAR(across, 8, 1e-14);
  EXPECT_NEAR(along, 8, 1e-14);
  EXPECT_EQ(model.supports[2].point, Vec2(2, 1.5));
  EXPECT_NEAR(std::abs(model.supports[2].direction.dot(Vec2(0.8, 0.6))), 1, 1e-15);
}

TEST(Scene, BoltAnchoredAcrossSeveralBlocks) {
  const Model model = scene_with(R"("bolts": [{"from": [0, 1], "to": [3.5, 1], "young": "200 GPa", "diameter": "20 mm",
      "pretension": "60 kN", "yield_force": "120 kN", "spacing": 2, "rupture_elongation": "5 cm"}])");
  const Bolt& bolt = model.bolts.at(0);
  EXPECT_EQ(bolt.name, "bolt 1");
  ASSERT_EQ(bolt.links.size(), 1U);
  EXPECT_EQ(bolt.links[0].block_a, 1);
  EXPECT_EQ(bolt.links[0].block_b, 4);
  EXPECT_DOUBLE_EQ(bolt.links[0].axial_stiffness, 200e9 * std::numbers::pi * 1e-4 / 3.5 / 2);
  EXPECT_EQ(bolt.pretension, 30e3);
  EXPECT_EQ(bolt.yield_force, 60e3);
  EXPECT_EQ(bolt.rupture_elongation, 0.05);
  EXPECT_TRUE(bolt.tension_only);
}

// An end on a joint is in the block that the bolt runs in.
TEST(Scene, AnchorOnAJoint) {
  const Model model = scene_with(R"("bolts": [{"from": [1, 1], "to": [3, 1.5], "stiffness": "1 MN/m"}])");
  EXPECT_EQ(model.bolts.at(0).links.at(0).block_a, 2);
  EXPECT_EQ(model.bolts[0].links[0].block_b, 3);
}

// Down through the wall from above into the base: a link at each joint, in order, with the length to the middles.
TEST(Scene, GroutedBoltHasALinkAtEveryJoint) {
  const Model model = scene_with(R"("bolts": [{"name": "b", "from": [2.25, 2], "to": [0.25, -0.5], "grouted": true,
      "young": 1e9, "diameter": 1, "shear_stiffness": 5, "spacing": 2}],
    "measurements": [{"quantity": "bolt_force", "bolt": "b"}, {"quantity": "bolt_shear", "bolt": "b", "point": [1, 0]}])");
  const std::vector<BoltLink>& links = model.bolts.at(0).links;
  ASSERT_EQ(links.size(), 3U);
  EXPECT_EQ(links[0].block_a, 3);
  EXPECT_EQ(links[0].block_b, 2);
  EXPECT_LT((links[0].point_a - Vec2(2, 2 - 0.25 * 1.25)).norm(), 1e-14);
  EXPECT_EQ(links[1].block_b, 1);
  EXPECT_LT((links[1].point_b - Vec2(1, 2 - 1.25 * 1.25)).norm(), 1e-14);
  EXPECT_EQ(links[2].block_a, 1);
  EXPECT_EQ(links[2].block_b, 0);
  EXPECT_LT((links[2].point_a - Vec2(0.65, 0)).norm(), 1e-14);
  const double length = std::hypot(2, 2.5);
  // 0.25 of the bolt's 2 m along x in the first block, 1 in the second: the middles are 0.625 of it apart.
  EXPECT_NEAR(links[0].axial_stiffness, 1e9 * std::numbers::pi / 4 / (length * 0.625 / 2) / 2, 1e-3);
  EXPECT_EQ(links[0].shear_stiffness, 2.5);
  // Drawn with each: to the ends, and half of what lies between two joints.
  const std::vector<double> before = {0.125, 0.25, 0.0875};
  const std::vector<double> behind = {0.25, 0.0875, 0.2};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(links[i].reach_a, before[i] * length, 1e-14) << i;
    EXPECT_NEAR(links[i].reach_b, behind[i] * length, 1e-14) << i;
  }
  EXPECT_EQ(model.measurements[0].link, -1);
  EXPECT_EQ(model.measurements[1].link, 2);
}

// Between two blocks there is a joint and no air: it acts where it goes from the upper block to the lower one.
TEST(Scene, GroutedBoltAlongAJoint) {
  const Model model = parse_scene(R"({"dda": 1, "materials": {"m": {"density": 1, "young": 1, "poisson": 0}},
    "blocks": [{"polygon": {"vertices": [[0, -1], [2, -1], [2, 0], [0, 0]]}},
               {"polygon": {"vertices": [[0, 0], [1, 0], [1, 1], [0, 1]]}},
               {"polygon": {"vertices": [[1, 0], [2, 0], [2, 1], [1, 1]]}},
               {"polygon": {"vertices": [[0, 1], [2, 1], [2, 2], [0, 2]]}}],
    "bolts": [{"from": [1, 1.5], "to": [1, -0.5], "grouted": true, "stiffness": 7}], "steps": {"dt": 1, "duration": 1}})",
                                  "scene.json");
  ASSERT_EQ(model.bolts.at(0).links.size(), 1U);
  EXPECT_EQ(model.bolts[0].links[0].block_a, 3);
  EXPECT_EQ(model.bolts[0].links[0].block_b, 0);
}

// A block with a hole, and another one 0.15 m away: a tenth of their sizes is 0.28 and 0.17 m.
std::string bolt_through_open_joints(double hole_width, const std::string& from, const std::string& to) {
  const std::string right = std::to_string(1 + hole_width);
  return R"({"dda": 1, "materials": {"m": {"density": 1, "young": 1, "poisson": 0}},
    "blocks": [{"polygon": {"vertices": [[0, 0], [4, 0], [4, 2], [0, 2]],
                            "holes": [[[1, 0.5], [)" +
         right + ", 0.5], [" + right + R"(, 1.5], [1, 1.5]]]}},
               {"polygon": {"vertices": [[4.15, 0], [5.65, 0], [5.65, 2], [4.15, 2]]}}],
    "bolts": [{"from": )" +
         from + R"(, "to": )" + to + R"(, "grouted": true, "stiffness": 7}], "steps": {"dt": 1, "duration": 1}})";
}

TEST(Scene, GroutedBoltThroughAHole) {
  const Model model = parse_scene(bolt_through_open_joints(0.2, "[0.5, 1]", "[5.5, 1]"), "scene.json");
  ASSERT_EQ(model.bolts.at(0).links.size(), 1U);  // none from the block to itself
  EXPECT_LT((model.bolts[0].links[0].point_a - Vec2(4, 1)).norm(), 1e-14);
  EXPECT_LT((model.bolts[0].links[0].point_b - Vec2(4.15, 1)).norm(), 1e-14);
}

// Steeper, the same gap is 0.25 m long; or it crosses the hole, starts at its wall or ends there.
TEST(Scene, GroutedBoltThroughAir) {
  for (const auto& [from, to, part] :
       {std::tuple("[3.85, 0.2]", "[4.45, 1]",
                   "bolts[0].grouted is true of a bolt that crosses 0.25 m of air, from "
                   "(4, 0.4) m to (4.15, 0.6) m, expected a bolt in rock"),
        std::tuple("[0.5, 1]", "[5.5, 1]", "0.4 m of air, from (1, 1) m to (1.4, 1) m"),
        std::tuple("[1.4, 0.7]", "[0.5, 0.7]", "0.4 m of air, from (1.4, 0.7) m to (1, 0.7) m"),
        std::tuple("[4.5, 1]", "[1, 1]", "0.4 m of air, from (1.4, 1) m to (1, 1) m")}) {
    std::string message;
    try {
      parse_scene(bolt_through_open_joints(0.4, from, to), "scene.json");
    } catch (const InputError& error) {
      message = error.what();
    }
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }
  // Anchored at its ends it may.
  std::string anchored = bolt_through_open_joints(0.4, "[3.85, 0.2]", "[4.45, 1]");
  anchored.replace(anchored.find("true"), 4, "false");
  EXPECT_EQ(parse_scene(anchored, "scene.json").bolts.at(0).links.size(), 1U);
}

// On a shared side an anchor is in the block that the bolt runs into: who wanted the other one is told.
TEST(Scene, BoltAnchoredWhereBlocksMeet) {
  try {
    parse_scene(R"({"dda": 1, "materials": {"m": {"density": 1, "young": 1, "poisson": 0}},
      "blocks": [{"polygon": {"name": "floor", "vertices": [[0, -1], [2, -1], [2, 0], [0, 0]]}},
                 {"polygon": {"name": "wall", "vertices": [[0, 0], [2, 0], [2, 2], [0, 2]]}}],
      "bolts": [{"from": [1, 0], "to": [1, 1], "stiffness": 7}], "steps": {"dt": 1, "duration": 1}})",
                "scene.json");
    FAIL() << "read";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "scene.json: bolts[0].to is [1,1], expected a point in another block than from, \"wall\"; from lies "
                 "where blocks meet (\"floor\", \"wall\"), and is taken to be in the one that the bolt runs into");
  }
}

struct BadPart {
  std::string what;
  std::string member;
  std::vector<std::string> sentence;
};

void PrintTo(const BadPart& part, std::ostream* out) { *out << part.what; }

class BadSupport : public testing::TestWithParam<BadPart> {};

TEST_P(BadSupport, GivesOneSentence) {
  try {
    scene_with(GetParam().member, RecordFolder().path());
    FAIL() << "accepted";
  } catch (const InputError& error) {
    expect_sentence(error.what(), {"scene.json: ", " is ", ", expected "});
    expect_sentence(error.what(), GetParam().sentence);
  }
}

std::string support(const std::string& text) { return R"("supports": [{)" + text + "}]"; }
std::string bolt(const std::string& text) { return R"("bolts": [{)" + text + "}]"; }
std::string record(const std::string& text) {
  return support(R"("block": "base", "acceleration": [1, 0], "history": {"record": {"file": "records/quake.csv", )" +
                 text + "}}");
}

const std::vector<BadPart> bad_parts = {
    {"unknown fixed block",
     R"("fixed": ["bse"])",
     {"fixed[0] is \"bse\"", "one of \"base\", \"wall\", \"wall 1.1\"", "perhaps \"base\""}},
    {"fixed twice", R"("fixed": ["base", "base"])", {"fixed[1] is \"base\"", "not held already"}},
    {"fixed and moved", R"("fixed": ["wall"], )" + support(R"("block": "wall 1.1")"), {"supports[0].block", "already"}},
    {"turned twice",
     R"("supports": [{"block": "base", "spin": 1}, {"block": "base", "rotation": 1}])",
     {"supports[1].block is \"base\"", "not held already", "one at most to turn it"}},
    {"no place", support(R"("displacement": [1, 0])"), {"supports[0] is without a place"}},
    {"two motions",
     support(R"("block": "base", "displacement": [1, 0], "velocity": [1, 0])"),
     {"supports[0].velocity", "left out beside displacement"}},
    {"history of nothing",
     support(R"("block": "base", "history": {"sine": {"frequency": 1}})"),
     {"supports[0].history", "no motion"}},
    {"history of no point motion",
     support(R"("point": [0, -1], "history": {"sine": {"frequency": 1}})"),
     {"supports[0].history", "no motion"}},
    {"soft block", support(R"("block": "base", "stiffness": 1e9)"), {"supports[0].stiffness", "held exactly"}},
    {"half held block", support(R"("block": "base", "hold": "x")"), {"supports[0].hold", "held exactly"}},
    {"turning point", support(R"("point": [0, -1], "rotation": 1)"), {"supports[0].rotation", "do not turn"}},
    {"turn of two kinds",
     support(R"("block": "base", "rotation": 1, "spin": 1)"),
     {"supports[0].spin", "beside rotation"}},
    {"turn with a velocity",
     support(R"("block": "base", "rotation": 1, "velocity": [1, 0])"),
     {"supports[0].velocity", "beside rotation"}},
    {"about nothing", support(R"("block": "base", "about": [0, 0])"), {"supports[0].about", "without rotation"}},
    {"normal of a point", support(R"("point": [0, -1], "hold": "normal")"), {"supports[0].hold", "no normal"}},
    {"unit of a velocity",
     support(R"("block": "base", "velocity": ["1 m/s2", 0])"),
     {"supports[0].velocity[0] is \"1 m/s2\"", "velocity"}},
    {"no such record",
     support(R"("block": "base", "acceleration": [1, 0], "history": {"record": {"file": "quake.csv"}})"),
     {"supports[0].history.record.file: quake.csv is missing", "CSV"}},
    {"record without a column", record(R"("value": "az")"), {"quake.csv line 1", "\"ax\"", "a column \"az\""}},
    {"record with a choice", record(R"("start": 1)"), {"quake.csv line 1", "\"value\" in the scene"}},
    {"record in an unknown unit",
     record(R"("value": "ax", "unit": "gal")"),
     {"record.unit is \"gal\"", "acceleration"}},
    {"record with two units", record(R"("value": "ay", "unit": "m/s2")"), {"column \"ay\"", "\"g\"", "\"m/s2\""}},
    {"baseline of a load",
     R"("loads": [{"point": [0, -1], "force": [1, 0], "history": {"record": {"file": "records/quake.csv",
        "value": "ax", "baseline_correction": true}}}])",
     {"baseline_correction", "no acceleration"}},
    {"g as a force",
     R"("loads": [{"point": [0, -1], "force": [1, 0], "history": {"record": {"file": "records/quake.csv",
        "value": "ay"}}}])",
     {"column \"ay\"", "\"g\"", "a unit of force"}},
    {"bolt from nowhere",
     bolt(R"("from": [-1, 1], "to": [1.5, 1], "stiffness": 1)"),
     {"bolts[0].from is (-1, 1) m and outside all blocks", "the blocks reach"}},
    {"bolt to nowhere", bolt(R"("from": [1.5, 1], "to": [9, 1], "stiffness": 1)"), {"bolts[0].to is (9, 1) m"}},
    {"bolt without length", bolt(R"("from": [1.5, 1], "to": [1.5, 1], "stiffness": 1)"), {"bolts[0].to"}},
    {"bolt in one block",
     bolt(R"("from": [1.2, 1], "to": [1.8, 1], "stiffness": 1)"),
     {"bolts[0].to", "another block than from, \"wall 1.2\""}},
    {"grouted in one block",
     bolt(R"("from": [1.2, 1], "to": [1.8, 1], "stiffness": 1, "grouted": true)"),
     {"bolts[0].to", "beyond a joint"}},
    {"grouted along a joint",
     bolt(R"("from": [1, 0.2], "to": [1, 1.8], "stiffness": 1, "grouted": true)"),
     {"bolts[0].to", "beyond a joint"}},
    {"bolt without stiffness", bolt(R"("from": [0.5, 1], "to": [1.5, 1])"), {"bolts[0].stiffness is missing"}},
    {"bolt without diameter",
     bolt(R"("from": [0.5, 1], "to": [1.5, 1], "young": 1e9)"),
     {"bolts[0].diameter is missing"}},
    {"two stiffnesses",
     bolt(R"("from": [0.5, 1], "to": [1.5, 1], "young": 1e9, "diameter": 1, "stiffness": 1)"),
     {"bolts[0].young", "left out beside stiffness"}},
    {"pulled beyond yield",
     bolt(R"("from": [0.5, 1], "to": [1.5, 1], "stiffness": 1, "pretension": "2 kN", "yield_force": "1 kN")"),
     {"bolts[0].pretension is \"2 kN\"", "at most yield_force"}},
    {"dowel without grout",
     bolt(R"("from": [0.5, 1], "to": [1.5, 1], "stiffness": 1, "shear_stiffness": 1)"),
     {"bolts[0].shear_stiffness", "not grouted"}},
    {"negative pretension",
     bolt(R"("from": [0.5, 1], "to": [1.5, 1], "stiffness": 1, "pretension": "-2 kN")"),
     {"bolts[0].pretension"}},
    {"two bolts of a name",
     R"("bolts": [{"name": "b", "from": [0.5, 1], "to": [1.5, 1], "stiffness": 1},
                  {"name": "b", "from": [0.5, 1], "to": [1.5, 1], "stiffness": 1}])",
     {"bolts[1].name is \"b\""}},
    {"measured far from it",
     R"("bolts": [{"name": "b", "from": [0.5, 1], "to": [1.5, 1], "stiffness": 1}],
        "measurements": [{"quantity": "bolt_force", "bolt": "b", "point": [1, 2.5]}])",
     {"measurements[0].point is (1, 2.5) m, 1.5 m away from bolt \"b\"", "no further off than its longest piece, 1 m"}},
    {"measured bolt",
     R"("measurements": [{"quantity": "bolt_force", "bolt": "b"}])",
     {"measurements[0].bolt is \"b\""}},
    {"bolt of a stress",
     R"("measurements": [{"quantity": "stress_xx", "block": "base", "bolt": "b"}])",
     {"measurements[0].bolt", "left out"}},
};

INSTANTIATE_TEST_SUITE_P(Scene, BadSupport, testing::ValuesIn(bad_parts));

}  // namespace
}  // namespace dda
