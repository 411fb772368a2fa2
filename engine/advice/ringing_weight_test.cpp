// Blocks on slopes whose weight acts at once: the remark is made where they creep in a run, and not where they stay.
#include "engine/advice/ringing_weight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "engine/contact/make_contacts.h"
#include "engine/simulation/simulation.h"

namespace dda {
namespace {

// A block of 1 m on a held slope with friction of 30 degrees.
Model block_on_slope(double slope, double dt, const Integrator& integrator = generalized_alpha_integrator(0)) {
  Model model;
  model.materials = {{"rock", 2600, 10e9, 0.2, PlaneState::stress}};
  model.joints.resize(1);
  model.joints[0].friction_angle = 0.5236;
  model.gravity = {9.81 * std::sin(slope), -9.81 * std::cos(slope)};
  model.blocks.resize(2);
  model.blocks[0].name = "slope";
  model.blocks[0].shape.outer = {{-5, -1}, {5, -1}, {5, 0}, {-5, 0}};
  model.blocks[1].name = "block";
  model.blocks[1].shape.outer = {{-0.5, 0}, {0.5, 0}, {0.5, 1}, {-0.5, 1}};
  model.held_blocks.resize(1);
  model.stages.resize(1);
  model.stages[0].dt = dt;
  model.stages[0].duration = 0.1;
  model.stages[0].integrator = integrator;
  finish_model(model);
  return model;
}

bool is_remarked(const Model& model) { return !ringing_weight(model, make_contacts(model)).empty(); }

// m, along the slope.
double crept(const Model& model) {
  Simulation simulation(model);
  while (!simulation.finished()) EXPECT_EQ(simulation.step(), Status::ok);
  return simulation.state().displacement[1][0];
}

TEST(RingingWeight, IsRemarkedWhereBlocksCreep) {
  constexpr double give =
      2e-6;  // m: weight along the slope over the springs, 0.5 um, doubled by the swing, and doubled
  for (const double dt : {1e-5, 1e-4, 5e-4, 1e-3}) {
    const Model model = block_on_slope(0.4363, dt);
    EXPECT_EQ(is_remarked(model), crept(model) > give) << dt;
  }
}

TEST(RingingWeight, NamesStageStepAndPitch) {
  const auto remarks = [](const Model& model) { return ringing_weight(model, make_contacts(model)); };
  const auto found = remarks(block_on_slope(0.4363, 1e-5));
  ASSERT_EQ(found.size(), 1U);
  // sqrt(3 E/rho)/(2 pi) = 540.6 Hz
  EXPECT_NE(found[0].find("stage \"run\": weight acts at once"), std::string::npos) << found[0];
  EXPECT_NE(found[0].find("steps of 1e-05 s let them ring (about 5.4e+02 Hz)"), std::string::npos) << found[0];
}

TEST(RingingWeight, NotWhereNothingCreeps) {
  EXPECT_TRUE(is_remarked(block_on_slope(0.4363, 1e-3, energy_conserving_integrator())));
  EXPECT_FALSE(is_remarked(block_on_slope(0, 1e-5))) << "on the level";
  Model model = block_on_slope(0.4363, 1e-5);
  model.joints[0].friction_angle = 0;
  EXPECT_FALSE(is_remarked(model)) << "slides anyway";
  model = block_on_slope(0.4363, 1e-5);
  model.joints[0].friction_angle = 0.4;
  EXPECT_FALSE(is_remarked(model)) << "no friction holds it";
  model = block_on_slope(0.4363, 1e-5);
  model.stages[0].damping_rate = 100;
  EXPECT_FALSE(is_remarked(model)) << "damped";
  model = block_on_slope(0.4363, 1e-5);
  model.stages.insert(model.stages.begin(), Stage{});
  model.stages[0].integrator = static_integrator();
  EXPECT_FALSE(is_remarked(model)) << "settles first";
  model = block_on_slope(0.4363, 1e-5);
  model.blocks[1].initial_stress = {-1e4, -1e4, 0};
  EXPECT_FALSE(is_remarked(model)) << "begins under stress";
}

}  // namespace
}  // namespace dda
