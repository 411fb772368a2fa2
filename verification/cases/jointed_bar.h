// A bar along x that ends in absorbing edges on both sides and has a few joints of its own: a P wave pushed in along
// it, or an S wave across it. For S waves the corners of all blocks are held in x, so that the motion is u_y(x) alone.
#pragma once

#include <functional>
#include <vector>

#include "engine/core/counters.h"
#include "engine/model/model.h"
#include "verification/exact/block_chain.h"

namespace verify {

enum class WaveKind { p, s };

struct JointedBar {
  WaveKind kind = WaveKind::p;
  int blocks = 400;
  double block_length = 0.5;  // m; blocks are 1 m high
  double dt = 2e-5;
  int steps = 1000;
  double initial_pressure = 0;                  // Pa, axial, in equilibrium with the ends
  std::function<double(double)> incident = {};  // Pa, stress of the wave that enters at the left end at time t (s)
  bool absorbing_start = true;                  // of the left end; else it is free but for the push
  double end_ratio = 1;                         // impedance of the right end over that of the bar
  dda::Integrator integrator = {};
  dda::JointMaterial special = {};   // of `special_at`; the others are bonded, consistent
  std::vector<int> special_at = {};  // interface i lies between blocks i and i + 1
  std::vector<int> probes = {};      // blocks whose stress is recorded: axial (P) or shear (S)

  [[nodiscard]] double speed() const;      // m/s: bar with free sides, or S
  [[nodiscard]] double impedance() const;  // Pa s/m
};

// The chain that an S wave along the bar runs on, without supports that give way; for the closed form.
[[nodiscard]] exact::BlockChain shear_chain_of(const JointedBar& bar);

// Stress (Pa) of each probe after every step, the first value at rest. Throws std::runtime_error if a step fails.
[[nodiscard]] std::vector<std::vector<double>> stress_histories(const JointedBar& bar, dda::Counters& counters);

}  // namespace verify
