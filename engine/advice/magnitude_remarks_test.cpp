#include "engine/advice/magnitude_remarks.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace dda {
namespace {

// Rock of 10 GPa at 400 m, pressed twice as much from the sides as from above.
Model ordinary() {
  Model model;
  model.materials = {{"rock", 2600, 10e9, 0.2, PlaneState::stress}};
  model.blocks.resize(2);
  for (Block& block : model.blocks) {
    block.name = "b";
    block.initial_stress = {-20e6, -10e6, 0};
  }
  model.gravity = {0, -9.81};
  return model;
}

std::string only_remark(const Model& model) {
  const std::vector<std::string> remarks = magnitude_remarks(model);
  return remarks.size() == 1 ? remarks[0] : std::to_string(remarks.size()) + " remarks";
}

TEST(MagnitudeRemarks, NothingOnOrdinaryRock) { EXPECT_TRUE(magnitude_remarks(ordinary()).empty()); }

TEST(MagnitudeRemarks, GravityOfACentrifuge) {
  Model model = ordinary();
  model.gravity = {0, -981};
  EXPECT_EQ(only_remark(model), "gravity is 981 m/s2, 100 times the Earth's");
}

TEST(MagnitudeRemarks, StifferThanAnything) {
  Model model = ordinary();
  model.materials[0].young = 2e19;
  EXPECT_EQ(only_remark(model), "material \"rock\": young is 2e+19 Pa, stiffer than anything (diamond has 1e12 Pa)");
}

TEST(MagnitudeRemarks, StressThatRockDoesNotBear) {
  Model model = ordinary();
  model.blocks[1].initial_stress = {-1e9, -0.5e9, 0};
  EXPECT_EQ(only_remark(model),
            "block \"b\" starts under 1e+09 Pa, 0.1 of its young: rock breaks at less than 0.01 of it");
}

TEST(MagnitudeRemarks, LoadsThatRockDoesNotBear) {
  Model model = ordinary();
  model.edge_loads = {{0, {0, 0}, {0, 1}, {1e6, 0}, Constant{}}, {1, {0, 0}, {0, 1}, {0, 1e12}, Constant{}}};
  EXPECT_EQ(only_remark(model),
            "block \"b\" is loaded by 1e+12 Pa, 100 of its young: rock breaks at less than 0.01 of it");
}

// A k0 of 100, meant in per cent.
TEST(MagnitudeRemarks, StressesThatDifferTooMuch) {
  Model model = ordinary();
  model.blocks[0].initial_stress = {-100e6, -1e6, 0};
  EXPECT_EQ(
      only_remark(model),
      "block \"b\" starts under 1e+08 Pa in one direction and 1e+06 Pa across it; in rock they differ by 5 times at "
      "most, and k0 is a share, not per cent");
}

// A sample pressed along its axis has nothing across it.
TEST(MagnitudeRemarks, StressInOneDirectionIsASample) {
  Model model = ordinary();
  model.blocks[0].initial_stress = {0, -10e6, 0};
  EXPECT_TRUE(magnitude_remarks(model).empty());
}

// Rock from 20 to 100 m high, whose stresses by lot are right in kPa and MPa, and of nothing in Pa.
TEST(MagnitudeRemarks, StressesThatLostTheirUnit) {
  std::mt19937 random(3);
  for (int i = 0; i < 40; ++i) {
    Model model = ordinary();
    const double height = std::uniform_real_distribution(20.0, 100.0)(random);
    const double stress = std::uniform_real_distribution(20.0, 900.0)(random);
    for (Block& block : model.blocks) {
      block.shape.outer = {{0, 0}, {10, 0}, {10, height}, {0, height}};
      block.initial_stress = {-1.5 * stress / 2, -stress, 0};
    }
    EXPECT_NE(only_remark(model).find("without a unit stresses are in Pa"), std::string::npos) << only_remark(model);
    for (Block& block : model.blocks) block.initial_stress *= 1e3;
    EXPECT_TRUE(magnitude_remarks(model).empty());
  }
}

TEST(MagnitudeRemarks, WaterThatLostItsUnit) {
  std::mt19937 random(5);
  for (int i = 0; i < 40; ++i) {
    Model model = ordinary();
    const double depth = std::uniform_real_distribution(0.5, 20.0)(random);
    const auto with = [&](double gradient) {
      EdgeLoad load;
      load.from = {0, 0};
      load.to = {std::uniform_real_distribution(-5.0, 5.0)(random), -depth};
      load.traction = {gradient * depth / 2, 0};
      load.rise = {gradient * depth / 2, 0};
      model.edge_loads = {load};
    };
    with(std::uniform_real_distribution(1.0, 20.0)(random));
    EXPECT_NE(only_remark(model).find("without a unit a gradient is in Pa/m"), std::string::npos) << only_remark(model);
    with(std::uniform_real_distribution(1e3, 3e4)(random));
    EXPECT_TRUE(magnitude_remarks(model).empty());
  }
}

}  // namespace
}  // namespace dda
