// Rock that slides as an opening is let go part by part, in a static stage: what its friction takes is no more than
// what was set free, and nothing comes back as damping.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/simulation/projected_models.h"
#include "engine/simulation/random_test_support.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr int size = 7;  // blocks along a side, of 1 m; those at the edge are held

// Corners that blocks share, off their places in a square grid by lot.
class Corners {
 public:
  explicit Corners(Random& random) {
    for (int i = 0; i <= size; ++i)
      for (int j = 0; j <= size; ++j) {
        const double off = i == 0 || j == 0 || i == size || j == size ? 0 : 0.3;
        places_.emplace_back(i + off * between(-1, 1, random), j + off * between(-1, 1, random));
      }
  }
  [[nodiscard]] Ring block(int i, int j) const { return {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}; }

 private:
  [[nodiscard]] Vec2 at(int i, int j) const { return places_[static_cast<std::size_t>(i * (size + 1) + j)]; }

  std::vector<Vec2> places_;
};

bool is_at_edge(int i, int j) { return std::min(i, j) == 0 || std::max(i, j) == size - 1; }
bool is_in_middle(int i, int j) { return std::abs(i - size / 2) <= 1 && j == size / 2; }

struct Release {
  Model model;

  explicit Release(Random& random) {
    constexpr double young = 1e12;  // Pa: what areas make of stored energy, by strains, is little
    model.materials = {{"rock", 2600, young, 0.2, PlaneState::strain}};
    model.joints = {dry_projected(between(0.15, 0.4, random))};
    const double pressure = between(5e6, 2e7, random), along = between(0.7, 1.5, random) * pressure;
    const Corners corners(random);
    Stage still = settling_stage(1e-9), release = settling_stage(1e-9, 1);
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j) {
        const int block = static_cast<int>(model.blocks.size());
        Block& added = model.blocks.emplace_back();
        added.shape.outer = corners.block(i, j);
        added.initial_stress = {-along, -pressure, 0};
        if (is_at_edge(i, j)) model.held_blocks.emplace_back().block = block;
        if (is_in_middle(i, j)) release.removal.blocks.push_back(block);
      }
    release.removal.relaxation = PiecewiseLinear{{0, 1}, {1, 0}};
    for (Stage* stage : {&still, &release}) stage->on_unbalanced = OnUnbalanced::carry_on;
    model.stages = {still, release};
  }
};

// Friction was booked by the mean of both ends of steps in which joints let go, whatever there was for it: what was
// left for damping was below -1e-3 of the energy in what was taken out in 15 of these, by 9 % in one and by 230 % in
// another.
TEST(SlowRelease, LeavesNothingNegativeForDamping) {
  Random random(41);
  for (int i = 0; i < 20; ++i) {
    const Release rock(random);
    Simulation simulation = simulation_of(rock.model);
    while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << i << ": " << simulation.message();
    const EnergyLedger& before = simulation.results().energy[0];
    const EnergyLedger& after = simulation.results().energy[1];
    const auto lost = [](const EnergyLedger& at) { return at.damping + at.numerical + at.law_changes; };
    EXPECT_GT(after.friction - before.friction, 0.01 * after.removed) << i;
    EXPECT_GT(lost(after) - lost(before), -1e-3 * after.removed) << i;
    EXPECT_LT(std::abs(after.relative_residual()), 1e-9) << i;
  }
}

}  // namespace
}  // namespace dda
