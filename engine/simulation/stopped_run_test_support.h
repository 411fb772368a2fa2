// For tests that stop runs, within stages and between them, and let others go on from there.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "engine/simulation/memory_test_support.h"
#include "engine/simulation/run_so_far.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/snapshot.h"

namespace dda {

// Until so many stages are over.
inline void run_to_stage(Simulation& simulation, std::size_t stages) {
  while (stages_done(simulation) < stages) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
}

// Brings `between`, a run of this model that has not stepped, to where one is between the first so many stages and the
// next.
inline void bring_between_stages(const Model& model, std::size_t stages, Simulation& between) {
  Simulation run(model);
  std::vector<std::byte> snapshot;
  State state;
  run.watch().between = [&] {
    if (stages_done(run) != stages) return;
    snapshot = save(run);
    state = run.state();
  };
  run_to_stage(run, stages);
  restore(between, state, snapshot);
}

// Both come to the same bits, where they begin and after each step to the end.
inline void expect_same_course(Simulation& one, Simulation& other) {
  ASSERT_EQ(memory_of(one), memory_of(other)) << "when it begins";
  while (!other.finished()) {
    ASSERT_EQ(other.step(), Status::ok) << other.message();
    ASSERT_EQ(one.step(), Status::ok) << one.message();
    ASSERT_EQ(memory_of(one), memory_of(other)) << "after step " << other.state().step;
  }
  EXPECT_TRUE(one.finished());
}

// m/s, of the centroids: tells a course on which nothing happens.
inline double largest_speed(const Simulation& simulation) {
  double most = 0;
  for (const Vec6& velocity : simulation.state().velocity) most = std::max(most, velocity.head<2>().norm());
  return most;
}

// A run that stops so many steps after the first so many stages, and another one that goes on from there, come to the
// same bits as `whole`, which has not stepped, at the end of all stages; and the ledger closes.
inline void expect_same_when_stopped(const Model& model, std::size_t stages, int more, Simulation& whole) {
  Simulation first(model), second(model);
  run_to_stage(first, stages);
  for (int i = 0; i < more; ++i) ASSERT_EQ(first.step(), Status::ok) << first.message();
  restore(second, first.state(), save(first));
  run_to_stage(whole, model.stages.size());
  run_to_stage(second, model.stages.size());
  EXPECT_EQ(memory_of(second), memory_of(whole));
  EXPECT_LT(std::abs(whole.energy().relative_residual()), 1e-9);
}

}  // namespace dda
