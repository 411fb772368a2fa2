// Water in the joints to blocks that a stage takes out over a time.
#include "engine/simulation/loads_in_joints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "engine/contact/interface.h"
#include "engine/simulation/joint_kinds.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr int middle = 2;

// Five squares in a row under pressure, the outer ones held; the second stage takes out the one in the middle, and
// until then water of 0.1 MPa is in the joints to it.
Model row_with_water(InterfaceLaw law) {
  Model model;
  model.materials = {rock()};
  model.joints = {bond(law)};
  for (const double left : {0, 1, 2, 3, 4}) {
    model.blocks.push_back(rectangle(std::to_string(left), left, 0, 1, 1));
    model.blocks.back().initial_stress = {-3e5, 0, 0};
  }
  for (const int outer : {0, 4}) model.held_blocks.emplace_back().block = outer;
  model.stages = {stage_of(static_integrator(), 1, 30, Kinematics::small),
                  stage_of(static_integrator(), 1, 10, Kinematics::small)};
  model.stages[1].removal.blocks = {middle};
  finish_model(model);
  for (const Interface& joint : find_interfaces(model)) {
    if (joint.block_a != middle && joint.block_b != middle) continue;
    const Vec2 push = 1e5 * joint.normal;
    model.edge_loads.push_back({joint.block_a, joint.from, joint.to, -push, Constant{}, {0, 0}});
    model.edge_loads.push_back({joint.block_b, joint.to, joint.from, push, Constant{}, {0, 0}});
  }
  return model;
}

// How far blocks go in the second stage, m.
double motion_as_the_middle_goes(Model model) {
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 30);
  const State before = simulation.state();
  run(simulation, 10);
  double most = 0;
  for (const std::size_t block : {1U, 3U})
    most = std::max(most, (simulation.state().displacement[block] - before.displacement[block]).norm());
  EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
  return most;
}

// What blocks exerted through a joint with water in it is what the joint carried and what the water did. The water went
// at once, and the others came in by it.
TEST(LoadsInJoints, FadeWithTheBlocksThatAreTakenOut) {
  for (const InterfaceLaw law : {InterfaceLaw::consistent, InterfaceLaw::classical}) {
    const Model at_once = row_with_water(law);
    Model kept = at_once;
    kept.stages[1].removal.relaxation = PiecewiseLinear{{0, 1}, {1, 1}};
    const double whole = motion_as_the_middle_goes(at_once);
    EXPECT_GT(whole, 1e-6);
    EXPECT_LT(motion_as_the_middle_goes(kept), 1e-9 * whole);
    kept.stages[1].removal.relaxation = PiecewiseLinear{{0, 1e-3}, {1, 0}};
    EXPECT_NEAR(motion_as_the_middle_goes(kept) / whole, 1, 1e-9);
  }
}

// Other water that comes in with the stage takes the place of what was there: it would act twice while that fades.
TEST(LoadsInJoints, MakeRoomForWhatComesOnTheirFaces) {
  Model model = row_with_water(InterfaceLaw::classical);
  model.stages[1].removal.relaxation = PiecewiseLinear{{0, 1}, {1, 1}};
  for (const EdgeLoad& load : row_with_water(InterfaceLaw::classical).edge_loads) {
    if (load.block == middle) continue;
    model.edge_loads.push_back(load);
    model.edge_loads.back().stages = {1, -1};
  }
  EXPECT_LT(motion_as_the_middle_goes(model),
            1e-9 * motion_as_the_middle_goes(row_with_water(InterfaceLaw::classical)));
}

TEST(LoadsInJoints, AreThoseOfTheBlocksThatStayAndOfTheJointsToThoseThatGo) {
  Model model = row_with_water(InterfaceLaw::classical);
  std::vector<bool> goes;
  for (const EdgeLoad& load : model.edge_loads) goes.push_back(load.block != middle);
  EXPECT_EQ(loads_that_go_with_blocks(1, model), goes);
  EXPECT_EQ(loads_in_joints_of({middle}, model), std::vector<bool>(4, true));
  EXPECT_EQ(loads_in_joints_of({0}, model), std::vector<bool>(4, false));
  EdgeLoad sliver = model.edge_loads.front();  // what is left of a face beside the corner of a water table
  sliver.to = sliver.from + Vec2(0, 1e-16);
  model.edge_loads.push_back(sliver);
  EXPECT_EQ(loads_in_joints_of({middle}, model), std::vector<bool>(5, true));
  model.edge_loads.pop_back();
  for (EdgeLoad& load : model.edge_loads) load.stages = {};  // lasts
  EXPECT_EQ(loads_that_go_with_blocks(1, model), std::vector<bool>(4, false));
}

}  // namespace
}  // namespace dda
