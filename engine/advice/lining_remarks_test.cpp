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
  lining.young = 15e9;
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

// Random cuts leave a wall of faces of all lengths, on which moments are noise: the first face of 32 lies next to the
// second, where only a third of the usual length is between their middles.
TEST(LiningRemarks, UnevenFaces) {
  Model model = ring(32, 0.2);
  LiningNode& first = model.linings[0].nodes[0];
  const double at = -2 * std::numbers::pi / 32 * 0.67;
  first.point = {3 * std::cos(at), 3 * std::sin(at)};
  first.tangent = {std::sin(at), -std::cos(at)};
  const auto remarks = lining_remarks(model);
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_NE(remarks[0].find("\"shotcrete\": faces of blocks are of uneven lengths, 0.194 m"), std::string::npos)
      << remarks[0];
}

TEST(LiningRemarks, ConcreteInPascals) {
  Model model = ring(32, 0.2);
  model.linings[0].young = 15;
  model.linings[0].compressive_strength = 20;
  model.linings[0].tensile_strength = 1.5e6;
  const auto remarks = lining_remarks(model);
  ASSERT_EQ(remarks.size(), 3U);
  EXPECT_NE(remarks[0].find("a young of 15 Pa"), std::string::npos) << remarks[0];
  EXPECT_NE(remarks[1].find("a compressive_strength of 20 Pa"), std::string::npos) << remarks[1];
  EXPECT_NE(remarks[2].find("stronger in tension, 1.5e+06 Pa, than in compression, 20 Pa"), std::string::npos)
      << remarks[2];
}

TEST(LiningRemarks, ThinnerOrStifferThanAnything) {
  Model model = ring(32, 1e-9);
  model.linings[0].young = 15e15;
  const auto remarks = lining_remarks(model);
  ASSERT_EQ(remarks.size(), 2U);
  EXPECT_NE(remarks[0].find("has a young of 1.5e+16 Pa: concrete has 1 to 40 GPa, steel 210 GPa"), std::string::npos);
  EXPECT_NE(remarks[1].find("is 1e-09 m thick, thinner than any sheet"), std::string::npos) << remarks[1];
}

}  // namespace
}  // namespace dda
