#include "engine/view/base64.h"

#include <gtest/gtest.h>

namespace dda {
namespace {

using std::string_literals::operator""s;

// RFC 4648, section 10.
TEST(Base64, OfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, OfAllBytes) { EXPECT_EQ(base64("\xff\x00\x80\x7f"s), "/wCAfw=="); }

}  // namespace
}  // namespace dda
