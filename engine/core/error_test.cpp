#include "engine/core/error.h"

#include <gtest/gtest.h>

namespace dda {
namespace {

TEST(InputError, NamesFileFieldValueAndExpectation) {
  const InputError error("bar.json", "materials[0].density", "-5 kg/m3", "a positive mass density");
  EXPECT_STREQ(error.what(), "bar.json: materials[0].density is -5 kg/m3, expected a positive mass density");
  EXPECT_EQ(error.field(), "materials[0].density");
  EXPECT_EQ(error.value(), "-5 kg/m3");
}

TEST(InputError, LeavesOutAFileThatIsNotKnown) {
  EXPECT_STREQ(InputError("", "time step", "0", "more than 0").what(), "time step is 0, expected more than 0");
}

TEST(InputError, TakesTheFileLater) {
  const InputError error("", "time step", "0", "more than 0");
  const InputError located = error.in_file("bar.json");
  EXPECT_STREQ(located.what(), "bar.json: time step is 0, expected more than 0");
  EXPECT_EQ(located.field(), "time step");
}

// Whatever was quoted from a damaged file: UTF-8 stays UTF-8.
TEST(InputError, StaysOneSentenceOfReadableLength) {
  const std::string long_value(100'000, 'x');
  const std::string text = InputError("f", "a\nfield", "\t" + long_value, "less").what();
  EXPECT_EQ(text, "f: a field is  " + long_value.substr(0, 399) + "..., expected less");
  std::string accents;
  while (accents.size() < 1000) accents += "\u00e4";
  const std::string cut = InputError("", "x" + accents, "y", "z").what();
  EXPECT_EQ(cut, "x" + accents.substr(0, 398) + "... is y, expected z");
}

}  // namespace
}  // namespace dda
