// The strongest motion of blocks, against motions that are known.
#include "engine/simulation/peak_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/simulation/archive.h"
#include "engine/simulation/run_so_far.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr double gravity = 10;  // m/s2, down

// Heavy ground that is held, and three blocks far above and apart, thrown with known velocities.
Model thrown_blocks(const std::vector<Vec2>& velocities) {
  Model model;
  model.materials = {rock()};
  model.blocks = {rectangle("ground", -50, -10, 100, 2)};
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    model.blocks.push_back(rectangle("stone", 20.0 * static_cast<double>(i) - 20, 5, 1 + static_cast<double>(i), 1));
    model.blocks.back().name += std::to_string(i);
    model.blocks.back().initial_velocity = velocities[i];
  }
  model.held_blocks = {HeldBlock{}};
  model.gravity = {0, -gravity};
  model.stages = {stage_of(trapezoidal_integrator(), 1e-3, 400, Kinematics::finite)};
  model.peaks.emplace();
  return model;
}

PeakMotion follow(Simulation& simulation) {
  PeakMotion peaks(simulation);
  simulation.watch().between = [&] { peaks.after_stage(simulation, stages_done(simulation) - 1); };
  while (!simulation.finished()) {
    EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
    peaks.after_step(simulation);
  }
  simulation.watch().between = {};
  return peaks;
}

// In free flight v = v0 - g t exactly, and the way to the end of a step is v0 t - g t^2/2.
TEST(PeakMotion, OfFreeFlight) {
  const std::vector<Vec2> velocities = {{0.5, 3}, {2, 0}, {0, -0.2}};
  Model model = thrown_blocks(velocities);
  model.peaks->ejection.emplace();
  model.peaks->ejection->distance = 0.9;
  Simulation simulation = simulation_of(std::move(model));
  const PeakMotion peaks = follow(simulation);
  EXPECT_TRUE(peaks.is_over());
  EXPECT_FALSE(peaks.blocks()[0].takes_part);
  double kinetic = 0;
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    const BlockPeaks& block = peaks.blocks()[i + 1];
    double speed = 0, speed_time = 0, thrown = 0, gone_at = 0, moved = 0;
    for (int step = 0; step <= 400; ++step) {
      const double t = step * 1e-3;
      const Vec2 velocity = velocities[i] - Vec2(0, gravity * t);
      moved = (t * velocities[i] - Vec2(0, gravity * t * t / 2)).norm();
      if (velocity.norm() > speed) speed_time = t;
      speed = std::max(speed, velocity.norm());
      if (gone_at == 0) thrown = std::max(thrown, velocity.norm());
      if (gone_at == 0 && moved >= 0.9) gone_at = t;
    }
    EXPECT_NEAR(block.speed, speed, 1e-12);
    EXPECT_NEAR(block.speed_time, speed_time, 1e-12);
    EXPECT_NEAR(block.acceleration, gravity, 1e-9);
    EXPECT_NEAR(block.moved, moved, 1e-11);
    EXPECT_EQ(block.is_ejected(), gone_at > 0) << i;
    EXPECT_NEAR(block.thrown, thrown, 1e-12);
    if (gone_at > 0) {
      EXPECT_NEAR(block.ejected_at, gone_at, 1e-12);
    }
    kinetic += block.kinetic;
  }
  EXPECT_FALSE(peaks.blocks()[1].is_ejected()) << "up and down again within 0.9 m";
  EXPECT_TRUE(peaks.blocks()[2].is_ejected());
  EXPECT_NEAR(kinetic, simulation.energy().kinetic, 1e-12 * kinetic);
  // The second stone alone, of 2 m2, with the speed it has when it has gone so far.
  const Ejection ejection = ejection_of(simulation.model(), peaks.blocks());
  EXPECT_EQ(ejection.all.blocks, 1U);
  EXPECT_DOUBLE_EQ(ejection.all.mass, 2 * rock().density);
  EXPECT_DOUBLE_EQ(ejection.all.kinetic, rock().density * std::pow(peaks.blocks()[2].thrown, 2));
}

TEST(PeakMotion, EjectsBySpeedAsWell) {
  Model model = thrown_blocks({{0.5, 3}, {2, 0}, {0, 0}});
  model.peaks->ejection.emplace();
  model.peaks->ejection->speed = 2.5;
  Simulation simulation = simulation_of(std::move(model));
  const PeakMotion peaks = follow(simulation);
  EXPECT_EQ(peaks.blocks()[1].ejected_at, 0);
  // 2^2 + (g t)^2 = 2.5^2 at 0.15 s; from rest g t = 2.5 at 0.25 s.
  EXPECT_NEAR(peaks.blocks()[2].ejected_at, 0.150, 1.5e-3);
  EXPECT_NEAR(peaks.blocks()[3].ejected_at, 0.250, 1.5e-3);
  EXPECT_NEAR(peaks.blocks()[2].thrown, std::hypot(2, gravity * 0.4), 1e-12);  // no distance: of the whole stage
}

// What moves with the ground is not ejected: the rest is the median by mass.
TEST(PeakMotion, IsRelativeToTheRest) {
  Model model = thrown_blocks({{3, 1}, {3, 0}, {3, 0}});
  model.gravity = {0, 0};
  model.held_blocks[0].kind = MotionKind::velocity;
  model.held_blocks[0].amplitude = {3, 0};
  model.peaks->ejection.emplace();
  model.peaks->ejection->distance = 0.3;
  model.peaks->ejection->speed = 5;
  Simulation simulation = simulation_of(std::move(model));
  const PeakMotion peaks = follow(simulation);
  EXPECT_TRUE(peaks.blocks()[1].is_ejected());
  EXPECT_NEAR(peaks.blocks()[1].thrown, 1, 1e-12);
  EXPECT_NEAR(peaks.blocks()[1].speed, std::hypot(3, 1), 1e-12);
  EXPECT_FALSE(peaks.blocks()[2].is_ejected());
  EXPECT_NEAR(peaks.blocks()[2].moved, 0, 1e-12);
}

