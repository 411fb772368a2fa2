#include "engine/builder/free_outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/builder/builder_models.h"
#include "engine/builder/generators.h"
#include "engine/builder/separate_places.h"
#include "engine/scene/scene.h"

namespace dda {
namespace {

void append_square(Model& model, double x, double y, double side) {
  append_grid(model, {.origin = {x, y}, .columns = 1, .rows = 1, .block_width = side, .block_height = side});
  model.blocks.back().name = std::to_string(model.blocks.size());
}

double length_of(const FreeRing& ring) {
  double length = 0;
  for (const Stretch& stretch : ring) length += (stretch.to - stretch.from).norm();
  return length;
}

void expect_closed(const FreeRing& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    EXPECT_LT((ring[i].to - ring[(i + 1) % ring.size()].from).norm(), 1e-9) << i;
}

// 3 x 3 squares of 1 m with some left out, numbered from 0 below left.
Model squares_without(const std::vector<int>& left_out) {
  Model model = with_rock();
  for (int i = 0; i < 9; ++i)
    if (std::find(left_out.begin(), left_out.end(), i) == left_out.end()) append_square(model, i % 3, i / 3, 1);
  finish_model(model);
  return model;
}

TEST(FreeOutline, OfASolidBodyIsItsOutside) {
  const auto rings = free_rings(squares_without({}));
  ASSERT_EQ(rings.size(), 1U);
  EXPECT_NEAR(length_of(outer_rings(rings)), 12, 1e-12);
  EXPECT_TRUE(ring_around(rings, {1.5, 1.5}).empty());
  EXPECT_TRUE(ring_around(rings, {-1, 1.5}).empty());
}

TEST(FreeOutline, MissingBlockIsACavity) {
  const auto rings = free_rings(squares_without({4}));
  ASSERT_EQ(rings.size(), 2U);
  const FreeRing wall = ring_around(rings, {1.2, 1.7});
  ASSERT_EQ(wall.size(), 4U);
  expect_closed(wall);
  for (const Stretch& stretch : wall) {
    const Vec2 middle = (stretch.from + stretch.to) / 2;
    EXPECT_GT(stretch.inward.dot(middle - Vec2(1.5, 1.5)), 0.49);  // into the block, away from the cavity
  }
  EXPECT_NEAR(length_of(outer_rings(rings)), 12, 1e-12);
}

// Two openings that touch at a corner are two, and a notch in the side belongs to the outside.
TEST(FreeOutline, OpeningsThatTouchAtACornerStayApart) {
  Model model = with_rock();
  for (int i = 0; i < 16; ++i)
    if (i != 5 && i != 10 && i != 7) append_square(model, i % 4, i / 4, 1);
  finish_model(model);
  const auto rings = free_rings(model);
  ASSERT_EQ(rings.size(), 3U);
  EXPECT_NEAR(length_of(ring_around(rings, {1.5, 1.5})), 4, 1e-12);
  EXPECT_NEAR(length_of(ring_around(rings, {2.5, 2.5})), 4, 1e-12);
  EXPECT_TRUE(ring_around(rings, {3.5, 1.5}).empty());
  EXPECT_NEAR(length_of(outer_rings(rings)), 18, 1e-12);  // 16 and the two more sides of the notch
  expect_closed(outer_rings(rings));
}

using Places = std::vector<std::vector<int>>;

// 5 x 5 squares of which some are not there as drawn, and some are taken out.
Places places_of(const std::vector<int>& opening, const std::vector<int>& away_before, int left_out = -1) {
  Model model = with_rock();
  for (int i = 0; i < 25; ++i)
    if (i != left_out) append_square(model, i % 5, i / 5, 1);
  finish_model(model);
  std::vector<bool> away(model.blocks.size(), false);
  for (const std::vector<int>& blocks : {opening, away_before})
    for (const int block : blocks) away[static_cast<std::size_t>(block)] = true;
  return separate_places(opening, away, model);
}

TEST(SeparatePlaces, AreThoseWithoutAFaceInCommon) {
  EXPECT_EQ(places_of({6, 7, 8}, {}), (Places{{6, 7, 8}}));
  EXPECT_EQ(places_of({6, 8, 11, 16}, {}), (Places{{6, 11, 16}, {8}}));
  EXPECT_EQ(places_of({6, 12, 18}, {}), (Places{{6}, {12}, {18}})) << "corners alone keep walls apart";
}

TEST(SeparatePlaces, AreOneAroundWhatIsAwayOrWasNeverThere) {
  EXPECT_EQ(places_of({11, 13}, {12}), (Places{{11, 13}}));
  EXPECT_EQ(places_of({6, 8}, {12}), (Places{{6}, {8}}));
  EXPECT_EQ(places_of({11, 12}, {}, 12), (Places{{11, 12}})) << "on both sides of a hole";
}

// A wide block below two narrow ones with a gap between them, and a lid: the opening's floor is part of an edge.
TEST(FreeOutline, IsCutWhereNeighboursBegin) {
  Model model = with_rock();
  append_grid(model, {.origin = {0, 0}, .columns = 1, .rows = 1, .block_width = 3, .block_height = 1});
  append_square(model, 0, 1, 1);
  append_square(model, 2, 1, 1);
  append_grid(model, {.origin = {0, 2}, .columns = 1, .rows = 1, .block_width = 3, .block_height = 1});
  model.blocks.back().name = "lid";
  finish_model(model);
  const FreeRing wall = ring_around(free_rings(model), {1.5, 1.5});
  ASSERT_EQ(wall.size(), 4U);
  EXPECT_NEAR(length_of(wall), 4, 1e-12);
  for (const Stretch& stretch : wall)
    for (const Vec2& end : {stretch.from, stretch.to})
      EXPECT_NEAR((end - Vec2(1.5, 1.5)).norm(), std::sqrt(0.5), 1e-12);
}

// A hole in a block with a loose block in it: three rings, of which the loose block's is neither wall nor outside.
TEST(FreeOutline, LooseBlocksInAnOpeningAreNeitherWallNorOutside) {
  Model model = with_rock();
  append_square(model, 0, 0, 6);
  model.blocks[0].shape.holes = {{{1, 1}, {1, 5}, {5, 5}, {5, 1}}};
  append_square(model, 2, 2, 1);
  finish_model(model);
  const auto rings = free_rings(model);
  ASSERT_EQ(rings.size(), 3U);
  EXPECT_NEAR(length_of(ring_around(rings, {4, 4})), 16, 1e-12);
  EXPECT_NEAR(length_of(outer_rings(rings)), 24, 1e-12);
}

// Whichever of the two openings comes first.
TEST(FreeOutline, TightestRingIsTheCavity) {
  for (const std::size_t outer : {std::size_t{0}, std::size_t{1}}) {
    Model model = with_rock();
    for (const bool large : {outer == 0, outer != 0}) append_square(model, large ? 0 : 2, large ? 0 : 2, large ? 6 : 2);
    model.blocks[outer].shape.holes = {{{1, 1}, {1, 5}, {5, 5}, {5, 1}}};
    model.blocks[1 - outer].shape.holes = {{{2.5, 2.5}, {2.5, 3.5}, {3.5, 3.5}, {3.5, 2.5}}};
    finish_model(model);
    const auto rings = free_rings(model);
    EXPECT_NEAR(length_of(ring_around(rings, {3, 3})), 4, 1e-12);
    EXPECT_NEAR(length_of(ring_around(rings, {4.5, 3})), 16, 1e-12);
  }
}

Model octagons_with(const std::string& more) {
  return parse_scene(R"({"dda": 1, "materials": {"rock": {"density": 2500, "young": "25 GPa", "poisson": 0.25}},
    "blocks": {"rings": {"name": "blast", "centre": [10, 20], "radii": [1, 1.5, 3], "sectors": 8,
    "first_corner": "22.5 deg"}}, )" +
                         more + R"(, "steps": {"dt": 1, "duration": 1}})",
                     "scene.json");
}

TEST(FreeOutline, PressureInACavityIsOnAllItsWallAndInBalance) {
  const Model model = octagons_with(R"("loads": [{"edge": {"cavity": [10.3, 20.2]}, "pressure": "3 MPa"}])");
  ASSERT_EQ(model.edge_loads.size(), 8U);
  Vec2 sum = Vec2::Zero();
  for (const EdgeLoad& load : model.edge_loads) {
    EXPECT_LT(load.block, 8);
    const Vec2 outwards = ((load.from + load.to) / 2 - Vec2(10, 20)).normalized();
    EXPECT_LT((load.traction - 3e6 * outwards).norm(), 1e-6);
    sum += (load.to - load.from).norm() * load.traction;
  }
  EXPECT_LT(sum.norm(), 1e-6);
}

TEST(FreeOutline, PressureInACavityOnOneBlockOfIt) {
  const Model model =
      octagons_with(R"("loads": [{"edge": {"cavity": [10, 20]}, "block": "blast 1.1", "pressure": 1}])");
  ASSERT_EQ(model.edge_loads.size(), 1U);
  EXPECT_EQ(model.edge_loads[0].block, 0);
}

TEST(FreeOutline, OutsideAbsorbsAllAround) {
  const Model model = octagons_with(R"("viscous_boundaries": [{"edge": "outside"}])");
  ASSERT_EQ(model.viscous_edges.size(), 8U);
  for (const ViscousEdge& edge : model.viscous_edges) {
    EXPECT_GE(edge.block, 8);
    EXPECT_NEAR((edge.from - Vec2(10, 20)).norm(), 3, 1e-12);
    EXPECT_NEAR((edge.to - Vec2(10, 20)).norm(), 3, 1e-12);
  }
}

}  // namespace
}  // namespace dda
