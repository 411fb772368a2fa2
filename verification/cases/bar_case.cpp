#include "verification/cases/bar_case.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/builder/generators.h"
#include "engine/contact/interface_element.h"
#include "engine/contact/make_element.h"
#include "verification/exact/finite_chain.h"
#include "verification/exact/sharpened_load.h"
#include "verification/harness/recorded_run.h"

namespace verify {
namespace {

std::vector<double> sampled_push(const BarCase& bar) {
  std::vector<double> force(static_cast<std::size_t>(bar.steps) + 1);
  for (std::size_t i = 0; i < force.size(); ++i) force[i] = bar.push(static_cast<double>(i) * bar.stage.dt);
  return force;
}

// A table that passes through the samples; between them nothing is asked of it.
dda::PiecewiseLinear table_of(const std::vector<double>& force, double dt) {
  dda::PiecewiseLinear table;
  for (std::size_t i = 0; i < force.size(); ++i) {
    table.times.push_back(static_cast<double>(i) * dt);
    table.values.push_back(force[i]);
  }
  return table;
}

void add_right_end(const BarCase& bar, dda::Model& model) {
  const double right = bar.blocks * bar.block_length;
  const int last = bar.blocks - 1;
  if (bar.end_stiffness > 0)
    model.supports = {{last, {right, bar.height / 2}, true, false, bar.end_stiffness, dda::Vec2::Zero(), {}}};
  if (bar.end_impedance > 0)
    model.viscous_edges = {{last, {right, 0}, {right, bar.height}, bar.end_impedance / bar.height, 0}};
}

exact::InterfaceLaw interface_of(const BarCase& bar, const exact::BlockChain& chain) {
  if (bar.joint.law == dda::InterfaceLaw::cubic) {
    const double error = exact::period_error(scheme_of(bar.stage.integrator));
    return exact::cubic_edge(bar.stage.correct_time_dispersion ? exact::inertia_reduction(chain, error, bar.stage.dt)
                                                               : 0);
  }
  const dda::Model model = model_of(bar);
  const dda::Vec4 k = dda::make_element(model, dda::find_interfaces(model).front(), bar.joint.law).stiffness;
  return bar.joint.law == dda::InterfaceLaw::classical ? exact::corner_springs(k(0), k(1))
                                                       : exact::consistent_edge(k(0), k(3));
}

}  // namespace

std::string name_of(dda::InterfaceLaw law) {
  return law == dda::InterfaceLaw::classical    ? "classical"
         : law == dda::InterfaceLaw::consistent ? "consistent"
                                                : "cubic";
}

BarCase bonded_bar(dda::InterfaceLaw law, const dda::Integrator& integrator, double dt, int steps) {
  BarCase bar;
  bar.joint.law = law;
  bar.joint.bonded = true;
  bar.stage.integrator = integrator;
  bar.stage.kinematics = dda::Kinematics::small;
  bar.stage.dt = dt;
  bar.steps = steps;
  return bar;
}

dda::Model model_of(const BarCase& bar) {
  dda::Model model;
  model.materials = {bar.rock};
  model.joints = {bar.joint};
  dda::append_bar(model,
                  {.length = bar.blocks * bar.block_length, .height = bar.height, .block_length = bar.block_length});
  model.edge_loads = {{0, {0, bar.height}, {0, 0}, {1 / bar.height, 0}, table_of(sampled_push(bar), bar.stage.dt)}};
  add_right_end(bar, model);
  for (const int block : bar.probes) {
    const dda::Vec2 centre((block + 0.5) * bar.block_length, bar.height / 2);
    model.measurements.push_back({"stress " + std::to_string(block), dda::Quantity::stress_xx, block, -1, centre});
  }
  model.stages = {bar.stage};
  model.stages[0].duration = bar.steps * bar.stage.dt;
  dda::finish_model(model);
  return model;
}

exact::TimeScheme scheme_of(const dda::Integrator& integrator) {
  return {integrator.beta, integrator.gamma, integrator.alpha_m, integrator.alpha_f, 1};
}

exact::BlockChain chain_of(const BarCase& bar) {
  exact::BlockChain chain;
  chain.blocks = bar.blocks;
  chain.length = bar.block_length;
  chain.height = bar.height;
  chain.density = bar.rock.density;
  chain.elasticity = bar.rock.plane == dda::PlaneState::stress ? exact::plane_stress(bar.rock.young, bar.rock.poisson)
                                                               : exact::plane_strain(bar.rock.young, bar.rock.poisson);
  chain.inertia_factor = bar.stage.strain_inertia;
  chain.lateral_inertia = bar.joint.law == dda::InterfaceLaw::cubic && !bar.stage.lateral_inertia ? 0 : 1;
  chain.interface = interface_of(bar, chain);
  chain.end_stiffness = bar.end_stiffness;
  chain.end_impedance = bar.end_impedance;
  return chain;
}

Histories engine_histories(const BarCase& bar, dda::Counters& counters) {
  RecordedRun run = record_run(model_of(bar));
  counters += run.counters;
  return std::move(run.histories);
}

Histories closed_form_histories(const BarCase& bar) {
  std::vector<exact::ChainProbe> probes;
  for (const int block : bar.probes) probes.push_back({exact::ChainQuantity::block_stress, block});
  const exact::BlockChain chain = chain_of(bar);
  const std::vector<double> load = exact::sharpened(sampled_push(bar), exact::load_sharpening(chain, bar.stage.dt));
  return exact::finite_chain_response(chain, scheme_of(bar.stage.integrator), bar.stage.dt, load, probes);
}

std::function<double(double)> smooth_push(double force, double duration) {
  return [=](double t) {
    if (t <= 0 || t >= duration) return 0.0;
    return force * std::pow(std::sin(std::numbers::pi * t / duration), 4);
  };
}

double order(double coarse_error, double fine_error) { return std::log2(coarse_error / fine_error); }

}  // namespace verify
