// Blocks that a stage adds where their neighbours have come into their place: they are seated, however far these came.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "engine/simulation/joint_kinds.h"
#include "engine/simulation/memory_test_support.h"
#include "engine/simulation/simulation_models.h"
#include "engine/simulation/snapshot.h"

namespace dda {
namespace {

constexpr double come_on = 1e-5;  // m, by which one wall presses the fill in the end
constexpr int fill = 4;           // the first block of what comes in

Stage settling(const std::string& name, double duration) {
  Stage stage = settling_stage(1e-9, duration);
  stage.name = name;
  return stage;
}

HeldBlock held(int block) {
  HeldBlock wall;
  wall.block = block;
  return wall;
}

// A wall that has come in by so much (m, rad) at 1 s, and goes on by `more` of that from 2 s to 3 s.
HeldBlock coming(int block, const Vec2& by, double turn, double more) {
  HeldBlock wall = held(block);
  wall.amplitude = by;
  wall.turn = turn;
  wall.about = {0.5, 0.5};
  wall.history = PiecewiseLinear{{0, 1, 2, 3}, {0, 1, 1, 1 + more}};
  return wall;
}

// A hole of 1 m between four walls, two of which come in by up to `most` (m) while one block or two are missing there.
// Springs are 10 E or go by length.
Model filled_hole(std::mt19937& random, double most, bool has_two, bool by_length) {
  const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  const double in = number(0.3, 1) * most;
  Model model;
  model.materials = {{"rock", 2600, 20e9, 0.2, PlaneState::stress}};
  model.joints = {dry(0.5)};
  if (by_length) model.joints[0].normal_stiffness = model.joints[0].shear_stiffness = 1e12;
  model.blocks = {rectangle("floor", -1, -1, 3, 1), rectangle("left", -1, 0, 1, 1), rectangle("right", 1, 0, 1, 1),
                  rectangle("roof", 0, 1, 1, 1)};
  const double cut = has_two ? number(0.2, 0.8) : 1;
  model.blocks.push_back(rectangle("fill 1", 0, 0, cut, 1));
  if (has_two) model.blocks.push_back(rectangle("fill 2", cut, 0, 1 - cut, 1));
  model.held_blocks = {held(0), held(1), coming(2, {-in, 0}, 0, come_on / in),
                       coming(3, {0, -number(0.3, 1) * most}, number(-1, 1) * most, 0)};
  model.stages = {settling("missing", 1), settling("filled", 1), settling("pressed", 1)};
  for (std::size_t i = fill; i < model.blocks.size(); ++i) model.stages[1].rock.added.push_back(static_cast<int>(i));
  return model;
}

void finish_stage(Simulation& simulation) {
  const std::size_t stage = simulation.system().clock.stage;
  while (!simulation.finished() && simulation.system().clock.stage == stage)
    ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
}

template <typename Body>
void in_all_holes(Body body) {
  std::mt19937 random(17);
  for (const double most : {1e-4, 1e-3, 3e-3, 1e-2, 3e-2})
    for (int lot = 0; lot < 8; ++lot) {
      SCOPED_TRACE(testing::Message() << "up to " << most << " m, lot " << lot);
      body(simulation_of(filled_hole(random, most, lot % 2 == 1, lot % 4 > 1)));
    }
}

// Nothing presses when they come in, and when a wall comes on they bear about that alone: as much of 20 GPa, less what
// springs give way, and more where the other walls hold them.
TEST(AddedOverOthers, AreSeatedHoweverFarTheseHaveCome) {
  in_all_holes([](Simulation simulation) {
    finish_stage(simulation);
    finish_stage(simulation);
    for (std::size_t i = fill; i < simulation.model().blocks.size(); ++i) {
      EXPECT_LT(simulation.state().displacement[i].norm(), 1e-12);
      EXPECT_LT(simulation.state().stress[i].norm(), 1);
    }
    EXPECT_TRUE(simulation.results().shared_ground.empty());
    finish_stage(simulation);
    for (std::size_t i = fill; i < simulation.model().blocks.size(); ++i) {
      EXPECT_GT(-simulation.state().stress[i](0), 0.7 * 20e9 * come_on);
      EXPECT_LT(-simulation.state().stress[i](0), 1.25 * 20e9 * come_on);
    }
    EXPECT_TRUE(simulation.results().shared_ground.empty());
  });
}

// A fifth of the fill lies in the wall: it is seated as well, and told of.
TEST(AddedOverOthers, AreToldOfWhereTheyComeInFarOverThem) {
  std::mt19937 random(19);
  Model model = filled_hole(random, 0.01, false, false);
  model.held_blocks[2] = coming(2, {-0.2, 0}, 0, 0);
  Simulation simulation = simulation_of(std::move(model));
  for (int stage = 0; stage < 3; ++stage) finish_stage(simulation);
  EXPECT_LT(simulation.state().displacement[fill].norm(), 1e-12);
  EXPECT_LT(simulation.state().stress[fill].norm(), 1);
  const std::vector<SharedGroundOfStage>& told = simulation.results().shared_ground;
  ASSERT_EQ(told.size(), 2U) << "when it comes in, and later";
  EXPECT_NEAR(told[0].worst.depth, 0.2, 1e-3);
}

// A plate has come in by most of its thickness or more: the fill lies in it, and has gone through nothing. In 4 of
// these it was deeper than half of the plate, by which it may have.
TEST(AddedOverOthers, HaveNotGoneThroughWhatTheyCameInOver) {
  std::mt19937 random(29);
  for (int lot = 0; lot < 20; ++lot) {
    Model model = filled_hole(random, 0.01, lot % 2 == 1, lot % 4 > 1);
    const double thickness = std::uniform_real_distribution(0.005, 0.03)(random);
    model.blocks[2] = rectangle("plate", 1, 0, thickness, 1);
    model.held_blocks[2].amplitude.x() = -std::uniform_real_distribution(0.6, 1.5)(random) * thickness;
    model.held_blocks[3] = held(3);  // and the plate meets no other wall
    Simulation simulation = simulation_of(std::move(model));
    for (int stage = 0; stage < 3; ++stage) finish_stage(simulation);
    EXPECT_LT(simulation.state().displacement[fill].norm(), 1e-3) << lot;
    EXPECT_LT(simulation.deepest_penetration().in_thickness.share, ruinous_share) << lot;
  }
}

// What came in over others is not asked of outlines again: it is kept.
TEST(AddedOverOthers, GoOnFromASnapshotToTheBit) {
  std::mt19937 random(23);
  for (int lot = 0; lot < 4; ++lot) {
    Model model = filled_hole(random, 2e-2, lot % 2 == 1, lot > 1);
    finish_model(model);
    Simulation whole(model), first(model), second(model);
    for (int stage = 0; stage < 3; ++stage) finish_stage(whole);
    finish_stage(first);
    finish_stage(first);
    restore(second, first.state(), save(first));
    finish_stage(second);
    EXPECT_EQ(memory_of(second), memory_of(whole)) << lot;
  }
}

}  // namespace
}  // namespace dda
