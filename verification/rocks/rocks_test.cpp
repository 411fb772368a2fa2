#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/scene/scene.h"
#include "engine/simulation/block_system.h"
#include "engine/simulation/memory_test_support.h"
#include "engine/simulation/penetration.h"
#include "engine/simulation/run_so_far.h"
#include "verification/rocks/rock_checks.h"
#include "verification/rocks/rock_run.h"
#include "verification/rocks/rocks_report.h"

namespace verify {
namespace {

TEST(Rocks, EveryKindIsCutAndReadAndTheSameSeedGivesTheSameRock) {
  std::set<std::string> kinds;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    const RandomRock rock = random_rock(seed);
    kinds.insert(name_of(rock.kind));
    EXPECT_EQ(rock.scene, random_rock(seed).scene);
    EXPECT_GT(dda::parse_scene(rock.scene, "scene.json").blocks.size(), 5U) << seed;
  }
  EXPECT_EQ(kinds.size(), all_rock_kinds.size());
}

TEST(Rocks, HaveJointsThatRideUpWhereAskedFor) {
  int without_end = 0;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    const dda::Model model = dda::parse_scene(random_rock(seed, {.joints = RockJoints::dilating}).scene, "scene.json");
    const auto rises = [](const dda::JointMaterial& joint) { return joint.dilation_angle > 0; };
    const auto joint = std::ranges::find_if(model.joints, rises);
    ASSERT_NE(joint, model.joints.end()) << seed;
    if (std::isinf(joint->zero_dilation_slip)) ++without_end;
  }
  EXPECT_EQ(without_end, 8);
}

TEST(Rocks, AreLargerWhereAskedFor) {
  const auto blocks = [](double extent) {
    return dda::parse_scene(random_rock(8, {.extent = extent}).scene, "scene.json").blocks.size();
  };
  EXPECT_GT(blocks(2), 3 * blocks(1));
}

// The most that a contact closes by, over the size of the smaller block, in balance under the weight.
double deepest_when_settled(unsigned seed) {
  dda::Simulation simulation(dda::parse_scene(random_rock(seed).scene, "scene.json"));
  while (dda::stages_done(simulation) == 0) EXPECT_EQ(simulation.step(), dda::Status::ok) << simulation.message();
  dda::Penetration deepest;
  dda::note_penetrations(simulation.model(), simulation.contacts(), simulation.system().terms, simulation.state(),
                         deepest);
  return deepest.share;
}

// Rocks with splinters 70 to 11,000 times smaller than what presses them. With springs of 10 E for all they were 4.3e-4
// to 1.2e-3 of their size in their neighbours; 4.8e-5 to 1.1e-4 is left. Allowed is twice the 1e-4 that is aimed at, as
// a splinter's size is not that of all it touches.
TEST(Rocks, PressSplintersNoDeeperThanOtherBlocks) {
  for (const unsigned seed : {28U, 44U, 52U}) EXPECT_LT(deepest_when_settled(seed), 2e-4) << seed;
}

// A slope of 59 blocks, 178 whole steps. They were taken in 377 parts while nothing led to balance with Coulomb's law
// where quick passes did not.
TEST(Rocks, SlopesInMotionTakeWholeSteps) {
  dda::Simulation simulation(dda::parse_scene(random_rock(14).scene, "scene.json"));
  while (!simulation.finished()) ASSERT_EQ(simulation.step(), dda::Status::ok) << simulation.message();
  EXPECT_LT(static_cast<double>(simulation.counters().steps), 1.1 * static_cast<double>(simulation.state().step));
}

// Half of such rocks ended not_converged while dilations followed the slips from one solution to the next.
TEST(Rocks, SettleAndMoveWithJointsThatRideUp) {
  for (const unsigned seed : {1U, 4U, 5U, 15U, 16U, 24U}) {
    const RockResult result = run_rock(random_rock(seed, {.joints = RockJoints::dilating}), 60);
    EXPECT_EQ(result.outcome, RunOutcome::right) << seed << ": " << result.reason();
  }
}

RandomRock with_damped_contacts(RandomRock rock) {
  nlohmann::json scene = nlohmann::json::parse(rock.scene);
  for (auto& [name, joint] : scene["joints"].items()) joint["contact_damping"] = 0.2;
  rock.scene = scene.dump();
  return rock;
}

// Dilations beside dashpots followed the slips from one solution to the next, and three of these rocks were still
// moving after a minute.
TEST(Rocks, SettleAndMoveWithDampedJointsThatRideUp) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const RandomRock rock = with_damped_contacts(random_rock(seed, {.joints = RockJoints::dilating}));
    const RockResult result = run_rock(rock, 60);
    EXPECT_EQ(result.outcome, RunOutcome::right) << seed << ": " << result.reason();
  }
}

// 273 blocks, and 150: with steps of given friction that were cut at every contact the first did not settle in 60 CPU
// s.
TEST(Rocks, SettleWhereHundredsOfContactsChangeInAStep) {
  for (const auto& [seed, extent] : {std::pair(14U, 2.2), std::pair(6U, 1.0)}) {
    dda::Simulation simulation(dda::parse_scene(random_rock(seed, {.extent = extent}).scene, "scene.json"));
    while (dda::stages_done(simulation) == 0) ASSERT_EQ(simulation.step(), dda::Status::ok) << seed;
    for (const Check& check : settled_checks(simulation)) EXPECT_TRUE(check.holds()) << seed << ": " << check.what;
    EXPECT_LT(simulation.state().step, 250) << seed;
  }
}

