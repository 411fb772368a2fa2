#include "engine/advice/bolt_remarks.h"

#include <gtest/gtest.h>

namespace dda {
namespace {

// A bar of steel, 25 mm in diameter and 1 m long, every second metre between blocks of 10 GPa.
Model bolted() {
  Model model;
  model.materials = {{"rock", 2600, 10e9, 0.2, PlaneState::stress}};
  model.blocks.resize(2);
  Bolt bolt;
  bolt.name = "bar";
  bolt.spacing = 2;
  bolt.yield_force = 100e3 / bolt.spacing;
  BoltLink link;
  link.axial_stiffness = 1e8 / bolt.spacing;
  bolt.links = {link};
  model.bolts = {bolt};
  return model;
}

std::string only_remark(const Model& model) {
  const std::vector<std::string> remarks = bolt_remarks(model);
  return remarks.size() == 1 ? remarks[0] : std::to_string(remarks.size()) + " remarks";
}

TEST(BoltRemarks, NothingOnABar) { EXPECT_TRUE(bolt_remarks(bolted()).empty()); }

// A diameter of 25, meant in millimetres and read in metres.
TEST(BoltRemarks, StifferThanTheRock) {
  Model model = bolted();
  model.bolts[0].links[0].axial_stiffness *= 1e6;
  EXPECT_EQ(only_remark(model),
            "bolt \"bar\" has an axial stiffness of 1e+14 N/m, more than the blocks that it holds; bolts of steel have "
            "1e6 to 1e9 N/m");
}

// Young's modulus in GPa, read in Pa.
TEST(BoltRemarks, SofterThanRubber) {
  Model model = bolted();
  model.bolts[0].links[0].axial_stiffness *= 1e-9;
  EXPECT_EQ(only_remark(model),
            "bolt \"bar\" has an axial stiffness of 0.1 N/m, softer than rubber; bolts of steel have 1e6 to 1e9 N/m");
}

// A yield force in kN, read in N.
TEST(BoltRemarks, WeakerThanAHand) {
  Model model = bolted();
  model.bolts[0].yield_force *= 1e-3;
  EXPECT_EQ(only_remark(model),
            "bolt \"bar\" yields at 100 N, which a hand can pull; bolts of steel bear 5e4 N and more");
}

TEST(BoltRemarks, StretchedByMoreThanTheLargestAnchors) {
  Model model = bolted();
  model.bolts[0].yield_force = 1e12;
  model.bolts[0].pretension = 1e9 / model.bolts[0].spacing;
  EXPECT_EQ(only_remark(model),
            "bolt \"bar\" has a pretension of 1e+09 N; bolts have 1e4 to 1e6 N, the largest anchors of dams 1e7 N");
}

}  // namespace
}  // namespace dda
