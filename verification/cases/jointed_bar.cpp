#include "verification/cases/jointed_bar.h"

#include <cstddef>
#include <string>
#include <utility>

#include "engine/builder/generators.h"
#include "engine/contact/interface_element.h"
#include "engine/contact/make_element.h"
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

constexpr double height = 1;  // m

// An absorbing end takes up as much again as the wave that it lets in.
void add_ends(const JointedBar& bar, dda::Model& model) {
  const double right = bar.blocks * bar.block_length;
  const int last = bar.blocks - 1;
  const bool is_p = bar.kind == WaveKind::p;
  const double normal = is_p ? bar.impedance() : 0;
  const double shear = is_p ? 0 : bar.impedance();
  model.viscous_edges = {{last, {right, 0}, {right, 1}, bar.end_ratio * normal, bar.end_ratio * shear}};
  if (bar.absorbing_start) model.viscous_edges.push_back({0, {0, 1}, {0, 0}, normal, shear});
  const double push = bar.absorbing_start ? -2 : -1;
  const dda::Vec2 traction = is_p ? dda::Vec2(push, 0) : dda::Vec2(0, push);
  model.edge_loads = {{0, {0, 1}, {0, 0}, traction, pushed(bar)}};
  if (bar.initial_pressure == 0) return;
  model.edge_loads.push_back({0, {0, 1}, {0, 0}, {bar.initial_pressure, 0}, dda::Constant{}});
  model.edge_loads.push_back({last, {right, 0}, {right, 1}, {-bar.initial_pressure, 0}, dda::Constant{}});
}

// N/m: a millionth of the shear strain goes into the supports.
constexpr double sideways_stiffness = 1e6 * young;

void hold_sideways(dda::Model& model) {
  for (std::size_t i = 0; i < model.blocks.size(); ++i)
    for (const dda::Vec2& corner : model.blocks[i].shape.outer)
      model.supports.push_back({static_cast<int>(i), corner, true, false, sideways_stiffness, dda::Vec2::Zero(), {}});
}

dda::Model model_of(const JointedBar& bar) {
  dda::Model model;
  model.materials = {{"rock", density, young, poisson, dda::PlaneState::stress}};
  dda::JointMaterial bond;
  bond.bonded = true;
  model.joints = {bond, bar.special};
  for (const int left : bar.special_at) model.joint_of_block_pair[{left, left + 1}] = 1;
  dda::append_bar(model, {.length = bar.blocks * bar.block_length, .height = height, .block_length = bar.block_length});
  for (dda::Block& block : model.blocks) block.initial_stress(0) = -bar.initial_pressure;
  add_ends(bar, model);
  if (bar.kind == WaveKind::s) hold_sideways(model);
  const auto quantity = bar.kind == WaveKind::p ? dda::Quantity::stress_xx : dda::Quantity::stress_xy;
  for (const int block : bar.probes)
    model.measurements.push_back(
        {"probe " + std::to_string(block), quantity, block, -1, {(block + 0.5) * bar.block_length, 0.5}});
  dda::Stage stage;
  stage.kinematics = dda::Kinematics::small;
  stage.integrator = bar.integrator;
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

exact::BlockChain shear_chain_of(const JointedBar& bar) {
  const dda::Model model = model_of(bar);
  const dda::Vec4 k =
      dda::make_element(model, dda::find_interfaces(model).front(), dda::InterfaceLaw::consistent).stiffness;
  exact::BlockChain chain;
  chain.blocks = bar.blocks;
  chain.length = bar.block_length;
  chain.height = height;
  chain.density = density;
  chain.elasticity = {young / (2 * (1 + poisson)), 0};
  chain.interface = exact::consistent_edge(k(1), 0);
  chain.end_impedance = bar.end_ratio * bar.impedance() * height;
  return chain;
}

std::vector<std::vector<double>> stress_histories(const JointedBar& bar, dda::Counters& counters) {
  RecordedRun run = record_run(model_of(bar));
  counters += run.counters;
  return std::move(run.histories);
}

}  // namespace verify
