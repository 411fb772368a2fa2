#include "engine/app/recording_report.h"

#include <gtest/gtest.h>

#include <memory>

namespace dda {
namespace {

// A sample every 0.01 s, peak 4 at 0.01 s, 0.02 s long: leaves a velocity of 0.04 and a displacement of 0.0004.
Recorded quake() {
  return {std::make_shared<const Recording>("quake.csv", std::vector{0.0, 0.01, 0.02}, std::vector{0.0, 4.0, 0.0}), 2};
}

Model shaken() {
  Model model;
  HeldBlock base;
  base.amplitude = {3, 4};
  base.kind = MotionKind::acceleration;
  base.history = quake();
  model.held_blocks = {base, base};
  return model;
}

TEST(RecordingReport, TellsDurationPeakAndWhatIsLeft) {
  const std::vector<std::string> lines = describe_recordings(shaken());
  ASSERT_EQ(lines.size(), 1U);  // one for both
  EXPECT_EQ(lines[0],
            "\"quake.csv\": 3 samples over 0.02 s from 2 s on, peak acceleration 20 m/s2; at its end velocity 0.2 m/s, "
            "displacement 0.002 m");
}

TEST(RecordingReport, OfALoadAndOfAPoint) {
  Model model;
  PointLoad load;
  load.history = quake();
  model.point_loads = {load};
  PointSupport support;
  support.amplitude = {0.5, 0};
  support.history = quake();
  model.supports = {support};
  const std::vector<std::string> lines = describe_recordings(model);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_NE(lines[0].find("peak 4 times the load"), std::string::npos) << lines[0];
  EXPECT_NE(lines[1].find("peak displacement 2 m"), std::string::npos) << lines[1];
}

TEST(RecordingReport, WarnsOfStepsThatPassOverSamples) {
  Model model = shaken();
  model.stages.resize(1);
  model.stages[0].duration = 3;
  model.stages[0].dt = 0.01;
  EXPECT_TRUE(warn_of_recordings(model, 0).empty());
  model.stages[0].dt = 0.011;
  const std::vector<std::string> lines = warn_of_recordings(model, 0);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NE(lines[0].find("dt does not resolve \"quake.csv\", which has a sample every 0.01 s"), std::string::npos);
}

TEST(RecordingReport, WarnsOfStagesInWhichTheRecordingRuns) {
  Model model = shaken();  // from 2 s to 2.02 s
  model.stages.resize(3);
  for (Stage& stage : model.stages) stage.dt = 1;
  model.stages[0].duration = 2;
  model.stages[1].duration = 0.02;
  model.stages[2].duration = 1;
  EXPECT_TRUE(warn_of_recordings(model, 0).empty());
  EXPECT_EQ(warn_of_recordings(model, 1).size(), 1U);
  EXPECT_TRUE(warn_of_recordings(model, 2).empty());
}

}  // namespace
}  // namespace dda
