#include "engine/record/lining_frame_writer.h"

#include <gtest/gtest.h>

#include "engine/record/record_test_support.h"
#include "engine/record/vtp_test_reader.h"

namespace dda {
namespace {

// Three squares in a row, lined below.
Model three_lined_squares() {
  Model model;
  model.materials = {{"rock", 2600, 1e9, 0.25, PlaneState::stress}};
  model.joints.resize(1);
  model.blocks.resize(3);
  Lining lining;
  lining.name = "shot & crete";
  lining.thickness = 0.1;
  lining.young = 1e10;
  for (int i = 0; i < 3; ++i) {
    const double x = i;
    model.blocks[static_cast<std::size_t>(i)].shape.outer = {{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}};
    lining.nodes.push_back({i, {x + 0.5, 0}, {1, 0}});
  }
  model.linings = {lining};
  model.stages.resize(1);
  model.stages[0].dt = model.stages[0].duration = 1;
  finish_model(model);
  return model;
}

const std::vector<LiningValues> two_elements = {{-7, 1, 2, 0.25, LiningCondition::elastic},
                                                {5, -2, 3, 1, LiningCondition::yielded}};

TEST(LiningFrameWriter, EveryElementIsALineThroughMaterialPointsWithItsForces) {
  const TemporaryFolder folder;
  const Model model = three_lined_squares();
  State state = initial_state(model);
  state.time = 0.25;
  state.displacement[2].head<2>() << 0.125, -0.5;
  LiningFrameWriter writer(model, folder / "linings.pvd");
  writer.go_on_after(std::vector<double>{0});
  writer.write(state, two_elements);
  const VtpReader vtp(folder / "linings/000001.vtp");
  EXPECT_EQ(vtp.array("FieldData/TimeValue"), std::vector<double>{0.25});
  EXPECT_EQ(vtp.array("Lines/connectivity"), (std::vector<double>{0, 1, 2, 3}));
  EXPECT_EQ(vtp.array("Lines/offsets"), (std::vector<double>{2, 4}));
  EXPECT_EQ(vtp.array("Points/Points"), (std::vector<double>{0.5, 0, 0, 1.5, 0, 0, 1.5, 0, 0, 2.625, -0.5, 0}));
  EXPECT_EQ(vtp.point("displacement [m]"), (std::vector<double>{0, 0, 0, 0, 0, 0, 0, 0, 0, 0.125, -0.5, 0}));
  EXPECT_EQ(vtp.cell("lining"), (std::vector<double>{0, 0}));
  EXPECT_EQ(vtp.cell("element"), (std::vector<double>{0, 1}));
  EXPECT_EQ(vtp.texts("CellData/lining_name"), (std::vector<std::string>{"shot & crete", "shot & crete"}));
  EXPECT_EQ(vtp.cell("block_a"), (std::vector<double>{0, 1}));
  EXPECT_EQ(vtp.cell("block_b"), (std::vector<double>{1, 2}));
  EXPECT_EQ(vtp.cell("status"), (std::vector<double>{0, 1}));
  EXPECT_EQ(vtp.cell("thrust [N]"), (std::vector<double>{-7, 5}));
  EXPECT_EQ(vtp.cell("moment [N m]"), (std::vector<double>{1, -2}));
  EXPECT_EQ(vtp.cell("shear [N]"), (std::vector<double>{2, 3}));
  EXPECT_EQ(vtp.cell("utilisation"), (std::vector<double>{0.25, 1}));
}

}  // namespace
}  // namespace dda
