#include "engine/core/text_encoding.h"

#include <gtest/gtest.h>

namespace dda {
namespace {

TEST(TextEncoding, IsToldByTheMarkAtTheBeginning) {
  using namespace std::string_view_literals;
  EXPECT_TRUE(is_utf16("\xFF\xFE{\0"sv));
  EXPECT_TRUE(is_utf16("\xFE\xFF\0{"sv));
  EXPECT_FALSE(is_utf16("\xEF\xBB\xBF{"sv));  // UTF-8 with a mark, which is read
  EXPECT_FALSE(is_utf16("{\"dda\": 1}"sv));
  EXPECT_FALSE(is_utf16(""sv));
}

}  // namespace
}  // namespace dda
