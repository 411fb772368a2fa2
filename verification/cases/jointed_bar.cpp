#include "verification/cases/jointed_bar.h"

#include <cstddef>
#include <string>
#include <utility>

#include "dda/scene/generators.h"
#include "verification/exact/wave_speeds.h"
#include "verification/harness/recorded_run.h"

namespace verify {
namespace {

constexpr double density = 2650;
constexpr double young = 50e9;
constexpr double poisson = 0.25;

dda::TimeFunction pushed(const JointedBar& bar) {
  dda::PiecewiseLinear table;
  for (int i = 0; i <= bar.steps; ++i) {
    table.times.push_back(i * bar.dt);
    table.values.push_back(bar.incident(i * bar.dt));
  }
  return table;
}

// An absorbing end takes up as much again as the wave that it lets in.
void add_ends(const JointedBar& bar, dda::Model& model) {
  const double right = bar.blocks * bar.block_length;
  const int last = bar.blocks - 1;
  const bool is_p = bar.kind == WaveKind::p;
  const double normal = is_p ? bar.impedance() : 0;
  const double shear = is_p ? 0 : bar.impedance();
  model.viscous_edges = {{0, {0, 1}, {0, 0}, normal, shear}, {last, {right, 0}, {right, 1}, normal, shear}};
  const dda::Vec2 traction = is_p ? dda::Vec2(-2, 0) : dda::Vec2(0, -2);
  model.edge_loads = {{0, {0, 1}, {0, 0}, traction, pushed(bar)}};
  if (bar.initial_pressure == 0) return;
  model.edge_loads.push_back({0, {0, 1}, {0, 0}, {bar.initial_pressure, 0}, dda::Constant{}});
  model.edge_loads.push_back({last, {right, 0}, {right, 1}, {-bar.initial_pressure, 0}, dda::Constant{}});
}

void hold_sideways(dda::Model& model) {
  for (std::size_t i = 0; i < model.blocks.size(); ++i)
    for (const dda::Vec2& corner : model.blocks[i].shape.outer)
      model.supports.push_back({static_cast<int>(i), corner, true, false, 1e3 * young, dda::Vec2::Zero(), {}});
}

dda::Model model_of(const JointedBar& bar) {
  dda::Model model;
  model.materials = {{"rock", density, young, poisson, dda::PlaneState::stress}};
  dda::JointMaterial bond;
  bond.bonded = true;
  model.joints = {bond, bar.special};
  for (const int left : bar.special_at) model.joint_of_block_pair[{left, left + 1}] = 1;
  dda::append_bar(model, {.length = bar.blocks * bar.block_length, .height = 1, .block_length = bar.block_length});
  for (dda::Block& block : model.blocks) block.initial_stress(0) = -bar.initial_pressure;
  add_ends(bar, model);
  if (bar.kind == WaveKind::s) hold_sideways(model);
  const auto quantity = bar.kind == WaveKind::p ? dda::Quantity::stress_xx : dda::Quantity::stress_xy;
  for (const int block : bar.probes)
    model.measurements.push_back(
        {"probe " + std::to_string(block), quantity, block, -1, {(block + 0.5) * bar.block_length, 0.5}});
  dda::Stage stage;
  stage.kinematics = dda::Kinematics::small;
  stage.dt = bar.dt;
  stage.duration = bar.steps * bar.dt;
  model.stages = {stage};
  dda::finish_model(model);
  return model;
}

}  // namespace

double JointedBar::speed() const {
  return kind == WaveKind::p ? exact::bar_speed(young, density) : exact::s_speed(young, poisson, density);
}

double JointedBar::impedance() const { return density * speed(); }

std::vector<std::vector<double>> stress_histories(const JointedBar& bar, dda::Counters& counters) {
  RecordedRun run = record_run(model_of(bar));
  counters += run.counters;
  return std::move(run.histories);
}

}  // namespace verify
