// What springs at closed joints make of a round hole, and where dda check says so.
#include "engine/advice/springs_around_openings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "engine/model/finish_model.h"
#include "engine/model/state.h"
#include "engine/simulation/simulation.h"

namespace dda {
namespace {

constexpr double young = 20e9, poisson = 0.25, pressure = 1e6;  // Pa, of the rock; Pa, in situ
constexpr double outer_radius = 10;                             // m; that of the hole is 1

JointMaterial dry_joint() {
  JointMaterial joint;
  joint.name = "dry";
  joint.friction_angle = 0.6;
  return joint;
}

Model rock_in_situ(const JointMaterial& joint) {
  Model model;
  model.materials = {{"rock", 2600, young, poisson, PlaneState::strain}};
  model.joints = {joint};
  Stage stage;
  stage.name = "rest";
  stage.integrator = static_integrator();
  stage.equilibrium = 1e-9;
  stage.unlimited_strength = true;
  model.stages = {stage};
  return model;
}

void add_block(Model& model, Ring outline) {
  Block& block = model.blocks.emplace_back();
  block.name = "b" + std::to_string(model.blocks.size());
  block.shape.outer = std::move(outline);
  block.initial_stress = {-pressure, -pressure, 0};
}

void press(Model& model, const Vec2& from, const Vec2& to) {
  const Vec2 along = (to - from).normalized();
  model.edge_loads.push_back(
      {static_cast<int>(model.blocks.size()) - 1, from, to, pressure * Vec2(-along.y(), along.x()), Constant{}});
}

// Rings of `sectors` blocks around a hole that is there from the start. What it has lost is all that moves.
Model rings(int sectors, const JointMaterial& joint) {
  Model model = rock_in_situ(joint);
  const int rings = sectors * 3 / 8;
  const auto corner = [&](int ring, int sector) {
    const double angle = 2 * std::numbers::pi * sector / sectors;
    return Vec2(std::pow(outer_radius, static_cast<double>(ring) / rings) * Vec2(std::cos(angle), std::sin(angle)));
  };
  for (int ring = 0; ring < rings; ++ring) {
    for (int i = 0; i < sectors; ++i) {
      add_block(model, {corner(ring, i), corner(ring + 1, i), corner(ring + 1, i + 1), corner(ring, i + 1)});
      if (ring + 1 == rings) press(model, corner(rings, i), corner(rings, i + 1));
    }
  }
  const int first = (rings - 1) * sectors;
  for (const int quarter : {0, 1, 2}) {
    PointSupport& support = model.supports.emplace_back();
    support.block = first + quarter * sectors / 4;
    support.point = corner(rings, quarter * sectors / 4);
    support.holds_x = quarter == 1;
    support.holds_y = quarter != 1;
    support.stiffness = 1e12;
  }
  finish_model(model);
  return model;
}

// How far the middles of the innermost faces come in, over Lame's solution for a hole in a thick ring.
double share_of_exact(const Model& model, int sectors) {
  Simulation simulation(model);
  while (!simulation.finished()) EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
  double sum = 0;
  for (int i = 0; i < sectors; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.5) / sectors;
    const Vec2 inward(-std::cos(angle), -std::sin(angle));
    const Vec2 middle = -std::cos(std::numbers::pi / sectors) * inward;
    sum += point_displacement(model, simulation.state(), i, middle).dot(inward);
  }
  const double plane_young = young / (1 - poisson * poisson);
  const double squared = outer_radius * outer_radius;
  const double exact = pressure / plane_young * ((squared + 1) / (squared - 1) + poisson / (1 - poisson));
  return sum / sectors / exact;
}

TEST(SpringsAroundOpenings, LockARoundHoleAndProjectedJointsDoNot) {
  JointMaterial joint = dry_joint();
  EXPECT_NEAR(share_of_exact(rings(24, joint), 24), 0.53, 0.01);
  joint.law = InterfaceLaw::projected;
  EXPECT_NEAR(share_of_exact(rings(24, joint), 24), 0.99, 0.01);
  joint = dry_joint();
  joint.automatic_stiffness = true;
  EXPECT_NEAR(share_of_exact(rings(24, joint), 24), 0.16, 0.01);
}

// The tie is what locks, not the spring: the same joints as soft as the blocks hardly do.
TEST(SpringsAroundOpenings, LockLittleWhereTheyAreSoft) {
  JointMaterial joint = dry_joint();
  joint.law = InterfaceLaw::classical;
  joint.normal_stiffness = 30e9;
  joint.shear_stiffness = 12e9;
  const Model springs = rings(24, joint);
  EXPECT_TRUE(springs_around_openings(springs).empty());
  joint.law = InterfaceLaw::projected;
  EXPECT_NEAR(share_of_exact(springs, 24) / share_of_exact(rings(24, joint), 24), 1, 0.03);
}

// Squares of 1 m, `columns` by 3, pressed from all sides as they are.
Model squares(int columns, const JointMaterial& joint, int rows = 3) {
  Model model = rock_in_situ(joint);
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const Vec2 low(i, j);
      add_block(model, {low, low + Vec2(1, 0), low + Vec2(1, 1), low + Vec2(0, 1)});
      if (j == 0) press(model, low, low + Vec2(1, 0));
      if (j == rows - 1) press(model, low + Vec2(1, 1), low + Vec2(0, 1));
      if (i == 0) press(model, low + Vec2(0, 1), low);
      if (i == columns - 1) press(model, low + Vec2(1, 0), low + Vec2(1, 1));
    }
  }
  return model;
}

