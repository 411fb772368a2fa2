// A run that is stopped, saved, restored into a new object and run on gives the bits of the run without a stop: scenes
// of docs/examples and benchmarks/scenes, each stopped at a step drawn from its name.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "engine/core/counters.h"
#include "engine/scene/scene.h"
#include "engine/simulation/memory_test_support.h"
#include "engine/simulation/probes.h"
#include "engine/simulation/run_so_far.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/snapshot.h"

namespace dda {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t most_steps = 200;  // of either half: long runs are not looked at to their end

std::vector<fs::path> scenes() {
  std::vector<fs::path> found;
  for (const char* folder : {DDA_EXAMPLES, DDA_BENCHMARK_SCENES})
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".json") found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

std::int64_t drawn_step(const std::string& name, std::int64_t steps) {
  std::seed_seq seed(name.begin(), name.end());
  std::mt19937 random(seed);
  return 1 + static_cast<std::int64_t>(random() % static_cast<unsigned>(std::min(steps - 1, most_steps)));
}

void step(Simulation& simulation) {
  const Status status = simulation.step();
  ASSERT_TRUE(status == Status::ok) << simulation.message();
}

std::vector<double> measured(const Probes& probes, const Simulation& simulation) {
  std::vector<double> values(probes.size());
  probes.sample(simulation, values);
  return values;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

void expect_same_counters(const Counters& whole, const Counters& resumed) {
  for (const CounterField& field : counter_fields) {
    const std::string name = field.name;
    if (name == "analyses" || name == "factorizations" || name == "matrix_rebuilds") continue;
    EXPECT_EQ(whole.*field.value, resumed.*field.value) << name;
  }
}

class Resume : public testing::TestWithParam<fs::path> {};

TEST_P(Resume, GivesTheSameBits) {
  const Model model = read_scene(GetParam());
  Simulation whole(model);
  const std::int64_t stop = drawn_step(GetParam().stem(), steps_in_all_stages(whole));
  while (whole.state().step < stop && !whole.finished()) step(whole);
  Simulation resumed(model);
  restore(resumed, whole.state(), save(whole));
  EXPECT_EQ(memory_of(whole), memory_of(resumed)) << "right after the stop";
  const Probes probes(whole);
  for (std::int64_t i = 0; i < most_steps && !whole.finished(); ++i) {
    step(whole);
    step(resumed);
    ASSERT_TRUE(same_bits(measured(probes, whole), measured(probes, resumed)))
        << "stopped at step " << stop << ", differs at " << whole.state().step;
  }
  EXPECT_EQ(whole.finished(), resumed.finished());
  EXPECT_EQ(memory_of(whole), memory_of(resumed)) << "stopped at step " << stop;
  expect_same_counters(whole.counters(), resumed.counters());
}

INSTANTIATE_TEST_SUITE_P(Scenes, Resume, testing::ValuesIn(scenes()), [](const auto& test) {
  return test.param.parent_path().filename().string() + "_" + test.param.stem().string();
});

}  // namespace
}  // namespace dda
