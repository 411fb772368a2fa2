#include "engine/app/frame_clock.h"

#include <gtest/gtest.h>

#include <tuple>

#include "engine/model/settings.h"

namespace dda {
namespace {

Stage stage_of(const Integrator& integrator, double duration, double equilibrium = 0) {
  Stage stage;
  stage.dt = duration / 100;  // 0: paces itself
  stage.integrator = integrator;
  stage.duration = duration;
  stage.equilibrium = equilibrium;
  return stage;
}

const Stage settle = stage_of(static_integrator(), 100, 1e-9);

// Which of these times have a frame.
std::vector<double> framed(const Model& model, int frames, const std::vector<double>& times) {
  FrameClock clock(model, moving_time(model) / frames);
  std::vector<double> found;
  for (const double time : times) {
    if (!clock.is_due(time)) continue;
    found.push_back(time);
    clock.taken(time);
  }
  return found;
}

TEST(FrameClock, FramesLieEvenlyOverTheTimeOfMotion) {
  Model model;
  model.stages = {settle, stage_of(thesis_integrator(), 2)};
  EXPECT_EQ(moving_time(model), 2);
  EXPECT_EQ(framed(model, 4, {0, 1, 2, 100, 100.25, 100.5, 100.75, 101, 101.25, 101.5, 101.75, 102}),
            (std::vector<double>{0, 100, 100.5, 101, 101.5, 102}));
}

TEST(FrameClock, SettlingThatEndsLateOrComesLaterHasOneFrameToo) {
  Model model;
  model.stages = {stage_of(thesis_integrator(), 1), settle, stage_of(thesis_integrator(), 1)};
  EXPECT_EQ(framed(model, 2, {0, 0.5, 1, 50, 99, 101 - 1e-12, 101.5, 102}),
            (std::vector<double>{0, 1, 101 - 1e-12, 102}));
}

TEST(FrameClock, AStaticStageOfGivenLengthCounts) {
  Model model;
  model.stages = {stage_of(static_integrator(), 2), stage_of(thesis_integrator(), 2)};
  EXPECT_EQ(framed(model, 4, {0, 0.5, 1, 2, 3, 4}), (std::vector<double>{0, 1, 2, 3, 4}));
}

TEST(FrameClock, TimeCountsWhereAllStagesSettle) {
  Model model;
  model.stages = {settle, settle};
  EXPECT_EQ(framed(model, 4, {0, 1, 50, 100, 101, 150, 200}), (std::vector<double>{0, 50, 100, 150, 200}));
}

// Stages that take no time have a frame of their start, and one of their end (run_files asks at no other moment).
TEST(FrameClock, StagesOfNoTimeHaveAFrameOfTheirEnd) {
  Model model;
  model.stages = {stage_of(static_integrator(), 0, 1e-9), stage_of(thesis_integrator(), 2)};
  model.stages[1].dt = 0.5;
  EXPECT_EQ(moving_time(model), 2);
  EXPECT_EQ(framed(model, 2, {0, 0, 0.5, 1, 1.5, 2}), (std::vector<double>{0, 0, 1, 2}));
}

// A motion of 1.0004 s in steps of 2 ms is over at 1 s, and 1,900 steps of 1 ms are not quite 1.9 s. The rest that
// follows must have the frame of its end all the same.
TEST(FrameClock, StagesThatAreNoWholeNumberOfStepsKeepTheFramesOfTheirEnds) {
  for (const auto& [duration, dt, steps] : {std::tuple(1.0004, 2e-3, 500), std::tuple(1.9, 1e-3, 1900)}) {
    Model model;
    model.stages = {stage_of(thesis_integrator(), duration), stage_of(static_integrator(), 0, 1e-9)};
    model.stages[0].dt = dt;
    const double end = steps * dt;
    EXPECT_EQ(moving_time(model), end);
    EXPECT_EQ(framed(model, 2, {0, dt, end / 2, end - dt, end, end}), (std::vector<double>{0, end / 2, end, end}));
    EXPECT_EQ(stage_spans(model)[1].begin_s, end);
  }
}

// The clock of a run adds up steps, so that the end of a rest of no time may be off by round-off.
TEST(FrameClock, RestOfNoTimeAfterManyStages) {
  Model model;
  for (int i = 0; i < 10; ++i) model.stages.push_back(stage_of(thesis_integrator(), 0.1));
  model.stages.push_back(stage_of(static_integrator(), 0, 1e-9));
  FrameClock clock(model, 0.5);
  clock.taken(1);
  EXPECT_TRUE(clock.is_due(1 + 2e-16));
}

TEST(FrameClock, GoesOnBehindTheLastFrame) {
  Model model;
  model.stages = {settle, stage_of(thesis_integrator(), 2)};
  FrameClock clock(model, 0.5);
  clock.taken(100.5);
  EXPECT_FALSE(clock.is_due(100.75));
  EXPECT_TRUE(clock.is_due(101));
}

}  // namespace
}  // namespace dda
