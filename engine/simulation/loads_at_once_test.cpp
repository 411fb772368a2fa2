// Loads that come at once in static stages without dt leave no stress that friction locks in on the way.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/geometry/cut_pieces.h"
#include "engine/simulation/projected_models.h"

namespace dda {
namespace {

constexpr double pressure = 1e6;  // Pa

// The directions of a square's sides, counter-clockwise from the lower one.
constexpr std::array<std::pair<int, int>, 5> corners_of_square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}};

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
      for (const auto& [x, y] : std::span(corners_of_square).first(4)) ring.push_back(at(column + x, row + y));
      const std::array<bool, 4> is_outside{row == 0, column + 1 == columns, row + 1 == rows, column == 0};
      for (std::size_t side = 0; side < 4; ++side) {
        const Vec2 from = ring[side], to = ring[(side + 1) % 4];
        const Vec2 inwards((from - to).y(), (to - from).x());
        if (!is_outside[side]) continue;
        model.edge_loads.push_back({row * columns + column, from, to, pressure * inwards, Constant{}, {}, {0, 0}});
      }
      model.blocks.emplace_back().shape.outer = std::move(ring);
    }
  const double stiffness = rock().young * random.number(1, 30);
  PointSupport& pin = model.supports.emplace_back();
  pin.point = at(random.number(0.1, 0.9), 0);
  pin.stiffness = stiffness;
  PointSupport roller = pin;
  roller.block = columns - 1;
  roller.point = at(columns - random.number(0.1, 0.9), 0);
  roller.direction = at(0, 1);
  model.supports.push_back(roller);
  return model;
}

// By how much of the pressure the stress of a block is off it, at most.
double off_pressure(Model model) {
  Simulation simulation = simulation_of(std::move(model));
  Status status = Status::ok;
  while (!simulation.finished() && status == Status::ok) status = simulation.step();
  EXPECT_EQ(status, Status::ok) << simulation.message();
  double off = 0;
  for (const Vec3& stress : simulation.state().stress)
    off = std::max(off, (stress - Vec3(-pressure, -pressure, 0)).norm() / pressure);
  return off;
}

// In short first steps squares beside the points slipped before anything pressed them together, and that stayed: 0.17
// of the pressure in 10 by 10 squares, 0.4 in 20 by 20.
TEST(LoadsAtOnce, LeaveNoStressLockedIn) {
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    SeededNumbers random(seed);
    const int columns = 2 + static_cast<int>(random.number(0, 10)), rows = 2 + static_cast<int>(random.number(0, 10));
    const double friction = random.number(0.15, 1), turned = random.number(0, 3);
    Model model = pressed_squares(columns, rows, friction, turned, random);
    model.stages = {stage_of(static_integrator(), 0, 0, seed % 2 == 0 ? Kinematics::small : Kinematics::finite)};
    model.stages[0].equilibrium = 1e-9;
    EXPECT_LT(off_pressure(std::move(model)), 2e-3) << columns << " x " << rows << ", seed " << seed;
  }
}

}  // namespace
}  // namespace dda
