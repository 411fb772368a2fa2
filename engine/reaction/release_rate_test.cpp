// Energy release rates against closed forms: a bar that is parted, and a round opening under hydrostatic stress.
#include "engine/reaction/release_rate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "engine/model/energy_release.h"
#include "engine/reaction/ring_models.h"
#include "engine/simulation/run_so_far.h"

namespace dda {
namespace {

Simulation ended(const Model& model) {
  Simulation simulation(model);
  while (!simulation.finished()) {
    if (simulation.step() == Status::ok) continue;
    ADD_FAILURE() << simulation.message();
    break;
  }
  return simulation;
}

// Six blocks in a row between springs, without Poisson's effect. What of the force N of the bar was stored, N^2/2 times
// the compliance of blocks and springs, is released when a block is taken out: nothing else does work.
TEST(ReleaseRate, OfABarThatIsParted) {
  constexpr double height = 0.8, stiffness = 1e11, bar_young = 1e10;
  constexpr int count = 6;
  Model model;
  model.materials = {{"rock", 2600, bar_young, 0, PlaneState::stress}};
  model.joints = {JointMaterial{}};
  model.joints[0].bonded = true;
  for (int i = 0; i < count; ++i) {
    model.blocks.emplace_back().shape.outer = {{i, 0}, {i + 1, 0}, {i + 1, height}, {i, height}};
    model.blocks.back().initial_stress = {-5e6, 0, 0};
  }
  for (const double x : {0.0, 1.0 * count})
    model.supports.push_back({x == 0 ? 0 : count - 1, {x, height / 2}, true, true, stiffness, Vec2::Zero(), {}});
  model.stages = {static_stage("in situ"), static_stage("parted")};
  model.stages[1].removal.blocks = {2};
  finish_model(model);
  Simulation settled(model);
  while (stages_done(settled) == 0) ASSERT_EQ(settled.step(), Status::ok) << settled.message();
  const double force = height * settled.state().stress[0](0);
  const Simulation simulation = ended(model);
  const std::vector<ReleaseRate> rates = release_rates(simulation);
  ASSERT_EQ(rates.size(), 1U);
  EXPECT_EQ(rates[0].stage, 1U);
  const double expected = force * force / 2 * (count / (bar_young * height) + 2 / stiffness);
  // Stages end when forces are out of balance by 1e-9 of the largest; energies miss by their square, and by round-off.
  EXPECT_NEAR(rates[0].released / expected, 1, 1e-9);
  EXPECT_NEAR(rates[0].per_volume() * height / expected, 1, 1e-9);
  EXPECT_NEAR(rates[0].per_wall().value() * 2 * height / expected, 1, 1e-9);
}

// The wall of a round opening goes in by f p a/(2 G), where f is 1 in endless rock; its tractions, let go at once, do
// half of their work along it, pi a^2 p^2/(2 G) f. What was stored in the rock taken out is (1 - 2 nu) of
// pi a^2 p^2/(2 G). Both follow from u = A r + B/r, radial stress 2 G (A/(1 - 2 nu) - B/r^2), in plane strain.
struct RingOfRock {
  double poisson = 0;
  bool is_held = false;  // outside; else the pressure stays there

  // The factor f of a ring whose outer radius is 1/sqrt(share) of the opening's.
  [[nodiscard]] double further(double share) const {
    const double one = 1 - 2 * poisson;
    return is_held ? (1 - share) / (1 + share / one) : (1 + one * share) / (1 - share);
  }
};

// Holds the outermost ring of blocks, in place of the pressure on it. Returns its inner radius.
double hold_outside(int sectors, Model& model) {
  model.edge_loads.clear();
  const int first = static_cast<int>(model.blocks.size()) - sectors;
  for (int i = 0; i < sectors; ++i) model.held_blocks.emplace_back().block = first + i;
  return model.blocks.back().shape.outer.front().norm();
}

TEST(ReleaseRate, OfARoundOpeningConvergesToTheClosedForm) {
  for (const RingOfRock& ring : {RingOfRock{0.1, false}, RingOfRock{0.25, false}, RingOfRock{0.37, false},
                                 RingOfRock{0.1, true}, RingOfRock{0.3, true}}) {
    double coarser = 0;
    for (const int sectors : {16, 32, 64}) {
      Model model = rings_around_core(sectors);
      model.materials[0].poisson = ring.poisson;
      const double outside = ring.is_held ? hold_outside(sectors, model) : outer_radius;
      finish_model(model);
      const Simulation simulation = ended(model);
      const std::vector<ReleaseRate> rates = release_rates(simulation);
      ASSERT_EQ(rates.size(), 1U);
      const double unit = std::numbers::pi * radius * radius * pressure * pressure * (1 + ring.poisson) / young;
      const double expected = unit * (ring.further(std::pow(radius / outside, 2)) + 1 - 2 * ring.poisson);
      const double error = rates[0].released / expected - 1;
      // Blocks of constant strain: of second order in their size. Measured: 8.1 to 12.4, 2 pi^2/3 = 6.6 of which is the
      // area that the polygon lacks of the circle.
      EXPECT_LT(std::abs(error), 13.0 / (sectors * sectors)) << ring.poisson << ", " << sectors;
      if (coarser != 0) {
        EXPECT_NEAR(std::log2(coarser / error), 2, 0.2) << sectors;
      }
      // What a mesh without end would have (Richardson). Measured: at most 1.3e-4, the next order.
      if (sectors == 64) {
        EXPECT_NEAR((4 * error - coarser) / 3, 0, 3e-4) << ring.poisson;
      }
      coarser = error;
      // The opening has the corners of its wall on the circle: half the ratio of its area to its outline is the
      // distance of its sides from the middle.
      EXPECT_NEAR(rates[0].per_wall().value() / rates[0].per_volume() * 2 / std::cos(std::numbers::pi / sectors),
                  radius, 1e-12);
    }
  }
}

// The wall that a later stage lays free does not count what an earlier one had.
TEST(ReleaseRate, OfASecondStageHasItsOwnWall) {
  Model model = rings_around_core(16);
  Stage second = static_stage("wider");
  second.removal.blocks = {1, 2};
  model.stages.push_back(second);
  finish_model(model);
  const Simulation simulation = ended(model);
  const std::vector<ReleaseRate> rates = release_rates(simulation);
  ASSERT_EQ(rates.size(), 2U);
  const Ring& outline = model.blocks[1].shape.outer;
  const double free_sides = 2 * (outline[2] - outline[1]).norm() + 2 * (outline[1] - outline[0]).norm();
  EXPECT_NEAR(rates[1].wall, free_sides, 1e-12);
  EXPECT_GT(rates[1].released, 0);
  const EnergyRelease whole = energy_release(simulation.energy());
  EXPECT_NEAR((rates[0].released + rates[1].released) / whole.by_fate(), 1, 1e-9);  // in situ nothing is released
}

}  // namespace
}  // namespace dda
