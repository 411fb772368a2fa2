// What the weight of blocks makes of projected joints: a block's own traction there is that of its mean stress and of
// its weight between its centroid and the joint.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "engine/simulation/projected_models.h"

namespace dda {
namespace {

struct Column {
  Model model;
  std::vector<double>
      stress;  // Pa, along the column, of each block but the floor: the weight above and half of its own
};

// Two to five blocks of any height and density on a held floor, without friction and Poisson's ratio, upright or lying
// down, with gravity along it.
Column column_by_lot(unsigned seed, Kinematics kinematics) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  Column column;
  Model& model = column.model;
  const bool upright = seed % 2 == 0;
  const auto block = [&](double from, double height) {
    const std::string name = std::to_string(model.blocks.size());
    return upright ? rectangle(name, 0, from, 1, height) : rectangle(name, from, 0, height, 1);
  };
  model.joints = {dry_projected(0)};
  model.gravity = upright ? Vec2(0, -10) : Vec2(-10, 0);
  model.materials = {rock()};
  model.blocks = {block(-1, 1)};
  model.held_blocks.resize(1);
  double top = 0;
  std::vector<double> weights;
  for (int i = 2 + static_cast<int>(4 * share(random)); i > 0; --i) {
    Material material = rock();
    material.poisson = 0;
    material.density = 1000 + 3000 * share(random);
    const double height = 0.2 + 2 * share(random);
    model.materials.push_back(material);
    model.blocks.push_back(block(top, height));
    model.blocks.back().material = static_cast<int>(model.materials.size()) - 1;
    weights.push_back(material.density * 10 * height);
    top += height;
  }
  for (std::size_t i = 0; i < weights.size(); ++i) {
    double above = weights[i] / 2;
    for (std::size_t j = i + 1; j < weights.size(); ++j) above += weights[j];
    column.stress.push_back(-above);
  }
  model.stages = {stage_of(static_integrator(), 1, 60, kinematics)};
  return column;
}

// Before, the lowest and the highest block were off by up to a tenth of their weight.
TEST(ProjectedWeight, ColumnsCarryWhatLiesOnThem) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite})
    for (unsigned seed = 0; seed < 40; ++seed) {
      Column column = column_by_lot(seed, kinematics);
      Simulation simulation = simulation_of(std::move(column.model));
      while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << seed << ": " << simulation.message();
      const Eigen::Index along = seed % 2 == 0 ? 1 : 0;
      for (std::size_t i = 0; i < column.stress.size(); ++i)  // strains, by which lengths differ, are below 1e-4
        EXPECT_NEAR(simulation.state().stress[i + 1](along), column.stress[i],
                    (kinematics == Kinematics::small ? 1e-8 : 1e-4) * -column.stress[0])
            << seed << ", block " << i;
    }
}

}  // namespace
}  // namespace dda
