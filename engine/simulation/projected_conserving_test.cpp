// Projected joints under integrators that damp nothing: what joints that gape, open and close again do to the energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/contact/no_tension_bed.h"
#include "engine/simulation/projected_models.h"

namespace dda {
namespace {

// The potential of a bed, of second degree in the gaps.
double stored(const Bed& bed, const Vec2& gaps) { return press_bed(bed, gaps).force.dot(gaps) / 2; }

// The work of the mean force is the change of the potential, and its slopes are those of the force. Ways as long as the
// gaps, some past the gaps where nothing is left of the force, leave the quadrature 1e-6 of them; steps of a run are a
// small share of that.
TEST(ProjectedConserving, MeanOfABedDoesTheWorkThatItStores) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(-1, 1);
  for (int i = 0; i < 20000; ++i) {
    const Bed bed{1, 0.4 + 0.15 * share(random), 0.5 + 0.5 * share(random)};
    const Vec2 from(share(random), share(random)), to(share(random), share(random));
    const BedAnswer mean = mean_of_bed(bed, from, to);
    EXPECT_NEAR(mean.force.dot(to - from), stored(bed, to) - stored(bed, from), 1e-6);
    constexpr double little = 1e-6;
    const Vec2 more = mean_of_bed(bed, from, to + Vec2(little, 0)).force;
    const Vec2 less = mean_of_bed(bed, from, to - Vec2(little, 0)).force;
    EXPECT_NEAR((more(0) - less(0)) / (2 * little), mean.slope(0), 1e-4);
    EXPECT_NEAR((more(1) - less(1)) / (2 * little), mean.coupling, 1e-4);
  }
}

// A wall on a floor that is shaken once; bricks lift off, rock and slide.
Model thrown_wall(unsigned seed, double friction) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  const Integrator integrator = seed % 2 == 0 ? energy_conserving_integrator() : trapezoidal_integrator();
  Model model = wall_on_shaken_floor({0, 5e-4 * share(random)}, stage_of(integrator, 1e-4, 300));
  model.joints[0].friction_angle = std::atan(friction);
  std::get<SineCycles>(model.held_blocks[0].history).cycles = 1;
  for (std::size_t i = 0; i + 1 < model.blocks.size(); ++i)
    model.blocks[i].initial_velocity = {0.02 * (share(random) - 0.5), 0.2 * share(random)};
  return model;
}

TEST(ProjectedConserving, NothingIsLostButByFriction) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const double friction = seed % 3 == 0 ? 0 : 0.5;
    Simulation simulation = simulation_of(thrown_wall(seed, friction));
    double worst = 0;
    bool gaped = false;
    for (int i = 0; i < 300; ++i) {
      ASSERT_EQ(simulation.step(), Status::ok) << "seed " << seed << ": " << simulation.message();
      const EnergyLedger& energy = simulation.energy();
      worst = std::max({worst, std::abs(energy.relative_residual()), std::abs(energy.numerical) / energy.scale()});
      for (const InterfaceState& state : simulation.contacts().states)
        gaped = gaped || (state.status[0] == ContactStatus::open) != (state.status[1] == ContactStatus::open);
    }
    EXPECT_TRUE(gaped) << "seed " << seed;
    EXPECT_LT(friction == 0 ? worst : 0, 1e-9) << "seed " << seed;
    EXPECT_GT(simulation.energy().numerical, -1e-9 * simulation.energy().scale()) << "seed " << seed;
  }
}

// Gaps that are measured anew and joints that part take energy and bring none, to a small share of what there is.
TEST(ProjectedConserving, NothingIsGainedWhereBlocksMove) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    Model model = thrown_wall(seed, seed % 3 == 0 ? 0 : 0.5);
    model.stages[0].kinematics = Kinematics::finite;
    Simulation simulation = simulation_of(std::move(model));
    double residual = 0, gained = 0;
    for (int i = 0; i < 300; ++i) {
      ASSERT_EQ(simulation.step(), Status::ok) << "seed " << seed << ": " << simulation.message();
      const EnergyLedger& energy = simulation.energy();
      residual = std::max(residual, std::abs(energy.relative_residual()));
      gained = std::max(gained, -energy.numerical / energy.scale());
    }
    EXPECT_LT(residual, 1e-9) << "seed " << seed;
    EXPECT_LT(gained, 1e-3) << "seed " << seed;
  }
}

}  // namespace
}  // namespace dda
