#include "engine/record/bolt_frame_writer.h"

#include <gtest/gtest.h>

#include "engine/record/record_test_support.h"
#include "engine/record/vtp_test_reader.h"

namespace dda {
namespace {

// Three squares in a row, a bolt anchored in the outer ones and one grouted through all of them.
Model three_squares_with_bolts() {
  Model model;
  model.materials = {{"rock", 2600, 1e9, 0.25, PlaneState::stress}};
  model.joints.resize(1);
  model.blocks.resize(3);
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = static_cast<double>(i);
    model.blocks[i].shape.outer = {{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}};
  }
  Bolt anchored;
  anchored.name = "tie & rod";
  anchored.links = {{0, 2, Vec2(0.5, 0.75), Vec2(2.5, 0.75), 1e6, 0}};
  Bolt grouted;
  grouted.name = "grouted";
  grouted.grouted = true;
  grouted.links = {{0, 1, Vec2(1, 0.5), Vec2(1, 0.5), 1e6, 0, 0.75, 0.5},
                   {1, 2, Vec2(2, 0.5), Vec2(2, 0.5), 1e6, 0, 0.5, 0.25}};
  model.bolts = {anchored, grouted};
  model.stages.resize(1);
  model.stages[0].dt = model.stages[0].duration = 1;
  finish_model(model);
  return model;
}

const std::vector<BoltLinkValues> three_links = {{Vec2(-7, 0), -1e-3, BoltCondition::elastic},
                                                 {Vec2(5, -2), 2e-3, BoltCondition::yielded},
                                                 {Vec2(0, 0), 0.5, BoltCondition::broken}};

TEST(BoltFrameWriter, EveryLinkIsALineThroughMaterialPointsWithItsForce) {
  const TemporaryFolder folder;
  const Model model = three_squares_with_bolts();
  State state = initial_state(model);
  state.time = 0.25;
  state.displacement[2].head<2>() << 0.125, -0.5;
  BoltFrameWriter(model, folder / "bolts.pvd").write(state, three_links);
  const VtpReader vtp(folder / "bolts/000000.vtp");
  EXPECT_EQ(vtp.array("FieldData/TimeValue"), std::vector<double>{0.25});
  EXPECT_EQ(vtp.count("NumberOfLines"), 3U);
  EXPECT_EQ(vtp.array("Lines/connectivity"), (std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(vtp.array("Lines/offsets"), (std::vector<double>{2, 6, 10}));
  const std::vector<double> points = {0.5,  0.75, 0, 2.625, 0.25, 0,                                 // anchors
                                      0.25, 0.5,  0, 1,     0.5,  0, 1,     0.5, 0, 1.5,   0.5, 0,   // first joint
                                      1.5,  0.5,  0, 2,     0.5,  0, 2.125, 0,   0, 2.375, 0,   0};  // second joint
  ASSERT_EQ(vtp.array("Points/Points").size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_NEAR(vtp.array("Points/Points")[i], points[i], 1e-15) << i;
  const auto& moved = vtp.point("displacement [m]");
  for (const std::size_t point : {1U, 8U, 9U}) {
    EXPECT_NEAR(moved[3 * point], 0.125, 1e-15);
    EXPECT_NEAR(moved[3 * point + 1], -0.5, 1e-15);
  }
  EXPECT_EQ(moved[3 * 7], 0);
  EXPECT_EQ(vtp.cell("bolt"), (std::vector<double>{0, 1, 1}));
  EXPECT_EQ(vtp.cell("link"), (std::vector<double>{0, 0, 1}));
  EXPECT_EQ(vtp.texts("CellData/bolt_name"), (std::vector<std::string>{"tie & rod", "grouted", "grouted"}));
  EXPECT_EQ(vtp.cell("block_a"), (std::vector<double>{0, 0, 1}));
  EXPECT_EQ(vtp.cell("block_b"), (std::vector<double>{2, 1, 2}));
  EXPECT_EQ(vtp.cell("status"), (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(vtp.cell("axial_force [N]"), (std::vector<double>{-7, 5, 0}));
  EXPECT_EQ(vtp.cell("shear_force [N]"), (std::vector<double>{0, -2, 0}));
  EXPECT_EQ(vtp.cell("elongation [m]"), (std::vector<double>{-1e-3, 2e-3, 0.5}));
}

TEST(BoltFrameWriter, FramesFollowEachOther) {
  const TemporaryFolder folder;
  const Model model = three_squares_with_bolts();
  State state = initial_state(model);
  BoltFrameWriter writer(model, folder / "bolts.pvd");
  writer.go_on_after(std::vector<double>{0, 0.5});
  state.time = 1;
  writer.write(state, three_links);
  state.time = 2;
  writer.write(state, three_links);
  EXPECT_EQ(names_in(folder.path()), (std::set<std::string>{"bolts", "bolts.pvd"}));
  EXPECT_EQ(VtpReader(folder / "bolts/000002.vtp").cell("status").size(), 3U);
  EXPECT_EQ(VtpReader(folder / "bolts/000003.vtp").cell("status").size(), 3U);
}

}  // namespace
}  // namespace dda
