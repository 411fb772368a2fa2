#include "verification/cases/soil_column_cases.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "engine/builder/generators.h"
#include "verification/cases/bar_case.h"
#include "verification/cases/swing.h"
#include "verification/exact/wave_speeds.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double depth = 40;  // m
constexpr double density = 1900;
constexpr double young = 200e6;
constexpr double poisson = 0.3;

// Horizontal motion of the first mode: a quarter of a wave.
dda::Vec2 shape(const dda::Vec2& at) { return {std::sin(pi * at.y() / (2 * depth)), 0}; }

// Layers one above the other on a held base; every corner is held vertically, so that they only shear.
dda::Model column(int layers, double dt, double duration) {
  dda::Model model;
  model.materials = {{"soil", density, young, poisson, dda::PlaneState::strain}};
  dda::JointMaterial bond;
  bond.bonded = true;
  model.joints = {bond};
  dda::append_grid(model, {.columns = 1, .rows = layers, .block_width = 1, .block_height = depth / layers});
  for (std::size_t i = 0; i < model.blocks.size(); ++i)
    for (const dda::Vec2& corner : model.blocks[i].shape.outer)
      model.supports.push_back(
          {static_cast<int>(i), corner, corner.y() == 0, true, 1e6 * young, dda::Vec2::Zero(), {}});
  dda::Stage stage;
  stage.kinematics = dda::Kinematics::small;
  stage.dt = dt;
  stage.duration = duration;
  model.stages = {stage};
  dda::finish_model(model);
  for (dda::Block& block : model.blocks) {
    block.initial_velocity = shape(block.moments.centroid);
    block.initial_spin = -pi / (4 * depth) * std::cos(pi * block.moments.centroid.y() / (2 * depth));
  }
  return model;
}

Outcome first_frequency() {
  constexpr int steps_in_period = 200;
  Outcome outcome;
  const double expected = exact::s_speed(young, poisson, density) / (4 * depth);  // Hz
  const auto error_of = [&](int layers) {
    const double dt = 1 / (expected * steps_in_period);
    dda::Simulation simulation(column(layers, dt, 3.5 / expected));
    const double frequency = swing_frequency(simulation, shape, 6) / (2 * pi);
    outcome.counters += simulation.counters();
    return relative_error(frequency, expected);
  };
  double coarser = 0;
  for (const int layers : {10, 20, 40}) {
    const double error = error_of(layers);
    const double omega = pi / 2 / layers;  // of one layer
    Assertion row = expect(fmt::format("first frequency of 40 m of soil, {} layers", layers), "Hz")
                        .is(expected * (1 + error))
                        .against(expected, "V_s/(4 H)")
                        .off_by(error)
                        .within(1.2 * omega * omega / 24, "Omega^2/24 and a margin");
    if (layers == 40) row.order = Order{order(coarser, error), 2, 0.2};
    outcome.assertions.push_back(row);
    coarser = error;
  }
  return outcome;
}

}  // namespace

std::vector<Case> soil_column_cases() {
  return {{"soil-column", "First frequency of a layer of soil", {39}, CaseLabel::fast, first_frequency}};
}

}  // namespace verify
