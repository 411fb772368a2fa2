#include "engine/core/place_in_words.h"

#include <gtest/gtest.h>

namespace dda {
namespace {

TEST(PlaceInWords, HasFourDigits) {
  EXPECT_EQ(place_in_words({1.0 / 3, -20.5}), "(0.3333, -20.5) m");
  EXPECT_EQ(place_in_words({1.23456e-5, 999.96}), "(1.235e-05, 1000) m");
}

// Four digits of these are 100 m and 1 km.
TEST(PlaceInWords, HasATenthOfAMetreInCoordinatesOfASurvey) {
  EXPECT_EQ(place_in_words({512345.678, 5412345.678}), "(512345.68, 5412345.7) m");
  EXPECT_EQ(place_in_words({-512345.678, 0}), "(-512345.68, 0) m");
}

}  // namespace
}  // namespace dda