// Only the stage asked for counts, with what there is of the blocks then.
TEST(PeakMotion, IsThatOfItsStage) {
  Model model = thrown_blocks({{0, 4}, {1, 0}, {0, 0}});
  model.stages.assign(3, stage_of(trapezoidal_integrator(), 1e-3, 100, Kinematics::finite));
  model.stages[1].removal.blocks = {3};
  model.peaks->stage = 1;
  model.peaks->ejection.emplace();
  model.peaks->ejection->distance = 10;
  Simulation simulation = simulation_of(std::move(model));
  const PeakMotion peaks = follow(simulation);
  EXPECT_NEAR(peaks.blocks()[1].speed, 4 - gravity * 0.1, 1e-12);
  EXPECT_NEAR(peaks.blocks()[1].speed_time, 0.1, 1e-12);
  EXPECT_NEAR(peaks.blocks()[1].moved, 0.1 * (3 + 2) / 2, 1e-12);
  EXPECT_NEAR(peaks.blocks()[1].place.y(), 5.5 + 0.1 * (4 + 3) / 2, 1e-12);
  EXPECT_NEAR(peaks.blocks()[2].speed, std::hypot(1, gravity * 0.2), 1e-12);
  EXPECT_NEAR(peaks.blocks()[2].kinetic, rock().density * (1 + 4), 1e-9);
  EXPECT_FALSE(peaks.blocks()[3].takes_part);
}

// One sector of the rock around a hole of 1 m, between rollers: bonded blocks of `size` in the radius, out to `end`. A
// pressure of sin^4(pi t/1.5 ms) on the hole sends a P wave out.
Model sector(double size, double end) {
  constexpr double half = std::numbers::pi / 64;
  constexpr double pulse = 1.5e-3;  // s
  const auto at = [](double radius, double angle) { return Vec2(radius * std::cos(angle), radius * std::sin(angle)); };
  Model model;
  model.materials = {{"rock", 2600, 30e9, 0.25, PlaneState::stress}};
  model.joints = {bond(InterfaceLaw::consistent)};
  for (double r = 1; r < end - size / 2; r += size) {
    const int block = static_cast<int>(model.blocks.size());
    model.blocks.emplace_back().shape.outer = {at(r, -half), at(r + size, -half), at(r + size, half), at(r, half)};
    for (const double side : {-half, half}) {
      PointSupport roller{block, at(r + size / 2, side), true, true, 1e13, Vec2::Zero(), {}};
      roller.direction = {-std::sin(side), std::cos(side)};
      model.supports.push_back(roller);
    }
  }
  PiecewiseLinear history;
  for (int i = 0; i <= 100; ++i) {
    history.times.push_back(i * pulse / 100);
    history.values.push_back(std::pow(std::sin(std::numbers::pi * i / 100), 4));
  }
  model.edge_loads = {{0, at(1, half), at(1, -half), {1e6, 0}, history}};
  return model;
}

// Far from its source a cylindrical wave keeps its shape and falls with 1/sqrt(R), which spreads its energy over 2 pi
// R. A finite difference solution of the wave equation in the radius, converged to three digits, gives n = 0.494 from
// 15 to 45 m: what is left of the near field, c/(2 pi f R). Blocks of 0.125 m give 0.503, half as large ones 0.502;
// those twice as large disperse the pulse, and peaks fall too slowly (0.46).
TEST(PeakMotion, OfACylindricalWaveFallsWithTheRootOfTheDistance) {
  Model model = sector(0.125, 51);
  constexpr double speed = 3508.2;  // m/s, sqrt(E/(1 - nu^2)/rho)
  constexpr double dt = 2e-5;
  model.stages = {stage_of(trapezoidal_integrator(), dt, static_cast<int>(49 / speed / dt))};
  model.peaks.emplace();
  model.peaks->attenuation = AttenuationRequest{{0, 0}, 1, 15, 45};
  Simulation simulation = simulation_of(std::move(model));
  const PeakMotion peaks = follow(simulation);
  const auto law = attenuation_of(*simulation.model().peaks->attenuation, peaks.blocks());
  ASSERT_TRUE(law);
  EXPECT_EQ(law->points, 240U);
  EXPECT_NEAR(law->exponent, 0.494, 0.015);
  EXPECT_LT(law->correlation, -0.999);
}

TEST(PeakMotion, GoesOnFromItsMemory) {
  Model model = thrown_blocks({{0, 4}, {1, 0}, {0, 0}});
  model.peaks->ejection.emplace();
  model.peaks->ejection->distance = 0.2;
  Simulation simulation = simulation_of(std::move(model));
  PeakMotion whole(simulation);
  MemoryWriter middle, end_of_whole, end_of_resumed;
  std::optional<PeakMotion> resumed;
  for (int step = 0; step < 399; ++step) {
    run(simulation, 1);
    whole.after_step(simulation);
    if (resumed) resumed->after_step(simulation);
    if (step != 200) continue;
    middle(whole);
    const std::vector<std::byte> bytes = middle.take();
    resumed.emplace(simulation);
    MemoryReader reader(bytes);
    reader(*resumed);
    reader.expect_end();
  }
  end_of_whole(whole);
  end_of_resumed(*resumed);
  EXPECT_EQ(end_of_whole.take(), end_of_resumed.take());
}

}  // namespace
}  // namespace dda