// Faces that touch as cut carry their blocks' stresses until the blocks part. Seeds 7, 9 and 22 have slivers of up to a
// ten-thousandth of their neighbours, which sank into them while short stretches, and those closed over a small part,
// gave way by the width of a block. Seed 22 is a slope of which eight blocks come loose and are named.
TEST(Rocks, SettleAndMove) {
  for (const unsigned seed : {1U, 2U, 3U, 5U, 6U, 7U, 8U, 9U, 22U}) {
    const RockResult result = run_rock(random_rock(seed), 60);
    EXPECT_EQ(result.outcome, RunOutcome::right) << seed << ": " << result.reason();
  }
}

TEST(Rocks, SettleAndMoveOnSprings) {
  for (const unsigned seed : {1U, 2U, 3U, 5U, 6U, 8U, 9U, 15U}) {
    const RockResult result = run_rock(random_rock(seed, {.joints = RockJoints::springs}), 60);
    EXPECT_EQ(result.outcome, RunOutcome::right) << seed << ": " << result.reason();
  }
}

// One of each kind. A stiffness per area is a compliance of the joint beside that of its blocks.
TEST(Rocks, SettleAndMoveWithJointsThatGiveWay) {
  for (std::uint64_t seed = 16; seed < 24; ++seed) {
    const RandomRock rock = random_rock(seed, {.joints = RockJoints::compliant});
    for (const dda::JointMaterial& joint : dda::parse_scene(rock.scene, "scene.json").joints)
      EXPECT_TRUE(joint.law == dda::InterfaceLaw::projected || !dda::is_dry(joint)) << seed << ": " << joint.name;
    const RockResult result = run_rock(rock, 60);
    EXPECT_EQ(result.outcome, RunOutcome::right) << seed << ": " << result.reason();
  }
}

// Slopes whose stretches gape took 18,207 and 24,595 passes: each pass threw light blocks away from the balance, and
// steps of given friction were cut at every stretch that opened. Which way such a slope goes differs with the last
// digits, and so between processors: by the kernels of OpenBLAS seed 14 takes 7,700, 14,100, 22,700 or 23,300 passes
// (5,500 or 15,400 before steps were taken on trust), seed 22 always 5,400 to 5,500. So seed 22 is bounded by itself,
// and the geometric mean of both, 6,500 to 11,200 where it was 21,200.
TEST(Rocks, SlopesThatGapeAreDoneInSomeThousandPasses) {
  double logarithms = 0;
  for (const unsigned seed : {14U, 22U}) {
    const RockResult result = run_rock(random_rock(seed), 60);
    EXPECT_EQ(result.outcome, RunOutcome::right) << seed << ": " << result.reason();
    if (seed == 22U) {
      EXPECT_LT(result.passes, 9000);
    }
    logarithms += std::log(static_cast<double>(result.passes));
  }
  EXPECT_LT(std::exp(logarithms / 2), 13000);
}

// One of each kind, restored at every thirteenth step.
TEST(Rocks, GoOnWithTheSameBitsFromWhereTheyAreRestored) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const RockJoints joints = seed % 2 == 0 ? RockJoints::dry : RockJoints::springs;
    const dda::Model model = dda::parse_scene(random_rock(seed, {.joints = joints}).scene, "scene.json");
    dda::Simulation whole(model);
    for (int step = 0; step < 200 && !whole.finished(); ++step) {
      if (step % 13 != 0) {
        ASSERT_EQ(whole.step(), dda::Status::ok) << seed;
        continue;
      }
      dda::Simulation resumed(model);
      dda::restore(resumed, whole.state(), dda::save(whole));
      const dda::Status status = whole.step();
      ASSERT_EQ(resumed.step(), status) << seed << " at " << step;
      ASSERT_TRUE(dda::memory_of(resumed) == dda::memory_of(whole)) << seed << " at " << step;
    }
  }
}

// A rock of two sets that has settled: checks that could not fail would make every rock right.
class ChecksOfRock : public testing::Test {
 protected:
  ChecksOfRock() : simulation_(dda::parse_scene(random_rock(8).scene, "scene.json")) {
    while (dda::stages_done(simulation_) == 0) EXPECT_EQ(simulation_.step(), dda::Status::ok);
  }

  static const Check& named(const std::vector<Check>& checks, const std::string& what) {
    return *std::ranges::find_if(checks, [&](const Check& check) { return check.what.starts_with(what); });
  }

  // The simulation with its state changed: what a wrong rule would have left.
  template <typename Spoil>
  dda::Simulation spoiled(const Spoil& spoil) {
    dda::State state = simulation_.state();
    spoil(state);
    dda::Simulation other(simulation_.model());
    other.restore(std::move(state), simulation_.save());
    return other;
  }

  dda::Simulation simulation_;
};

TEST_F(ChecksOfRock, HoldWhereItHasSettled) {
  for (const Check& check : settled_checks(simulation_)) EXPECT_TRUE(check.holds()) << check.what;
}

TEST_F(ChecksOfRock, SeeABlockInItsNeighbour) {
  const dda::Simulation moved = spoiled([&](dda::State& state) {
    state.displacement[0].x() += 0.02 * std::sqrt(simulation_.model().blocks[0].moments.area);
  });
  EXPECT_FALSE(named(settled_checks(moved), "pairs of blocks").holds());
}

TEST_F(ChecksOfRock, SeeABlockThatFlies) {
  const dda::Simulation moved = spoiled([](dda::State& state) { state.velocity[0].x() = 2; });
  EXPECT_FALSE(named(moved_checks(moved, 0.1), "fastest block").holds());
}

TEST(Rocks, ReportsHaveEveryRockThatIsNotRight) {
  RockResult late;
  late.seed = 77;
  late.outcome = RunOutcome::late;
  late.message = "still settling";
  EXPECT_NE(to_page({late}).find("**late**, seed 77"), std::string::npos);
  EXPECT_NE(to_json({late}).find("\"outcome\":\"late\""), std::string::npos);
}

}  // namespace
}  // namespace verify
