#include "engine/scene/json_pieces.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

namespace dda {
namespace {

std::string number(double value) {
  std::string text;
  append_json_number(value, text);
  return text;
}

TEST(JsonPieces, NumbersAreThoseOfTheLibrary) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 100'000; ++i) {
    const double any = std::bit_cast<double>(random());
    EXPECT_EQ(number(any), nlohmann::json(any).dump());
    const double usual = std::ldexp(static_cast<double>(random() >> 11), -50);
    EXPECT_EQ(number(usual), nlohmann::json(usual).dump());
  }
  for (const double special : {0.0, -0.0, 1.0, -1e-6, 1e15, 1e16, 1e-4, 1e-5, 1e300, 5e-324,
                               std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_EQ(number(special), nlohmann::json(special).dump());
}

TEST(JsonPieces, TextsAreThoseOfTheLibrary) {
  for (const std::string text :
       {"", "lines[3]", "a \"b\" \\ c", "tab\tend\n", "m\xc2\xb2 \xe2\x82\xac", "\x7f", "\x01"}) {
    std::string piece;
    append_json_text(text, piece);
    EXPECT_EQ(piece, nlohmann::json(text).dump());
  }
  std::string piece;
  EXPECT_THROW(append_json_text("\xff", piece), nlohmann::json::type_error);
}

// Later entries are longer than is guessed from the first.
TEST(JsonPieces, EntriesComeInTheirOrder) {
  const auto append_one = [](std::size_t i, std::string& text) { text += std::string(i % 7 + i / 50, 'x'); };
  for (const std::size_t count : {0U, 1U, 9U, 10U, 160U, 161U, 1000U, 1605U}) {
    std::string expected = "[";
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) expected += ", ";
      append_one(i, expected);
    }
    for (const int threads : {1, 2, 4}) {
      const ThreadsInUse in_use(threads);
      std::string text = "[";
      append_entries(count, 10, ", ", append_one, text, 5);
      EXPECT_EQ(text, expected) << count << " with " << threads;
    }
  }
}

}  // namespace
}  // namespace dda
