#include "verification/cases/lame_mode_cases.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "engine/builder/generators.h"
#include "engine/simulation/simulation.h"
#include "verification/cases/bar_case.h"
#include "verification/cases/swing.h"
#include "verification/exact/wave_speeds.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double side = 10;  // m
constexpr double density = 2650;
constexpr double young = 50e9;
constexpr double poisson = 0.25;

// u = (cos(pi x/a) sin(pi y/a), -sin(pi x/a) cos(pi y/a)): no change of area, and no traction on any side of the
// square.
dda::Vec2 shape(const dda::Vec2& at) {
  const double x = pi * at.x() / side;
  const double y = pi * at.y() / side;
  return {std::cos(x) * std::sin(y), -std::sin(x) * std::cos(y)};
}

double shape_rotation(const dda::Vec2& at) {
  return -pi / side * std::cos(pi * at.x() / side) * std::cos(pi * at.y() / side);
}

dda::Model free_square(int blocks_along_side, double dt, double duration) {
  dda::Model model;
  model.materials = {{"rock", density, young, poisson, dda::PlaneState::stress}};
  dda::JointMaterial bond;
  bond.bonded = true;
  model.joints = {bond};
  const double size = side / blocks_along_side;
  dda::append_grid(
      model, {.columns = blocks_along_side, .rows = blocks_along_side, .block_width = size, .block_height = size});
  dda::Stage stage;
  stage.kinematics = dda::Kinematics::small;
  stage.dt = dt;
  stage.duration = duration;
  model.stages = {stage};
  dda::finish_model(model);
  for (dda::Block& block : model.blocks) {
    block.initial_velocity = shape(block.moments.centroid);
    block.initial_spin = shape_rotation(block.moments.centroid);
  }
  return model;
}

Outcome lame_mode() {
  constexpr int steps_in_period = 60;
  Outcome outcome;
  const double expected = std::sqrt(2.0) * pi * exact::s_speed(young, poisson, density) / side;
  double coarser = 0;
  for (const int blocks : {8, 16, 32}) {
    const double dt = 2 * pi / expected / steps_in_period;
    dda::Simulation simulation(free_square(blocks, dt, 2.5 * steps_in_period * dt));
    const double omega = swing_frequency(simulation, shape, 4);
    outcome.counters += simulation.counters();
    const double error = relative_error(omega, expected);
    Assertion row =
        expect(fmt::format("frequency of the Lame mode, {0} x {0} blocks", blocks), "rad/s")
            .is(omega)
            .against(expected, "sqrt(2) pi c_S/a")
            .off_by(error)
            .within(6e-3 * 64 / (blocks * blocks),
                    "an independent prototype: 4.1e-3, 1.2e-3 and 3.1e-4 at 8, 16 and 32 blocks, with margin");
    if (blocks == 32) row.order = Order{order(coarser, error), 2, 0.15};
    outcome.assertions.push_back(row);
    coarser = error;
  }
  return outcome;
}

}  // namespace

std::vector<Case> lame_mode_cases() {
  return {{"lame-mode", "A free square swings without change of area", {30}, CaseLabel::fast, lame_mode}};
}

}  // namespace verify
