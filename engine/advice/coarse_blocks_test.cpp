#include "engine/advice/coarse_blocks.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "engine/advice/lattice_test_support.h"
#include "engine/contact/contact_set.h"

namespace dda {
namespace {

// A bar of blocks of 2 m, P waves of 5,000 m/s in it; a sine of this frequency pushes its left end.
std::vector<std::string> remarks_on_bar(double frequency, int blocks = 20) {
  Model model = row_of_blocks(bonded(InterfaceLaw::consistent), 2, blocks);
  model.materials[0] = {"rock", 2000, 50e9, 0, PlaneState::stress};
  model.stages[0].dt = 2e-5;
  model.stages[0].duration = 0.012;
  model.edge_loads.push_back({0, {0, 0.8}, {0, 0}, {1, 0}, SineCycles{frequency, 4, 0}});
  finish_model(model);
  return coarse_blocks(model, make_contacts(model));
}

// The blocks are 0.8 m high: as large as squares of 1.265 m, of which three are as long as waves of 1,318 Hz.
TEST(CoarseBlocks, AreFewerThanThreeToAWavelength) {
  EXPECT_TRUE(remarks_on_bar(300).empty());
  EXPECT_TRUE(remarks_on_bar(1300).empty());
  EXPECT_EQ(remarks_on_bar(1350).size(), 1U);
  const std::vector<std::string> remarks = remarks_on_bar(2500);
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_EQ(
      remarks[0],
      "stage \"run\": loads change as fast as a wave of 2.5e+03 Hz does, of which a wavelength has 1.6 blocks of the "
      "largest tenth: so few carry it badly or, below 2, not at all; \"dda advise\" foretells what they do to waves");
}

// What steps pass over is another remark's, and a few blocks are bodies.
TEST(CoarseBlocks, AreThoseOfRockThatStepsFollow) {
  EXPECT_TRUE(remarks_on_bar(30e3).empty());
  EXPECT_TRUE(remarks_on_bar(2500, 5).empty());
}

TEST(CoarseBlocks, AreNoneWhereNothingChanges) {
  Model model = row_of_blocks(bonded(InterfaceLaw::consistent), 2, 20);
  finish_model(model);
  EXPECT_TRUE(coarse_blocks(model, make_contacts(model)).empty());
}

}  // namespace
}  // namespace dda
