#include "verification/cases/free_field_cases.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "dda/scene/generators.h"
#include "verification/cases/bar_case.h"
#include "verification/harness/histories.h"
#include "verification/harness/recorded_run.h"

namespace verify {
namespace {

using dda::Vec2;

constexpr int rows = 20;  // of blocks of 1 m
constexpr double duration = 0.6;
constexpr double dt = 2e-3;
constexpr double pulse = 0.2;  // s, of the base

// The lower half stiffer than the upper one.
const std::array soils{dda::Material{"stiff", 2000, 500e6, 0.3, dda::PlaneState::strain},
                       dda::Material{"soft", 1900, 200e6, 0.3, dda::PlaneState::strain}};

int soil_of(int row) { return row < rows / 2 ? 0 : 1; }

// Layers on a base that shakes along x; blocks row by row, the base last.
dda::Model layers(int columns) {
  dda::Model model;
  model.materials.assign(soils.begin(), soils.end());
  dda::JointMaterial bond;
  bond.bonded = true;
  model.joints = {bond};
  dda::append_grid(model, {.columns = columns, .rows = rows, .block_width = 1, .block_height = 1});
  for (int i = 0; i < columns * rows; ++i) model.blocks[static_cast<std::size_t>(i)].material = soil_of(i / columns);
  const double width = columns;
  model.blocks.emplace_back().shape.outer = {{0, -1}, {width, -1}, {width, 0}, {0, 0}};
  dda::PiecewiseLinear shaking;
  const auto shape = smooth_push(1, pulse);
  for (int i = 0; i * dt < duration + dt; ++i) {
    shaking.times.push_back(i * dt);
    shaking.values.push_back(shape(i * dt) - shape(i * dt - pulse));
  }
  dda::HeldBlock base;
  base.block = columns * rows;
  base.amplitude = {1, 0};
  base.history = shaking;
  base.kind = dda::MotionKind::acceleration;
  model.held_blocks = {base};
  dda::Stage stage;
  stage.kinematics = dda::Kinematics::small;
  stage.integrator = dda::generalized_alpha_integrator(0.8);
  stage.dt = dt;
  stage.duration = duration;
  model.stages = {stage};
  return model;
}

void measure(int block, double x, int row, dda::Model& model) {
  for (const auto& [name, quantity] : {std::pair{"velocity", dda::Quantity::velocity_x},
                                       {"stress", dda::Quantity::stress_xy}})
    model.measurements.push_back({fmt::format("{} {}", name, block), quantity, block, -1, {x, row + 0.5}});
}

// Velocity and shear stress of every row of a column that only shears: the free field.
RecordedRun free_field() {
  dda::Model model = layers(1);
  for (int row = 0; row < rows; ++row) {
    for (const dda::Vec2& corner : model.blocks[static_cast<std::size_t>(row)].shape.outer)
      model.supports.push_back({row, corner, false, true, 1e6 * soils[0].young, Vec2::Zero(), {}});
    measure(row, 0.5, row, model);
  }
  dda::finish_model(model);
  return record_run(model);
}

dda::PiecewiseLinear table_of(const std::vector<double>& values) {
  dda::PiecewiseLinear table;
  for (std::size_t i = 0; i < values.size(); ++i) {
    table.times.push_back(static_cast<double>(i) * dt);
    table.values.push_back(values[i]);
  }
  return table;
}

// Dashpots on the motion relative to the free field, and the stress of the free field.
void add_side(int columns, bool right, const RecordedRun* field, dda::Model& model) {
  const double x = right ? columns : 0;
  for (int row = 0; row < rows; ++row) {
    const int block = row * columns + (right ? columns - 1 : 0);
    const dda::Material& soil = soils[static_cast<std::size_t>(soil_of(row))];
    const double normal = soil.density * dda::p_wave_speed(soil);
    const Vec2 from(x, row);
    const Vec2 to(x, row + 1);
    model.viscous_edges.push_back({block, from, to, normal, soil.density * dda::s_wave_speed(soil)});
    if (field == nullptr) continue;
    const auto velocity = static_cast<std::size_t>(2 * row);
    model.edge_loads.push_back({block, from, to, {normal, 0}, table_of(field->histories[velocity])});
    model.edge_loads.push_back({block, from, to, {0, right ? 1.0 : -1.0}, table_of(field->histories[velocity + 1])});
  }
}

// Largest difference of any measured velocity and stress from the free field's in that row, of their peaks.
struct Differences {
  double velocity = 0, stress = 0;
};

Differences difference(const RecordedRun& field, bool follows, Outcome& outcome) {
  constexpr int columns = 30;
  dda::Model model = layers(columns);
  add_side(columns, false, follows ? &field : nullptr, model);
  add_side(columns, true, follows ? &field : nullptr, model);
  const std::array<int, 4> probed_columns{0, 3, 15, columns - 1};
  for (const int column : probed_columns)
    for (int row = 0; row < rows; ++row) measure(row * columns + column, column + 0.5, row, model);
  dda::finish_model(model);
  const RecordedRun run = record_run(model);
  outcome.counters += run.counters;
  Differences largest;
  for (std::size_t i = 0; i < run.histories.size(); ++i)
    keep_largest(i % 2 == 0 ? largest.velocity : largest.stress,
                 largest_difference(run.histories[i], field.histories[i % (2 * rows)]));
  return largest;
}

Outcome sides() {
  Outcome outcome;
  const RecordedRun field = free_field();
  outcome.counters += field.counters;
  const Differences follows = difference(field, true, outcome);
  const Differences alone = difference(field, false, outcome);
  fmt::print("follows {} {} alone {} {}\n", follows.velocity, follows.stress, alone.velocity, alone.stress);
  return outcome;
}

}  // namespace

std::vector<Case> free_field_cases() {
  return {{"free-field-sides",
           "Layers of soil shaken from below, their sides tied to the free field",
           {39},
           CaseLabel::fast,
           sides}};
}

}  // namespace verify
