#include "engine/advice/shaking_remarks.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "engine/geometry/cut_pieces.h"
#include "engine/simulation/simulation.h"

namespace dda {
namespace {

// A base that is moved, and a block beside it.
Model moved(MotionKind kind, double size, const TimeFunction& history) {
  Model model;
  model.materials = {{"rock", 2500, 20e9, 0.25, PlaneState::stress}};
  model.joints = {JointMaterial{}};
  model.blocks.resize(2);
  model.blocks[0].name = "base";
  model.blocks[0].shape.outer = {{0, -1}, {3, -1}, {3, 0}, {0, 0}};
  model.blocks[1].shape.outer = {{9, 0}, {10, 0}, {10, 1}, {9, 1}};
  HeldBlock base;
  base.amplitude = {size, 0};
  base.kind = kind;
  base.history = history;
  model.held_blocks = {base};
  Stage stage;
  stage.name = "shake";
  stage.dt = 1e-3;
  stage.duration = 2;
  model.stages = {stage};
  return model;
}

bool has(const std::vector<std::string>& remarks, const std::string& part) {
  return std::ranges::any_of(remarks, [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

Recorded record_of(const std::vector<double>& times, const std::vector<double>& values) {
  return {std::make_shared<const Recording>("quake.csv", times, values), 0};
}

// How far the base goes in the first step of a run, m.
double first_way(Model model) {
  finish_model(model);
  Simulation simulation(std::move(model));
  EXPECT_EQ(simulation.step(), Status::ok);
  return simulation.state().displacement[0].x();
}

// A table that begins off zero goes there in the first step, one that begins at zero by what it changes in a step.
TEST(ShakingRemarks, TellDisplacementsThatJumpAtTheStartByWhatARunDoes) {
  int jumps = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SeededNumbers random(seed);
    const double size = random.number(0.01, 1), begin = random.chance(0.5) ? random.number(-1, 1) : 0;
    const PiecewiseLinear table{{-0.1, 0, 1, 2}, {0, begin, random.number(-1, 1), 0}};
    Model model = moved(MotionKind::displacement, size, table);
    const double way = first_way(model), of_a_step = size * std::abs(table.values[2] - begin) * 1e-3;
    const bool jumped = std::abs(way) > 1.01 * of_a_step;
    jumps += jumped ? 1 : 0;
    const std::string sentence = fmt::format("the motion of block \"base\" is {:.3g} m at 0 s already", size * begin);
    EXPECT_EQ(has(shaking_remarks(model), "at 0 s already"), jumped) << "seed " << seed;
    EXPECT_EQ(has(shaking_remarks(model), sentence), begin > 0) << "seed " << seed;
    model.stages[0].integrator = static_integrator();  // a settlement, which is meant so
    EXPECT_TRUE(shaking_remarks(model).empty()) << "seed " << seed;
  }
  EXPECT_GT(jumps, 10);
  EXPECT_TRUE(has(shaking_remarks(moved(MotionKind::displacement, 0.3, Constant())), "is 0.3 m at 0 s already"));
}

// The kick of a record of displacements, from second differences of its samples.
TEST(ShakingRemarks, TellByHowMuchTheVelocityOfARecordOfDisplacementsJumps) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SeededNumbers random(seed);
    const double interval = random.number(0.002, 0.05), size = random.number(0.01, 2);
    std::vector<double> times{0, interval}, values{0, 0};
    while (times.size() < 20) {
      times.push_back(interval * static_cast<double>(times.size()));
      values.push_back(random.number(-1, 1));
    }
    values.back() = values[values.size() - 2];
    double kick = 0;
    for (std::size_t n = 2; n < values.size(); ++n)
      kick = std::max(kick, std::abs(values[n] - 2 * values[n - 1] + values[n - 2]) / interval * size);
    Model model = moved(MotionKind::displacement, size, record_of(times, values));
    const std::string sentence = fmt::format("its velocity jumps at each, by up to {:.3g} m/s, which is {:.3g} m/s2",
                                             kick, kick / model.stages[0].dt);
    EXPECT_TRUE(has(shaking_remarks(model), sentence)) << sentence << shaking_remarks(model).at(0);
    model.stages[0].dt = 1.01 * interval;
    EXPECT_FALSE(has(shaking_remarks(model), "its velocity jumps"));
    for (const MotionKind kind : {MotionKind::velocity, MotionKind::acceleration})
      EXPECT_TRUE(shaking_remarks(moved(kind, size, record_of(times, values))).empty());
  }
}

TEST(ShakingRemarks, TellRecordsThatEndOffZero) {
  const Recorded record = record_of({0, 0.1, 0.2, 0.3}, {0, 0.3, 0.5, 0.6});
  EXPECT_TRUE(has(shaking_remarks(moved(MotionKind::displacement, 2, record)),
                  "block \"base\" jumps by 1.2 m at 0.3 s, the last sample of \"quake.csv\""));
  const Recorded swing = record_of({0, 0.1, 0.2, 0.3}, {0, 0.3, 0.2, 0.1});
  EXPECT_FALSE(has(shaking_remarks(moved(MotionKind::displacement, 2, swing)), "jumps by"));
}

// A base that is accelerated by A over a time T moves at A T then, and damping of a 1/s holds back by a A T.
TEST(ShakingRemarks, TellDampingThatBrakesAgainstTheGroundOfTheStart) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SeededNumbers random(seed);
    const double size = random.number(0.1, 10), mass = random.number(0.1, 5), length = random.number(0.1, 1);
    const PiecewiseLinear table{{0, length, 1.0001 * length}, {1, 1, 0}};
    Model model = moved(MotionKind::acceleration, size, table);
    model.stages[0].material_damping.stiffness = 1e-3;
    EXPECT_TRUE(shaking_remarks(model).empty());
    (seed % 2 == 0 ? model.stages[0].material_damping.mass : model.stages[0].damping_rate) = mass;
    const double braked = mass * size * length * 1.00005;
    EXPECT_TRUE(has(shaking_remarks(model),
                    fmt::format("held back by up to {:.3g} m/s2 (its own acceleration: {:.3g})", braked, size)))
        << shaking_remarks(model).at(0);
    model.held_blocks[0].amplitude.setZero();
    EXPECT_TRUE(shaking_remarks(model).empty());
  }
}

TEST(ShakingRemarks, AreOneForAllThatMoveAlike) {
  Model model = moved(MotionKind::displacement, 0.3, Constant());
  model.held_blocks.push_back(model.held_blocks[0]);
  model.held_blocks[1].block = 1;
  ASSERT_EQ(shaking_remarks(model).size(), 1U);
  EXPECT_TRUE(shaking_remarks(model)[0].starts_with("the motion of block \"base\" and 1 more is 0.3 m"));
}

}  // namespace
}  // namespace dda
