// What holds the ends of rows one block wide, against the bending of half a block.
#include <gtest/gtest.h>

#include <string>

#include "engine/scene/scene.h"

namespace dda {
namespace {

// Blocks of 2 x 1 m, in columns and rows, on supports along `edge`.
Model wall_on(const std::string& support, int columns, int rows) {
  return parse_scene(
      R"({"dda": 1, "materials": {"m": {"density": 1, "young": 9, "poisson": 0}}, "blocks": {"grid": {"columns": )" +
          std::to_string(columns) + R"(, "rows": )" + std::to_string(rows) +
          R"(, "block_width": 2, "block_height": 1}}, "steps": {"dt": 1, "duration": 1}, "supports": [)" + support +
          "]}",
      "scene.json");
}

// What of a small motion of its point a support holds.
Vec2 held_of(const PointSupport& support, const Vec2& motion) {
  if (!support.direction.isZero(0)) return support.direction.dot(motion) * support.direction;
  return {support.holds_x ? motion.x() : 0, support.holds_y ? motion.y() : 0};
}

// The moment of what holds a point against a small turn about `centre`, N m per rad and m of thickness.
double stiffness_against_turning(const Model& model, const Vec2& centre) {
  double sum = 0;
  for (const PointSupport& support : model.supports) {
    const Vec2 way(centre.y() - support.point.y(), support.point.x() - centre.x());
    sum += support.stiffness * held_of(support, way).squaredNorm();
  }
  return sum;
}

double stiffness_across(const Model& model, const Vec2& across) {
  double sum = 0;
  for (const PointSupport& support : model.supports) sum += support.stiffness * held_of(support, across).squaredNorm();
  return sum;
}

// Where a row of blocks ends, what holds it turns by what half a block bends: E I/d = 9 x 2^3/12/0.5 under a column of
// blocks 2 m wide, 9 x 1/12/1 beside a row of blocks 1 m high.
TEST(RowEnd, TurnsAsHalfABlockBends) {
  for (const char* hold : {R"(, "hold": "xy")", R"(, "hold": "normal")", R"(, "hold": "y")"}) {
    const Model column = wall_on(std::string(R"({"edge": "bottom")") + hold + "}", 1, 3);
    EXPECT_NEAR(stiffness_against_turning(column, {1, 0}), 12, 1e-9) << hold;
    EXPECT_NEAR(stiffness_across(column, {0, 1}), 9e3, 1e-9) << hold;
  }
  for (const char* hold : {R"(, "hold": "xy")", R"(, "hold": "normal")", R"(, "hold": "x")"}) {
    const Model row = wall_on(std::string(R"({"edge": "right")") + hold + "}", 4, 1);
    EXPECT_NEAR(stiffness_against_turning(row, {8, 0.5}), 0.75, 1e-9) << hold;
    EXPECT_NEAR(stiffness_across(row, {1, 0}), 9e3, 1e-9) << hold;
  }
}

// A single block, one between others, a side of a row, ground under a stone, and an edge held along itself alone.
TEST(RowEnd, OtherEdgesAreHeldAtTheirEnds) {
  EXPECT_NEAR(stiffness_against_turning(wall_on(R"({"edge": "bottom"})", 1, 1), {1, 0}), 9e3, 1e-9);
  EXPECT_NEAR(stiffness_against_turning(wall_on(R"({"edge": "bottom", "block": "grid 1.1"})", 2, 3), {1, 0}), 9e3,
              1e-9);
  EXPECT_NEAR(stiffness_against_turning(wall_on(R"({"edge": "bottom", "block": "grid 1.1"})", 4, 1), {1, 0}), 9e3,
              1e-9);
  const Model ground =
      parse_scene(R"({"dda": 1, "materials": {"m": {"density": 1, "young": 9, "poisson": 0}}, "blocks": [
    {"polygon": {"vertices": [[0, 0], [2, 0], [2, 1], [0, 1]]}}, {"polygon": {"vertices": [[1, 1], [2, 1], [2, 2], [1, 2]]}}],
    "supports": [{"edge": "bottom"}], "steps": {"dt": 1, "duration": 1}})",
                  "scene.json");
  EXPECT_NEAR(stiffness_against_turning(ground, {1, 0}), 9e3, 1e-9);
  const Model sliding = wall_on(R"({"edge": "bottom", "hold": "x"})", 1, 3);
  EXPECT_EQ(sliding.supports.at(0).point, Vec2(0, 0));
  EXPECT_EQ(sliding.supports.at(1).point, Vec2(2, 0));
}

// Springs so soft that they let the end turn by more than that stay at its corners.
TEST(RowEnd, SoftlyHeldIsHeldAtItsCorners) {
  const Model column = wall_on(R"({"edge": "bottom", "stiffness": 10})", 1, 3);
  EXPECT_NEAR(stiffness_against_turning(column, {1, 0}), 10, 1e-9);
}

}  // namespace
}  // namespace dda
