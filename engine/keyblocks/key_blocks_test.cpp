// Bodies and their faces from models, and what is reported of them.
#include "engine/keyblocks/key_blocks.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/keyblocks/keyblocks_test_support.h"
#include "engine/keyblocks/resultants.h"

namespace dda {
namespace {

constexpr double density = 2500;  // kg/m3
constexpr double gravity = 10;    // m/s2

Ring box(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

Model rock_of(const std::vector<Ring>& outlines) {
  Model model;
  model.materials = {{"rock", density, 1e10, 0.2, PlaneState::stress}};
  model.joints.resize(2);
  model.joints[0].name = "default";
  model.joints[0].friction_angle = 30 * degree;
  model.joints[1].name = "glue";
  model.joints[1].bonded = true;
  for (const Ring& outline : outlines) {
    Block& block = model.blocks.emplace_back();
    block.name = "block " + std::to_string(model.blocks.size());
    block.shape.outer = outline;
  }
  model.gravity = {0, -gravity};
  model.stages.resize(1);
  model.stages[0].dt = model.stages[0].duration = 1;
  return model;
}

KeyBlockReport judge(Model& model, KeyBlockQuestion question = {}) {
  finish_model(model);
  if (question.is_void.empty()) question.is_void.assign(model.blocks.size(), false);
  return key_blocks(model, question);
}

// A row of three: the first is held, the others rest on a floor that is held.
Model row() {
  Model model = rock_of({box(0, 0, 1, 1), box(1, 0, 2, 1), box(2, 0, 3, 1), box(0, -1, 3, 0)});
  for (const int block : {0, 3}) {
    HeldBlock held;
    held.block = block;
    model.held_blocks.push_back(held);
  }
  return model;
}

TEST(RockBodies, FacesOfARow) {
  Model model = row();
  finish_model(model);
  const std::vector<RockBody> bodies = rock_bodies(model, std::vector<bool>(4, false));
  ASSERT_EQ(bodies.size(), 4U);
  EXPECT_TRUE(bodies[0].surroundings);
  EXPECT_FALSE(bodies[1].surroundings);
  EXPECT_EQ(bodies[1].joints.size(), 3U);
  ASSERT_EQ(bodies[1].free_faces.size(), 1U);
  EXPECT_EQ(bodies[1].free_faces[0].outward, Vec2(0, 1));
  for (const JointFace& face : bodies[1].joints) {
    // Out of the body: away from its centroid.
    EXPECT_GT(face.outward.dot((face.from + face.to) / 2 - bodies[1].centroid), 0);
    EXPECT_EQ(face.block, 1);
  }
  // The row on the floor covers 3 m of its top.
  double free = 0;
  for (const FreeFace& face : bodies[3].free_faces) free += face.length();
  EXPECT_DOUBLE_EQ(free, 8 - 3);
}

TEST(RockBodies, WhatIsTakenOutLeavesFreeFaces) {
  Model model = row();
  finish_model(model);
  const std::vector<RockBody> bodies = rock_bodies(model, {false, false, true, false});
  ASSERT_EQ(bodies.size(), 3U);
  EXPECT_EQ(bodies[1].joints.size(), 2U);
  EXPECT_EQ(bodies[1].free_faces.size(), 2U);
}

// A neighbour that covers part of an edge leaves the rest of it free.
TEST(RockBodies, PartOfAnEdgeIsFree) {
  Model model = rock_of({box(0, 0, 4, 1), box(1, 1, 2.5, 2)});
  finish_model(model);
  const std::vector<RockBody> bodies = rock_bodies(model, {false, false});
  double free = 0;
  for (const FreeFace& face : bodies[0].free_faces) free += face.outward == Vec2(0, 1) ? face.length() : 0;
  EXPECT_DOUBLE_EQ(free, 2.5);
  EXPECT_EQ(bodies[0].free_faces.size(), 5U);
}

TEST(RockBodies, BondedBlocksAreOne) {
  Model model = row();
  model.joint_lines = {{{2, 0}, {2, 1}, 1}};
  const KeyBlockReport report = judge(model);
  ASSERT_EQ(report.blocks.size(), 1U);
  const RockBody& body = report.blocks[0].body;
  EXPECT_EQ(name_of(body, model), "block 2 + block 3");
  EXPECT_EQ(body.joints.size(), 3U);
  EXPECT_DOUBLE_EQ(body.area, 2);
  EXPECT_EQ(body.centroid, Vec2(2, 0.5));
  // Glued to what is held, it is held.
  model.joint_lines = {{{1, 0}, {1, 1}, 1}};
  const KeyBlockReport glued = judge(model);
  ASSERT_EQ(glued.blocks.size(), 1U);
  EXPECT_EQ(name_of(glued.blocks[0].body, model), "block 3");
}

TEST(RockBodies, SupportsAndAbsorbingEdgesMakeSurroundings) {
  Model model = row();
  PointSupport support;
  support.block = 1;
  support.point = {1.5, 1};
  support.stiffness = 1e9;
  model.supports = {support};
  EXPECT_EQ(judge(model).surroundings, 3);
  // A spring from point to point of the same block holds it nowhere.
  model.supports[0].partner = Vec2(1.5, 0);
  EXPECT_EQ(judge(model).surroundings, 2);
}

TEST(KeyBlocks, WeightLoadsShakingAndBoltsAct) {
  Model model = row();
  model.point_loads = {{2, {3, 1}, {100, 0}, {}}, {2, {3, 1}, {1e6, 0}, SineCycles{5, 1, 0}}};
  model.edge_loads = {{2, {2, 1}, {3, 1}, {0, -30}, {}}};
  Bolt bolt;
  bolt.pretension = 7;
  bolt.direction = {-1, 0};
  BoltLink link;
  link.block_a = 2;
  link.block_b = 0;
  link.point_a = {3, 0.5};
  link.point_b = {0, 0.5};
  link.axial_stiffness = 1e6;
  bolt.links = {link};
  model.bolts = {bolt};
  finish_model(model);
  const std::vector<RockBody> bodies = rock_bodies(model, std::vector<bool>(4, false));
  const Resultants acting = resultants_on(bodies, model, {2, 0});
  EXPECT_EQ(acting.of[2].force, Vec2(100 - 7 + 2 * density, -30 - gravity * density));
  EXPECT_DOUBLE_EQ(acting.of[2].moment, -0.5 * 100);
  EXPECT_EQ(acting.of[0].force, Vec2(7 + 2 * density, -gravity * density));
  ASSERT_EQ(acting.left_out.size(), 1U);
}

// Two corners of 60 degrees from the floor upwards: the block between slides when its slope is free.
TEST(KeyBlocks, OpeningSelectsFacesAndFactorsSort) {
  Model model = rock_of({box(-5, -1, 5, 0), box(-1, 0, 1, 1), box(1, 0, 3, 1), {{-3, 0}, {-1, 0}, {-1, 1}}});
  HeldBlock held;
  held.block = 0;
  model.held_blocks = {held};
  KeyBlockQuestion question;
  question.is_void = {false, false, true, false};
  question.opening = {{box(1, 0, 3, 1), {}}};
  const KeyBlockReport report = judge(model, question);
  ASSERT_EQ(report.blocks.size(), 1U);
  EXPECT_EQ(name_of(report.blocks[0].body, model), "block 2");
  EXPECT_EQ(report.blocks[0].type, BlockType::stable);
  EXPECT_EQ(report.buried, 1);
  EXPECT_EQ(report.taken_out, 1);
}

// A wedge in a roof that is held: the numbers of the report are those of the hand case.
TEST(KeyBlocks, ReportOfAWedgeInARoof) {
  Model model = rock_of({{{-3, 0}, {-1, 0}, {0, 2}, {0, 3}, {-3, 3}},
                         {{1, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 2}},
                         {{-1, 0}, {1, 0}, {0, 2}}});
  for (const int block : {0, 1}) {
    HeldBlock held;
    held.block = block;
    model.held_blocks.push_back(held);
  }
  KeyBlockQuestion question;
  const KeyBlockReport report = judge(model, question);
  question.is_void.assign(3, false);
  ASSERT_EQ(report.blocks.size(), 1U);
  const KeyBlock& wedge = report.blocks[0];
  EXPECT_EQ(wedge.type, BlockType::key);
  EXPECT_EQ(wedge.bolt_direction, Vec2(0, 1));
  const double weight = 2 * density * gravity;
  ASSERT_TRUE(wedge.bolt_force);
  EXPECT_NEAR(*wedge.bolt_force, question.wanted_safety * weight, 1e-9 * weight);
  const nlohmann::json json = nlohmann::json::parse(report_json(report, question, model));
  EXPECT_EQ(json["by_type"]["I"], 1);
  EXPECT_EQ(json["blocks"][0]["motion"]["mode"], "falls");
  EXPECT_DOUBLE_EQ(json["blocks"][0]["motion"]["direction_deg"].get<double>(), -90);
  EXPECT_EQ(json["blocks"][0]["factor_of_safety"], 0);
  EXPECT_NEAR(json["blocks"][0]["bolts"]["force"].get<double>(), 1.5 * weight, 1e-9 * weight);
  EXPECT_EQ(json["blocks"][0]["joint_faces"].size(), 2U);
  const std::string text = report_text(report, question, model);
  EXPECT_NE(text.find("block 3, 2 m2: key block, falls towards -90.0 deg, factor of safety 0"), std::string::npos)
      << text;
}

// A wedge slides down a plane of 45 degrees to its toe at the origin. What lies in front of the toe is no face of it.
Model slide(const std::vector<Ring>& rock) {
  std::vector<Ring> outlines = rock;
  outlines.push_back({{0, 0}, {4, 4}, {2, 4}});
  Model model = rock_of(outlines);
  for (int block = 0; block < static_cast<int>(rock.size()); ++block) {
    HeldBlock held;
    held.block = block;
    model.held_blocks.push_back(held);
  }
  return model;
}

std::vector<Obstacle> obstacles_of(Model model) {
  const KeyBlockReport report = judge(model);
  EXPECT_EQ(report.blocks.size(), 1U);
  EXPECT_EQ(report.blocks.front().motion.mode, Mode::slides);
  EXPECT_NEAR(report.blocks.front().motion.factor_of_safety, std::tan(30 * degree), 1e-9);
  return report.blocks.front().obstacles;
}

const Ring above_a_face{{0, -5}, {4, -5}, {4, 4}, {0, 0}};  // the plane daylights

TEST(KeyBlocks, NothingIsInTheWayOfASlideThatDaylights) {
  EXPECT_TRUE(obstacles_of(slide({above_a_face})).empty());
  // Rock below a level joint that ends at the toe is behind the face, too.
  EXPECT_TRUE(obstacles_of(slide({{{0, 0}, {4, 0}, {4, 4}}, {{0, -5}, {4, -5}, {4, 0}, {0, 0}}})).empty());
  // The plane goes on below the toe.
  EXPECT_TRUE(obstacles_of(slide({{{-3, -3}, {4, -3}, {4, 4}}})).empty());
}

TEST(KeyBlocks, AFloorInFrontOfTheToeIsInTheWay) {
  const std::vector<std::vector<Ring>> floors{
      {{{-5, -1}, {4, -1}, {4, 4}, {0, 0}, {-5, 0}}},                   // of the same block as the plane
      {above_a_face, {{-5, -1}, {0, -1}, {0, 0}, {-5, 0}}},             // of another one
      {above_a_face, {{-2, -2}, {0, -3}, {0, 0}}},                      // level with the plane
      {above_a_face, {{-5, -1}, {-0.001, -1}, {-0.001, 1}, {-5, 1}}}};  // just beside the toe
  for (const std::vector<Ring>& rock : floors) {
    const std::vector<Obstacle> obstacles = obstacles_of(slide(rock));
    ASSERT_EQ(obstacles.size(), 1U);
    EXPECT_EQ(obstacles[0].block, static_cast<int>(rock.size()) - 1);
    EXPECT_EQ(obstacles[0].at, Vec2(0, 0));
  }
}

TEST(KeyBlocks, WhatIsInTheWayIsReported) {
  Model model = slide({{{-5, -1}, {4, -1}, {4, 4}, {0, 0}, {-5, 0}}});
  KeyBlockQuestion question;
  const KeyBlockReport report = judge(model, question);
  const std::string text = report_text(report, question, model);
  EXPECT_NE(text.find("\n    its way out touches block 1 at (0, 0) m; a run may find it held there\n"),
            std::string::npos)
      << text;
  const nlohmann::json json = nlohmann::json::parse(report_json(report, question, model));
  EXPECT_EQ(json["blocks"][0]["touches"].dump(), R"([{"at":[0.0,0.0],"block":"block 1"}])");
}

// What presses the wedge up makes it stable; what is stable has no factor of safety and needs no bolt.
TEST(KeyBlocks, StableIsNullInJson) {
  Model model = row();
  KeyBlockQuestion question;
  question.is_void.assign(4, false);
  const KeyBlockReport report = judge(model, question);
  const nlohmann::json json = nlohmann::json::parse(report_json(report, question, model));
  for (const auto& block : json["blocks"]) {
    EXPECT_EQ(block["type"], "III");
    EXPECT_TRUE(block["factor_of_safety"].is_null());
    EXPECT_EQ(block["bolts"]["force"], 0);
    EXPECT_TRUE(block["bolts"]["least_direction_deg"].is_null());
  }
}

}  // namespace
}  // namespace dda
