#include "engine/scene/nearest_word.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace dda {
namespace {

const std::array<std::string, 6> known = {"g", "floor", "dt", "Left wall", "block 12", "clay"};

TEST(NearestWord, IsWhatAMisspeltOneWasMeantToBe) {
  EXPECT_EQ(nearest_word("flor", known), "floor");
  EXPECT_EQ(nearest_word("lfet wall", known), "Left wall");
  EXPECT_EQ(nearest_word("block 13", known), "block 12");
  EXPECT_EQ(nearest_word("G", known), "g");
  EXPECT_EQ(nearest_word("dtt", known), "dt");
}

// One letter instead of another is all there is of a name of one letter.
TEST(NearestWord, IsNoneWhereOnlyLittleIsTheSame) {
  for (const char* word : {"s", "ds", "t", "gs", "soil", "wall", ""}) EXPECT_EQ(nearest_word(word, known), "") << word;
}

}  // namespace
}  // namespace dda
