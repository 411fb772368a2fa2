// Layers of bonded blocks on smooth beds, clamped at both ends, under their own weight: each bends as a beam whatever
// touches it.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "engine/simulation/random_test_support.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr double span = 24;
constexpr double young = 2e10;
constexpr double poisson = 0.2;
constexpr double unit_weight = 2600 * 9.81;

// In the middle of a clamped beam (Timoshenko's, factor 5/6 on the shear area), m per Pa of load on it.
struct Stiffness {
  double bending = 0;  // N m2 per m of thickness
  double shear = 0;    // N per m of thickness

  [[nodiscard]] double deflection(double load) const {
    return load * (span * span * span * span / (384 * bending) + span * span / (8 * shear));
  }
};

struct Group {
  double load = 0;
  Stiffness stiffness;
  int layers = 0;

  [[nodiscard]] double deflection() const { return stiffness.deflection(load); }
};

// Layers from below. One that would sag more by itself than those below rests on them; smooth beds add loads and
// stiffnesses, and nothing else. Layers that sag less part from those below.
std::vector<double> deflections(const std::vector<double>& heights) {
  std::vector<Group> groups;
  for (const double height : heights) {
    groups.push_back({unit_weight * height,
                      {young * height * height * height / 12, 5.0 / 6 * young / (2 * (1 + poisson)) * height},
                      1});
    while (groups.size() > 1 && groups.back().deflection() > groups[groups.size() - 2].deflection()) {
      const Group above = groups.back();
      groups.pop_back();
      groups.back().load += above.load;
      groups.back().stiffness.bending += above.stiffness.bending;
      groups.back().stiffness.shear += above.stiffness.shear;
      groups.back().layers += above.layers;
    }
  }
  std::vector<double> found;
  for (const Group& group : groups)
    found.insert(found.end(), static_cast<std::size_t>(group.layers), group.deflection());
  return found;
}

struct Roof {
  Model model;
  std::vector<int> middles;  // of each layer the block right of the middle
};

// Every layer has its own number of blocks, so seams do not meet.
Roof roof_of(const std::vector<double>& heights, const std::vector<int>& blocks, const JointMaterial& bond) {
  Roof roof;
  Model& model = roof.model;
  model.materials = {{"rock", 2600, young, poisson, PlaneState::stress}};
  model.joints = {{"bed", InterfaceLaw::classical}, bond};
  double below = 0;
  for (std::size_t k = 0; k < heights.size(); ++k) {
    const double length = span / blocks[k];
    const int first = static_cast<int>(model.blocks.size());
    for (int i = -1; i <= blocks[k]; ++i) {
      model.blocks.push_back(rectangle("", i * length, below, length, heights[k]));
      const int block = static_cast<int>(model.blocks.size()) - 1;
      if (i >= 0) model.joint_of_block_pair[{block - 1, block}] = 1;
      if (i < 0 || i == blocks[k]) model.held_blocks.emplace_back().block = block;
    }
    roof.middles.push_back(first + 1 + blocks[k] / 2);
    below += heights[k];
  }
  model.gravity = {0, -9.81};
  Stage stage;
  stage.integrator = static_integrator();
  stage.equilibrium = 1e-8;
  model.stages = {stage};
  return roof;
}

void expect_beams(const std::vector<double>& heights, const std::vector<int>& blocks, const JointMaterial& bond) {
  const Roof roof = roof_of(heights, blocks, bond);
  Simulation simulation = simulation_of(roof.model);
  while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
  const std::vector<double> expected = deflections(heights);
  double below = 0;
  for (std::size_t k = 0; k < heights.size(); ++k) {
    const Vec2 middle(span / 2, below + heights[k] / 2);
    const double moved = point_displacement(simulation.model(), simulation.state(), roof.middles[k], middle).y();
    // Clamped beams of 24 blocks and more: four quarters of six blocks and more, 1/(2 n^2) = 1.4 % for each, and 1 %
    // for what beds that touch at corners share unevenly.
    EXPECT_NEAR(-moved / expected[k], 1, 0.03) << "layer " << k << " of " << heights.size();
    below += heights[k];
  }
}

TEST(BeddedRoof, LayersOnSmoothBedsBendAsBeams) {
  Random random(61);
  for (int layers = 1; layers <= 5; ++layers) {
    for (int i = 0; i < 3; ++i) {
      std::vector<double> heights;
      std::vector<int> blocks;
      for (int k = 0; k < layers; ++k) {
        heights.push_back(between(0.5, 1.2, random));
        blocks.push_back(2 * std::uniform_int_distribution<int>(12, 20)(random));
      }
      expect_beams(heights, blocks, {"bond", InterfaceLaw::consistent, true});
    }
  }
}

// What it was bonded to carried some of it. Afterwards it hangs as if it had always hung alone, whatever its blocks
// were bent by before.
TEST(BeddedRoof, ALayerBendsAsABeamOnceWhatItWasBondedToIsRemoved) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    Roof roof = roof_of({0.6, 1.0}, {24, 24}, bond(InterfaceLaw::consistent));
    Model& model = roof.model;
    model.joints[0] = bond(InterfaceLaw::consistent);
    model.stages[0].kinematics = kinematics;
    model.stages.push_back(model.stages[0]);
    for (int block = 1; block <= 24; ++block) model.stages[1].removal.blocks.push_back(block);
    Simulation simulation = simulation_of(model);
    while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
    const double moved =
        point_displacement(simulation.model(), simulation.state(), roof.middles[1], {span / 2, 1.1}).y();
    EXPECT_NEAR(-moved / deflections({1.0})[0], 1, 0.03);
  }
}

}  // namespace
}  // namespace dda
