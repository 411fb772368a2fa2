// A block that slides from one block on to the next meets none of their upright sides, however far it goes in a step:
// on bases of several blocks it moves as on one, and off ledges as freely. What stands above the ground still stops it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engine/geometry/cut_pieces.h"
#include "engine/geometry/rotation.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr double gravity_here = 9.81;  // m/s2

struct Slide {
  double size = 1;            // m, of the block: its length
  double height = 0.3;        // m
  std::vector<double> bases;  // m, lengths of the blocks below, the first from x = 0 on
  double drop = 0;            // m, by which each base lies below the one before it
  double opening = 0;         // m, between them
  double dip = 0, friction = 0;
  Vec2 velocity = Vec2::Zero();
};

Block turned(Block block, double angle) {
  for (Vec2& corner : block.shape.outer) corner = rotation(angle) * corner;
  return block;
}

// The block starts at the left end and goes to the right, downhill by `dip`.
Model slide_model(const Slide& slide, double dt, int steps) {
  Model model;
  model.materials = {{"rock", 2600, 20e9 * std::max(1.0, slide.size), 0.2, PlaneState::stress}};
  model.joints = {JointMaterial{}};
  model.joints[0].friction_angle = slide.friction;
  double left = 0, top = 0;
  for (const double length : slide.bases) {
    model.held_blocks.emplace_back().block = static_cast<int>(model.blocks.size());
    model.blocks.push_back(
        rectangle(fmt::format("base {}", model.blocks.size() + 1), left, top - slide.size, length, slide.size));
    left += length + slide.opening;
    top -= slide.drop;
  }
  model.blocks.push_back(rectangle("block", 0, 0, slide.size, slide.height));
  model.blocks.back().initial_velocity = slide.velocity;
  for (Block& block : model.blocks) block = turned(block, -slide.dip);
  model.gravity = {0, -gravity_here};
  model.stages = {stage_of(generalized_alpha_integrator(0), dt, steps, Kinematics::finite)};
  return model;
}

const State& end_of(Simulation& simulation) {
  while (!simulation.finished()) EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
  return simulation.state();
}

// s = g (sin a - cos a tan f) t^2/2, whatever lies below.
TEST(Seam, BlocksSlideOverFlushOnesAsOverOne) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SeededNumbers random(seed);
    Slide slide;
    slide.size = random.magnitude(-2, 3);
    slide.height = slide.size * random.number(0.2, 0.5);
    slide.dip = random.number(10, 50) * std::numbers::pi / 180;
    slide.friction = slide.dip * random.number(0, 0.8);
    slide.bases = {1.2 * slide.size};
    double way = 0.2 * slide.size;
    for (int i = random.integer(4, 20); i > 0; --i) {
      slide.bases.push_back(slide.size * random.number(0.1, 1.5));
      way += slide.bases.back();
    }
    const double acceleration = gravity_here * (std::sin(slide.dip) - std::cos(slide.dip) * std::tan(slide.friction));
    const int steps = random.chance(0.5) ? 250 : 1000;  // up to 8 % and 2 % of the block's length in one
    const double time = 0.97 * std::sqrt(2 * way / acceleration);
    Simulation simulation = simulation_of(slide_model(slide, time / steps, steps));
    const double gone = end_of(simulation).displacement.back().head<2>().norm();
    // Springs and the block give way by some 1e-7 of it.
    EXPECT_NEAR(gone / (acceleration * time * time / 2), 1, 1e-5) << seed;
  }
}

TEST(Seam, LedgesThatGoDownAndOpenJointsDoNotHoldBack) {
  for (const double speed : {0.3, 3.0, 10.0})
    for (const auto& [drop, opening] : {std::pair{1e-3, 0.0}, {5e-3, 0.0}, {0.0, 1e-3}, {1e-3, 1e-3}, {1e-5, 1e-5}}) {
      Slide slide;
      slide.bases = {2, 8};
      slide.drop = drop;
      slide.opening = opening;
      slide.velocity = {speed, 0};
      Simulation simulation = simulation_of(slide_model(slide, 1e-3, static_cast<int>(1.3 / speed / 1e-3)));
      EXPECT_NEAR(end_of(simulation).velocity.back().x() / speed, 1, 1e-6) << speed << ' ' << drop << ' ' << opening;
    }
}

// A step of a hundredth of the block's size, ten times what sides in line may differ: the block stops or turns over it.
TEST(Seam, LedgesThatGoUpStopIt) {
  for (const double rise : {1e-2, 5e-2})
    for (const double speed : {0.3, 3.0}) {
      Slide slide;
      slide.bases = {2, 8};
      slide.drop = -rise;
      slide.velocity = {speed, 0};
      Simulation simulation = simulation_of(slide_model(slide, 1e-3, static_cast<int>(1.3 / speed / 1e-3)));
      EXPECT_LT(end_of(simulation).displacement.back().x(), 1.001) << speed << ' ' << rise;
    }
}

}  // namespace
}  // namespace dda