void take_out(Model& model, int block) {
  model.stages.push_back(model.stages.front());
  model.stages.back().removal.blocks = {block};
}

struct Told {
  const char* name;
  std::function<void(Model&)> change;
  const char* part;  // of the remark; empty: none
};

class SpringsAroundOpeningsOf : public testing::TestWithParam<Told> {};

TEST_P(SpringsAroundOpeningsOf, AreRemarkedOn) {
  Model model = squares(3, dry_joint());
  GetParam().change(model);
  finish_model(model);
  const std::vector<std::string> remarks = springs_around_openings(model);
  std::string all;
  for (const std::string& remark : remarks) all += remark;
  EXPECT_EQ(remarks.size(), *GetParam().part == 0 ? 0U : 1U);
  EXPECT_NE(all.find(GetParam().part), std::string::npos) << all;
}

constexpr auto law = "closed joints (\"dry\") lock blocks";
const Told scenes[] = {
    {"RockThatStaysAsItIs", [](Model&) {}, ""},
    {"ABlockTakenOut", [](Model& model) { take_out(model, 4); }, law},
    {"TheLawThatDoesNot", [](Model& model) { take_out(model, 4); }, "with \"law\": \"projected\" for them by 1 %"},
    {"AHoleFromTheStart",
     [](Model& model) {
       model.blocks.erase(model.blocks.begin() + 8);
       model.edge_loads.clear();
     },
     law},
    {"AFaceThatIsNotLoaded", [](Model& model) { model.edge_loads.pop_back(); }, law},
    {"HeldInsteadOfLoaded",
     [](Model& model) {
       const EdgeLoad load = model.edge_loads.back();
       model.edge_loads.pop_back();
       PointSupport& support = model.supports.emplace_back();
       support.block = load.block;
       support.point = (load.from + load.to) / 2;
       support.stiffness = 1e12;
     },
     ""},
    {"RockWithoutStress",
     [](Model& model) {
       for (Block& block : model.blocks) block.initial_stress.setZero();
       model.edge_loads.clear();
     },
     ""},
    {"ProjectedJoints",
     [](Model& model) {
       take_out(model, 4);
       model.joints[0].law = InterfaceLaw::projected;
     },
     ""},
    {"BondedJoints",
     [](Model& model) {
       take_out(model, 4);
       model.joints[0].bonded = true;
     },
     ""},
    {"CohesionWhichMakesThemConsistent",
     [](Model& model) {
       take_out(model, 4);
       model.joints[0].cohesion = 1e6;
     },
     ""},
    {"SmallKinematicsWhichDoesToo",
     [](Model& model) {
       take_out(model, 4);
       for (Stage& stage : model.stages) stage.kinematics = Kinematics::small;
     },
     ""},
    {"SmallKinematicsWithTheClassicalLaw",
     [](Model& model) {
       take_out(model, 4);
       for (Stage& stage : model.stages) stage.kinematics = Kinematics::small;
       model.joints[0].law = InterfaceLaw::classical;
     },
     law},
    {"SpringsAsSoftAsBlocks",
     [](Model& model) {
       take_out(model, 4);
       model.joints[0].law = InterfaceLaw::classical;
       model.joints[0].normal_stiffness = 20e9;
     },
     ""},
    {"ARow",
     [](Model& model) {
       model = squares(5, dry_joint(), 1);
       model.edge_loads.clear();
       take_out(model, 4);
     },
     ""},
    {"DampedContacts",
     [](Model& model) {
       take_out(model, 4);
       model.joints[0].contact_damping = 0.2;
     },
     "; smaller blocks lock less"},
};
INSTANTIATE_TEST_SUITE_P(All, SpringsAroundOpeningsOf, testing::ValuesIn(scenes),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace dda
