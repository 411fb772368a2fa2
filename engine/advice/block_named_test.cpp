#include "engine/advice/block_named.h"

#include <gtest/gtest.h>

namespace dda {
namespace {

// Lists have their own order: slivers begin with the smallest, which the sentence is about.
TEST(BlockNamed, ListsAreNamedByTheirFirst) {
  Model model;
  for (const char* name : {"a", "b", "c"}) model.blocks.emplace_back().name = name;
  EXPECT_EQ(blocks_named(model, {1}), "block \"b\"");
  EXPECT_EQ(blocks_named(model, {2, 0, 1}), "block \"c\" and 2 more");
}

}  // namespace
}  // namespace dda
