// A bar of equal blocks, pushed at its left end: as a model for the engine and as the chain of the closed form.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/core/counters.h"
#include "engine/model/model.h"
#include "verification/exact/block_chain.h"
#include "verification/exact/time_scheme.h"

namespace verify {

struct BarCase {
  int blocks = 40;
  double block_length = 1;  // m
  double height = 0.5;      // m
  dda::Material rock{"rock", 2650, 50e9, 0.25, dda::PlaneState::stress};
  dda::JointMaterial joint;
  dda::Stage stage;  // dt, integrator and options; its duration follows from `steps`
  int steps = 100;
  std::function<double(double)> push;  // N at time t (s), on the left end, positive in +x; read once a step
  double end_stiffness = 0;            // N/m, of the right end
  double end_impedance = 0;            // N s/m, of the right end
  std::vector<int> probes{10};         // blocks whose axial stress is recorded
};

[[nodiscard]] std::string name_of(dda::InterfaceLaw law);

[[nodiscard]] BarCase bonded_bar(dda::InterfaceLaw law, const dda::Integrator& integrator, double dt, int steps);

[[nodiscard]] dda::Model model_of(const BarCase& bar);
[[nodiscard]] exact::BlockChain chain_of(const BarCase& bar);
[[nodiscard]] exact::TimeScheme scheme_of(const dda::Integrator& integrator);

// Stress histories (Pa) of the probes: sample i at t = i dt, the first at rest. What the engine did is added to
// `counters`.
using Histories = std::vector<std::vector<double>>;
[[nodiscard]] Histories engine_histories(const BarCase& bar, dda::Counters& counters);
[[nodiscard]] Histories closed_form_histories(const BarCase& bar);

// Three times continuously differentiable: force * sin^4(pi t/duration) within the duration, else 0.
[[nodiscard]] std::function<double(double)> smooth_push(double force, double duration);

// Slope of the error between two grids of which the second is twice as fine.
[[nodiscard]] double order(double coarse_error, double fine_error);

}  // namespace verify
