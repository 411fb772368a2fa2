// The phases of a step and of the set-up by themselves: assembly, one contact pass, finding interfaces, building a
// Simulation. Solves are in linear_benchmark.cpp.
#include <benchmark/benchmark.h>

#include <utility>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/contact/make_contacts.h"
#include "engine/contact/open_close.h"
#include "engine/simulation/linear_operators.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/system_matrix.h"
#include "scenes.h"

namespace dda::benchmarks {
namespace {

Model bar_of_200(Joints joints) { return bar(200, joints); }
Model grid_of_10000(Joints joints) { return grid(100, joints, Kinematics::small); }

void set_size(benchmark::State& state, const Model& model, const ContactSet& contacts) {
  state.counters["blocks"] = static_cast<double>(model.blocks.size());
  state.counters["contacts"] = static_cast<double>(contacts.interfaces.size());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(model.blocks.size()));
}

// All values of the step matrix from blocks and interfaces, as after a change of statuses or of geometry.
void assemble_general(benchmark::State& state, const Model& model) {
  const ContactSet contacts = make_contacts(model);
  const BlockTerms terms = make_block_terms(model);
  const StepCoefficients step = step_coefficients(model.stages[0].integrator, model.stages[0].dt);
  const std::vector<Vec4> all_rows(contacts.elements.size(), Vec4::Ones());
  BlockMatrix matrix = make_system_matrix(static_cast<int>(model.blocks.size()), contacts);
  for (auto _ : state) {
    assemble(step, terms, {}, {}, contacts, all_rows, matrix);
    benchmark::ClobberMemory();
  }
  set_size(state, model, contacts);
}

// The constant operators of a linear scene, once a stage.
void build_operators(benchmark::State& state, const Model& model) {
  const ContactSet contacts = make_contacts(model);
  const BlockTerms terms = make_block_terms(model);
  for (auto _ : state) {
    const WaveCorrections waves(model, model.stages[0], contacts);
    LinearOperators operators(model, terms, contacts, {}, waves);
    benchmark::DoNotOptimize(operators);
  }
  set_size(state, model, contacts);
}

// The step matrix out of the operators, once a step size.
void assemble_linear(benchmark::State& state, const Model& model) {
  const ContactSet contacts = make_contacts(model);
  const BlockTerms terms = make_block_terms(model);
  const WaveCorrections waves(model, model.stages[0], contacts);
  const LinearOperators operators(model, terms, contacts, {}, waves);
  const StepCoefficients step = step_coefficients(model.stages[0].integrator, model.stages[0].dt);
  BlockMatrix matrix = make_system_matrix(static_cast<int>(model.blocks.size()), contacts);
  for (auto _ : state) {
    assemble(step, operators, {}, matrix);
    benchmark::ClobberMemory();
  }
  set_size(state, model, contacts);
}

// Gaps and answers of all interfaces after a solve.
void contact_pass(benchmark::State& state, const Model& model) {
  const ContactSet contacts = make_contacts(model);
  std::vector<InterfaceTrial> trial;
  for (std::size_t i = 0; i < contacts.elements.size(); ++i)
    trial.push_back(start_trial(contacts.elements.own()[i], contacts.strengths[i], contacts.states[i]));
  // Blocks drift apart by little enough for the joints to hold.
  const Eigen::VectorXd d = 1e-9 * Eigen::VectorXd::LinSpaced(static_cast<Eigen::Index>(6 * model.blocks.size()), 0, 1);
  bool gave_way = false;
  for (auto _ : state) {
    for (std::size_t i = 0; i < trial.size(); ++i) {
      const InterfaceElement& element = contacts.elements.own()[i];
      trial[i].gap = contacts.states[i].gap + gap_increment(element, d);
      respond(element, trial[i]);
      gave_way |= update_capacity(element, contacts.strengths[i], trial[i]) > 0;
      gave_way |= break_ends(element, contacts.strengths[i], trial[i]);
    }
    benchmark::ClobberMemory();
  }
  if (gave_way) state.SkipWithError("a joint gave way");
  set_size(state, model, contacts);
}

void find_all_interfaces(benchmark::State& state, const Model& model) {
  ContactSet contacts;
  for (auto _ : state) {
    contacts.interfaces = find_interfaces(model);
    benchmark::DoNotOptimize(contacts);
  }
  set_size(state, model, contacts);
}

void finish(benchmark::State& state, const Model& model) {
  for (auto _ : state) {
    Model again = model;
    finish_model(again);
    benchmark::DoNotOptimize(again);
  }
  set_size(state, model, {});
}

// Interfaces, elements, operators and the analysis of the matrix; the first step factors.
void build_simulation(benchmark::State& state, const Model& model) {
  ContactSet contacts;
  for (auto _ : state) {
    const Simulation simulation(model);
    state.PauseTiming();
    contacts.interfaces = simulation.contacts().interfaces;
    state.ResumeTiming();
  }
  set_size(state, model, contacts);
}

void of_bar(benchmark::State& state, void (*phase)(benchmark::State&, const Model&), Joints joints) {
  phase(state, bar_of_200(joints));
}

void of_grid(benchmark::State& state, void (*phase)(benchmark::State&, const Model&), Joints joints) {
  phase(state, grid_of_10000(joints));
}

// Registers `phase` on the bar of 200 blocks and on the grid of 10,000.
#define DDA_PHASE(name, phase, joints)                               \
  BENCHMARK_CAPTURE(of_bar, phase##_##joints, phase, Joints::joints) \
      ->Name(name "/bar")                                            \
      ->Unit(benchmark::kMicrosecond);                               \
  BENCHMARK_CAPTURE(of_grid, phase##_##joints, phase, Joints::joints)->Name(name "/grid")->Unit(benchmark::kMicrosecond)

DDA_PHASE("assembly/springs", assemble_general, bonded_springs);
DDA_PHASE("assembly/consistent", assemble_general, consistent);
DDA_PHASE("assembly/linear_consistent", assemble_linear, consistent);
DDA_PHASE("assembly/linear_cubic", assemble_linear, cubic);
DDA_PHASE("assembly/operators_consistent", build_operators, consistent);
DDA_PHASE("assembly/operators_cubic", build_operators, cubic);
DDA_PHASE("contact/pass", contact_pass, strong_springs);
DDA_PHASE("setup/interfaces", find_all_interfaces, strong_springs);
DDA_PHASE("setup/finish_model", finish, strong_springs);
DDA_PHASE("setup/simulation_consistent", build_simulation, consistent);
DDA_PHASE("setup/simulation_springs", build_simulation, strong_springs);

}  // namespace
}  // namespace dda::benchmarks
