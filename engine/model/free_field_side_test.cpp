#include "engine/model/free_field_side.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "engine/core/error.h"

namespace dda {
namespace {

Block rectangle(const std::string& name, double left, double bottom, double right, double top) {
  Block block;
  block.name = name;
  block.shape.outer = {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
  return block;
}

// Two blocks above one another on a held base, the left side with a free field.
Model complete_model() {
  Model model;
  model.materials = {{"rock", 2500, 40e9, 0.25, PlaneState::strain}};
  model.blocks = {rectangle("low", 0, 0, 2, 1), rectangle("high", 0, 1, 2, 3), rectangle("base", 0, -1, 2, 0)};
  model.held_blocks.emplace_back().block = 2;
  model.viscous_edges = {{0, {0, 1}, {0, 0}, 1, 1}, {1, {0, 1}, {0, 3}, 1, 1}};
  model.free_field_sides = {{{0, 1}, -1}};
  Stage stage;
  stage.dt = stage.duration = 1;
  model.stages = {stage, stage};
  return model;
}

TEST(FreeFieldSide, KnowsWhatStandsAlongIt) {
  Model model = complete_model();
  for (const Vec2& point : {Vec2(2, 0), Vec2(0, 0), Vec2(2, 1)}) {
    model.supports.emplace_back().point = point;
    model.supports.back().stiffness = 1;
  }
  finish_model(model);
  const FreeFieldSide& side = model.free_field_sides[0];
  EXPECT_EQ(foot_of(model, side), Vec2(0, 0));
  EXPECT_EQ(head_of(model, side), Vec2(0, 3));
  EXPECT_EQ(lowest_block(model, side), 0);
  EXPECT_EQ(highest_block(model, side), 1);
  EXPECT_EQ(held_base_of(model, side), 0);
  EXPECT_EQ(supports_at_foot(model, side), std::vector{0});
  EXPECT_TRUE(is_at_foot(model, side, 0, {0, 0}, {2, 0}));
  EXPECT_FALSE(is_at_foot(model, side, 0, {0, 1}, {2, 1}));
  EXPECT_TRUE(is_at_head(model, side, 1, {2, 3}, {0, 3}));
  EXPECT_FALSE(is_at_head(model, side, 0, {2, 3}, {0, 3}));
}

struct Spoiled {
  const char* what;
  std::function<void(Model&)> spoil;
  std::string value, expected;  // parts of the sentence
};

void PrintTo(const Spoiled& spoiled, std::ostream* out) { *out << spoiled.what; }

class BadSide : public testing::TestWithParam<Spoiled> {};

TEST_P(BadSide, IsRefused) {
  Model model = complete_model();
  EXPECT_NO_THROW(finish_model(model));
  GetParam().spoil(model);
  try {
    finish_model(model);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(error.value().find(GetParam().value), std::string::npos) << error.what();
    EXPECT_NE(error.expected().find(GetParam().expected), std::string::npos) << error.what();
  }
}

PointSupport roller(double y, int last_stage) {
  PointSupport support;
  support.point = {0, y};
  support.stiffness = 1;
  support.last_stage = last_stage;
  return support;
}

const std::vector<Spoiled> spoiled = {
    {"no edge", [](Model& m) { m.free_field_sides[0].viscous_edges.clear(); }, "none", "at least one"},
    {"no such edge", [](Model& m) { m.free_field_sides[0].viscous_edges[1] = 2; }, "2", "below 2"},
    {"outward", [](Model& m) { m.free_field_sides[0].outward = 0; }, "0", "-1 for a left"},
    {"not vertical",
     [](Model& m) {
       m.viscous_edges[1] = {1, {0, 3}, {2, 3}, 1, 1};
     },
     "through (2, 3) m", "vertical"},
    {"gap",
     [](Model& m) {
       m.viscous_edges[1].from = {0, 1.5};
     },
     "between (0, 1) m and (0, 1.5) m", "without gaps"},
    {"from above",
     [](Model& m) {
       m.free_field_sides[0].viscous_edges = {1, 0};
     },
     "between (0, 3) m", "from below"},
    {"two stages", [](Model& m) { m.viscous_edges[1].first_stage = 1; }, "from stage 1", "one stage"},
    {"loaded",
     [](Model& m) {
       m.edge_loads.push_back({1, {0, 2}, {0, 3}, {1, 0}, Constant{}});
     },
     "loaded at (0, 2.5) m", "without loads"},
    {"held", [](Model& m) { m.supports = {roller(1, -1)}; }, "held at (0, 1) m", "let go before"},
    {"held too long",
     [](Model& m) {
       for (ViscousEdge& edge : m.viscous_edges) edge.first_stage = 1;
       m.supports = {roller(1, 1)};
     },
     "held at (0, 1) m", "let go before"},
    {"dashpots twice",
     [](Model& m) {
       m.viscous_edges.push_back({1, {0, 2}, {0, 3}, 1, 1});
     },
     "boundary at (0, 2.5) m", "one viscous boundary"},
    {"twice",
     [](Model& m) {
       m.viscous_edges.push_back({0, {0, 0}, {0, 1}, 1, 1});
       m.viscous_edges.push_back({1, {0, 1}, {0, 3}, 1, 1});
       m.free_field_sides.push_back({{2, 3}, -1});
     },
     "boundary at (0, 0.5) m", "one viscous boundary"},
    {"no base", [](Model& m) { m.held_blocks.clear(); }, "on nothing at (0, 0) m", "under the lowest block"},
    {"base that turns", [](Model& m) { m.held_blocks[0].turn = 1; }, "turns", "without turning"},
};

INSTANTIATE_TEST_SUITE_P(FreeFieldSide, BadSide, testing::ValuesIn(spoiled));

// A constant load on a side, and rollers, may have held it before the free field begins.
TEST(FreeFieldSide, MayBeHeldAndLoadedBefore) {
  Model model = complete_model();
  for (ViscousEdge& edge : model.viscous_edges) edge.first_stage = 1;
  model.supports = {roller(1, 0)};
  model.edge_loads.push_back({1, {0, 2}, {0, 3}, {1, 0}, Constant{}});
  EXPECT_NO_THROW(finish_model(model));
}

// Springs between two points of a block, which hold ties, cannot leave a force behind at a point.
TEST(FreeFieldSide, TiesStay) {
  Model model = complete_model();
  model.supports = {roller(1, 0)};
  model.supports[0].partner = Vec2(2, 1);
  EXPECT_THROW(finish_model(model), InputError);
  model.supports[0].last_stage = -1;
  model.supports[0].partner = Vec2(3, 1);
  EXPECT_THROW(finish_model(model), InputError);
}

}  // namespace
}  // namespace dda
