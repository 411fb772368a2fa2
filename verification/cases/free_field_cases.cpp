#include "verification/cases/free_field_cases.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "engine/builder/generators.h"
#include "verification/cases/bar_case.h"
#include "verification/harness/histories.h"
#include "verification/harness/recorded_run.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

using dda::Vec2;

constexpr double depth = 20;  // m
constexpr double width = 30;  // m
constexpr double duration = 0.6;
constexpr double dt = 2e-3;
constexpr double pulse = 0.2;  // s, of the base

// The lower half stiffer than the upper one.
const std::array soils{dda::Material{"stiff", 2000, 500e6, 0.3, dda::PlaneState::strain},
                       dda::Material{"soft", 1900, 200e6, 0.3, dda::PlaneState::strain}};

int soil_at(double y) { return y < depth / 2 ? 0 : 1; }

int rows_of(double block) { return static_cast<int>(std::lround(depth / block)); }

// Layers of square blocks on a base that shakes along x; row by row, the base last.
dda::Model layers(int columns, double block) {
  dda::Model model;
  model.materials.assign(soils.begin(), soils.end());
  dda::JointMaterial bond;
  bond.bonded = true;
  model.joints = {bond};
  const int rows = rows_of(block);
  dda::append_grid(model, {.columns = columns, .rows = rows, .block_width = block, .block_height = block});
  for (int i = 0; i < columns * rows; ++i) {
    const int row = i / columns;
    model.blocks[static_cast<std::size_t>(i)].material = soil_at((row + 0.5) * block);
  }
  const double right = columns * block;
  model.blocks.emplace_back().shape.outer = {{0, -1}, {right, -1}, {right, 0}, {0, 0}};
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

void measure(int block, const Vec2& at, dda::Model& model) {
  for (const auto& [name, quantity] :
       {std::pair{"velocity", dda::Quantity::velocity_x}, {"stress", dda::Quantity::stress_xy}})
    model.measurements.push_back({fmt::format("{} {}", name, block), quantity, block, -1, at});
}

// Velocity and shear stress of every row of a column that only shears: the free field.
RecordedRun free_field(double block) {
  dda::Model model = layers(1, block);
  for (int row = 0; row < rows_of(block); ++row) {
    for (const dda::Vec2& corner : model.blocks[static_cast<std::size_t>(row)].shape.outer)
      model.supports.push_back({row, corner, false, true, 1e6 * soils[0].young, Vec2::Zero(), {}});
    measure(row, {block / 2, (row + 0.5) * block}, model);
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
void add_side(double block, bool right, const RecordedRun* field, dda::Model& model) {
  const int columns = static_cast<int>(std::lround(width / block));
  const double x = right ? width : 0;
  for (int row = 0; row < rows_of(block); ++row) {
    const int at = row * columns + (right ? columns - 1 : 0);
    const Vec2 from(x, row * block);
    const Vec2 to(x, (row + 1) * block);
    const dda::Material& soil = soils[static_cast<std::size_t>(soil_at((from.y() + to.y()) / 2))];
    const double normal = soil.density * dda::p_wave_speed(soil);
    model.viscous_edges.push_back({at, from, to, normal, soil.density * dda::s_wave_speed(soil)});
    if (field == nullptr) continue;
    const auto velocity = 2 * static_cast<std::size_t>(row);
    model.edge_loads.push_back({at, from, to, {normal, 0}, table_of(field->histories[velocity])});
    model.edge_loads.push_back({at, from, to, {0, right ? 1.0 : -1.0}, table_of(field->histories[velocity + 1])});
  }
}

// Largest difference of any measured velocity and stress from the free field's in that row, of the field's largest.
struct Differences {
  double velocity = 0, stress = 0;
};

Differences largest_differences(const RecordedRun& run, const RecordedRun& field) {
  Differences difference, scale;
  for (std::size_t i = 0; i < run.histories.size(); ++i) {
    const std::vector<double>& expected = field.histories[i % field.histories.size()];
    for (std::size_t step = 0; step < expected.size(); ++step) {
      keep_largest(i % 2 == 0 ? difference.velocity : difference.stress, run.histories[i][step] - expected[step]);
      keep_largest(i % 2 == 0 ? scale.velocity : scale.stress, expected[step]);
    }
  }
  return {difference.velocity / scale.velocity, difference.stress / scale.stress};
}

Differences difference(double block, bool follows, Outcome& outcome) {
  const RecordedRun field = free_field(block);
  outcome.counters += field.counters;
  const int columns = static_cast<int>(std::lround(width / block));
  dda::Model model = layers(columns, block);
  for (const bool right : {false, true}) add_side(block, right, follows ? &field : nullptr, model);
  for (const int column : {0, columns / 8, columns / 2, columns - 1})
    for (int row = 0; row < rows_of(block); ++row)
      measure(row * columns + column, {(column + 0.5) * block, (row + 0.5) * block}, model);
  dda::finish_model(model);
  const RecordedRun run = record_run(model);
  outcome.counters += run.counters;
  return largest_differences(run, field);
}

Outcome sides() {
  Outcome outcome;
  const Differences coarse = difference(1, true, outcome);
  const Differences fine = difference(0.5, true, outcome);
  const std::string source = "column of the same layers that only shears";
  outcome.assertions.push_back(
      expect("largest difference of any velocity from that of the column, of its largest", "-")
          .is(coarse.velocity)
          .against(0, source)
          .absolutely()
          .of_order({order(coarse.velocity, fine.velocity), 2, 0.1})
          .within(2e-3,
                  "the column's velocity varies along a block's side, the load that brings it there does "
                  "not; measured with margin"));
  outcome.assertions.push_back(
      expect("largest difference of any shear stress from that of the column, of its largest", "-")
          .is(coarse.stress)
          .against(0, source)
          .absolutely()
          .of_order({order(coarse.stress, fine.stress), 1, 0.2})
          .within(3e-3, "the moment that the load lacks is first felt by the strains of the blocks on the sides"));
  const Differences alone = difference(1, false, outcome);
  outcome.assertions.push_back(expect("the same of the velocity where the sides have dashpots alone, against 1", "-")
                                   .is(alone.velocity)
                                   .against(1, "they hold the sides back")
                                   .absolutely()
                                   .within(0.5, "that the case tells one from the other; measured with margin"));
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
