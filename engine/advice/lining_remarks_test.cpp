#include "engine/advice/lining_remarks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dda {
namespace {

// Around a hole of 3 m, the rock on the left.
Model ring(int faces, double thickness) {
  Model model;
  Lining lining;
  lining.name = "shotcrete";
  lining.closed = true;
  lining.thickness = thickness;
  for (int i = 0; i < faces; ++i) {
    const double at = -2 * std::numbers::pi * i / faces;
    lining.nodes.push_back({i, {3 * std::cos(at), 3 * std::sin(at)}, {std::sin(at), -std::cos(at)}});
  }
  model.linings = {lining};
  return model;
}

TEST(LiningRemarks, NothingOnAThinRoundOne) { EXPECT_TRUE(lining_remarks(ring(32, 0.2)).empty()); }

TEST(LiningRemarks, ThickForItsRadius) {
  const auto remarks = lining_remarks(ring(32, 0.4));
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_NE(remarks[0].find("\"shotcrete\" is 0.4 m thick on a wall with a mean radius of 3 m"), std::string::npos)
      << remarks[0];
}

TEST(LiningRemarks, SharpCorners) {
  const auto remarks = lining_remarks(ring(8, 0.2));
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_NE(remarks[0].find("a corner of 45 degrees"), std::string::npos) << remarks[0];
}

TEST(LiningRemarks, FacesShorterThanItIsThick) {
  const auto remarks = lining_remarks(ring(100, 0.25));
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_NE(remarks[0].find("faces of blocks are 0.188 m long"), std::string::npos) << remarks[0];
}

}  // namespace
}  // namespace dda
