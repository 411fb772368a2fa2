// Overlaps among so many blocks that they are told by the sides that blocks share.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>

#include "engine/core/error.h"
#include "engine/model/check_parts.h"

namespace dda {
namespace {

constexpr int side = 150;  // blocks

// Corners of a slanted grid, each moved a little its own way.
Vec2 corner(int column, int row) {
  const Vec2 place(column, row + 0.3 * column);
  return place + 0.2 * Vec2(std::sin(7.0 * column + row), std::cos(3.0 * column - 5 * row));
}

Model many_blocks() {
  Model model;
  model.length_tolerance = 1e-9 * side;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      Block& block = model.blocks.emplace_back();
      block.name = std::to_string(i) + "/" + std::to_string(j);
      block.shape.outer = {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)};
    }
  }
  return model;
}

Ring& outline(Model& model, int column, int row) {
  return model.blocks[static_cast<std::size_t>(column * side + row)].shape.outer;
}

std::string complaint(const Model& model) {
  try {
    model_checks::check_overlaps(model);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(ManyBlocks, OverlapNowhereWhereTheyShareTheirSides) { EXPECT_EQ(complaint(many_blocks()), ""); }

TEST(ManyBlocks, ThatOverlapAreNamedAsAmongFew) {
  Model model = many_blocks();
  outline(model, 70, 80)[2] += Vec2(0.1, 0.1);
  EXPECT_EQ(complaint(model), "blocks \"70/81\" shape is overlapping \"70/80\", expected blocks that at most touch");
  model = many_blocks();
  model.blocks.push_back(model.blocks[17]);
  model.blocks.back().name = "twice";
  EXPECT_EQ(complaint(model), "blocks \"twice\" shape is overlapping \"0/17\", expected blocks that at most touch");
}

// A block apart from those that fit together, as one that is listed beside rock that was cut.
TEST(ManyBlocks, ThatFitTogetherAreComparedWithOthers) {
  Model model = many_blocks();
  Block& block = model.blocks.emplace_back();
  block.name = "other";
  const auto put = [&](double x) { block.shape.outer = {{x - 2, 0}, {x, 0}, {x, 1}}; };
  put(-1);
  EXPECT_EQ(complaint(model), "");
  put(0.5);
  EXPECT_EQ(complaint(model), "blocks \"other\" shape is overlapping \"0/0\", expected blocks that at most touch");
}

// A gap in the corner of which two blocks touch: the outline of all touches itself, and pairs have to say it.
TEST(ManyBlocks, OverlapNowhereWhereTheirOutlineTouchesItself) {
  Model model = many_blocks();
  outline(model, 20, 21) = {corner(20, 21), corner(21, 21), (corner(20, 21) + corner(20, 22)) / 2};
  outline(model, 21, 22) = {corner(22, 23), corner(21, 23), (corner(22, 22) + corner(22, 23)) / 2};
  EXPECT_EQ(complaint(model), "");
  outline(model, 20, 21)[2] += Vec2(-0.3, 0);
  EXPECT_EQ(complaint(model), "blocks \"20/21\" shape is overlapping \"19/21\", expected blocks that at most touch");
}

}  // namespace
}  // namespace dda
