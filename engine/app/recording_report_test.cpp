#include "engine/app/recording_report.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/geometry/cut_pieces.h"
#include "engine/simulation/simulation.h"

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

// A block that is moved alone.
Model with_held(const HeldBlock& held) {
  Model model;
  model.materials = {{"rock", 2500, 20e9, 0.25, PlaneState::stress}};
  model.joints = {JointMaterial{}};
  model.blocks.resize(1);
  model.blocks[0].shape.outer = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  model.held_blocks = {held};
  return model;
}

State end_of_run(Model model, double duration) {
  constexpr int steps = 50;
  Stage stage;
  stage.name = "shake";
  stage.dt = duration / steps;
  stage.duration = duration;
  model.stages = {stage};
  finish_model(model);
  Simulation simulation(std::move(model));
  while (!simulation.finished()) EXPECT_EQ(simulation.step(), Status::ok);
  return simulation.state();
}

// The report gives sizes of amplitudes, whose direction is not told.
std::string without_signs(std::string text) {
  std::erase(text, '-');
  return text;
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

// What a base that a run moves is left with, by a record that has begun before the scene.
TEST(RecordingReport, TellsWhatIsLeftOfWhatActs) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SeededNumbers random(seed);
    std::vector<double> times{0}, values{random.number(-5, 5)};
    while (times.size() < 30) {
      times.push_back(times.back() + random.number(0.01, 0.1));
      values.push_back(random.number(-5, 5));
    }
    const double start = -random.number(0.1, 0.9) * times.back();
    const HeldBlock base{.amplitude = {2, 0},
                         .history = Recorded{std::make_shared<const Recording>("quake.csv", times, values), start},
                         .kind = MotionKind::acceleration};
    const std::string line = describe_recordings(with_held(base)).at(0);
    const State end = end_of_run(with_held(base), times.back() + start);
    const std::string left =
        fmt::format("velocity {:.3g} m/s, displacement {:.3g} m; its first {:.6g} s, before 0 s, do not act",
                    std::abs(end.velocity[0].x()), std::abs(end.displacement[0].x()), -start);
    EXPECT_TRUE(without_signs(line).ends_with(without_signs(left))) << line << " / " << left;
  }
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
