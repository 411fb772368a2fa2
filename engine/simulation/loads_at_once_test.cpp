// Loads that come at once in static stages without dt leave no stress that friction locks in on the way.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/geometry/cut_pieces.h"
#include "engine/simulation/projected_models.h"

namespace dda {
namespace {

constexpr double pressure = 1e6;  // Pa

// Counter-clockwise from the lower left one.
constexpr std::array<std::pair<int, int>, 4> corners_of_square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

void press(int block, const Vec2& from, const Vec2& to, Model& model) {
  const Vec2 inwards((from - to).y(), (to - from).x());
  model.edge_loads.push_back({block, from, to, pressure * inwards, Constant{}, {}, {0, 0}});
}

// Holds the first block at a point, and another one along `direction` alone.
void hold(const Vec2& point, int other_block, const Vec2& other_point, const Vec2& direction, double stiffness,
          Model& model) {
  PointSupport pin;
  pin.point = point;
  pin.stiffness = stiffness;
  PointSupport roller = pin;
  roller.block = other_block;
  roller.point = other_point;
  roller.direction = direction;
  model.supports = {pin, roller};
}

// Dry squares of 1 m, turned as a whole, under pressure from all sides on two points that take no force: their stress
// is that pressure everywhere, whatever the friction.
Model pressed_squares(int columns, int rows, double friction, double turned, SeededNumbers& random) {
  Model model;
  model.materials = {rock()};
  model.joints = {dry_projected(friction)};
  const Mat2 turn = Eigen::Rotation2D(turned).toRotationMatrix();
  const auto at = [&](double x, double y) -> Vec2 { return turn * Vec2(x, y); };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      Ring ring;
      for (const auto& [x, y] : corners_of_square) ring.push_back(at(column + x, row + y));
      const std::array<bool, 4> is_outside{row == 0, column + 1 == columns, row + 1 == rows, column == 0};
      for (std::size_t side = 0; side < 4; ++side)
        if (is_outside[side]) press(row * columns + column, ring[side], ring[(side + 1) % 4], model);
      model.blocks.emplace_back().shape.outer = std::move(ring);
    }
  const double stiffness = rock().young * random.number(1, 30);
  const Vec2 left = at(random.number(0.1, 0.9), 0), right = at(columns - random.number(0.1, 0.9), 0);
  hold(left, columns - 1, right, at(0, 1), stiffness, model);
  return model;
}

// Dry wedges around an opening under pressure from outside, on two points of its wall that take no force.
Model pressed_rings(int sectors, double friction) {
  constexpr std::array radii{3.0, 3.4, 3.9, 4.5, 5.2, 6.0, 7.0, 8.2, 9.5, 11.0, 13.0};
  Model model;
  model.materials = {rock()};
  model.joints = {dry_projected(friction)};
  const auto at = [&](std::size_t ring, int corner) -> Vec2 {
    const double angle = 2 * std::numbers::pi * corner / sectors;
    return radii[ring] * Vec2(std::cos(angle), std::sin(angle));
  };
  for (std::size_t ring = 0; ring + 1 < radii.size(); ++ring)
    for (int k = 0; k < sectors; ++k) {
      const Vec2 from = at(ring + 1, k), to = at(ring + 1, k + 1);
      if (ring + 2 == radii.size()) press(static_cast<int>(model.blocks.size()), from, to, model);
      model.blocks.emplace_back().shape.outer = {at(ring, k), from, to, at(ring, k + 1)};
    }
  const Vec2 middle = (at(0, 0) + at(0, 1)) / 2;
  hold(middle, sectors / 2, -middle, {0, 1}, 10 * rock().young, model);
  return model;
}

std::vector<Vec3> settled_stresses(Model model, const Stage& stage) {
  model.stages = {stage};
  Simulation simulation = simulation_of(std::move(model));
  Status status = Status::ok;
  while (!simulation.finished() && status == Status::ok) status = simulation.step();
  EXPECT_EQ(status, Status::ok) << simulation.message();
  return simulation.state().stress;
}

Stage settling(Kinematics kinematics) {
  Stage stage = stage_of(static_integrator(), 0, 0, kinematics);
  stage.equilibrium = 1e-9;
  return stage;
}

// By how much of the pressure the stress of a block is off it, at most.
double off_pressure(const std::vector<Vec3>& stresses) {
  double off = 0;
  for (const Vec3& stress : stresses) off = std::max(off, (stress - Vec3(-pressure, -pressure, 0)).norm() / pressure);
  return off;
}

// In short first steps squares beside the points slipped before anything pressed them together, and that stayed: 0.17
// of the pressure in 10 by 10 squares, 0.4 in 20 by 20.
TEST(LoadsAtOnce, LeaveNoStressLockedIn) {
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    SeededNumbers random(seed);
    const int columns = 2 + static_cast<int>(random.number(0, 10)), rows = 2 + static_cast<int>(random.number(0, 10));
    const double friction = random.number(0.15, 1), turned = random.number(0, 3);
    const Stage stage = settling(seed % 2 == 0 ? Kinematics::small : Kinematics::finite);
    const Model model = pressed_squares(columns, rows, friction, turned, random);
    EXPECT_LT(off_pressure(settled_stresses(model, stage)), 2e-3) << columns << " x " << rows << ", seed " << seed;
  }
}

// Some wedges slip wherever next to nothing presses them together, whatever the way, so that a few that slip must not
// stand in the way of the long step. Without friction's limit none slips, and the way does not matter.
TEST(LoadsAtOnce, LeaveNoStressLockedInAroundAnOpening) {
  for (const double friction : {0.1, 0.2, 0.4, 0.7}) {
    const Model model = pressed_rings(64, friction);
    Stage unlimited = settling(Kinematics::small);
    unlimited.unlimited_strength = true;
    const std::vector<Vec3> expected = settled_stresses(model, unlimited);
    const std::vector<Vec3> actual = settled_stresses(model, settling(Kinematics::small));
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_LT((actual[i] - expected[i]).norm(), 1e-2 * pressure) << "block " << i << ", friction " << friction;
  }
}

}  // namespace
}  // namespace dda
