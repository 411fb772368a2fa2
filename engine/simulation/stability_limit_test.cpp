// The limit of explicit steps: that of dense algebra, kept by runs, and asked for before anything is run.
#include "engine/simulation/stability_limit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "engine/contact/make_contacts.h"
#include "engine/core/error.h"
#include "engine/simulation/explicit_models.h"

namespace dda {
namespace {

using namespace explicit_models;

// Below 2/omega of the dense problem, by half a percent and what Lanczos' method finds too little of omega, which is
// next to nothing in problems of a hundred unknowns.
TEST(StabilityLimit, IsThatOfTheLargestFrequency) {
  std::mt19937 random(313);
  for (int scene = 0; scene < 200; ++scene) {
    const RandomBondedScene drawn(random, true);
    const Model model = drawn.with(drawn.random_stage(random, 0.7 * drawn.stable_dt(), 1));
    if (!model.held_blocks.empty()) continue;  // of those modes_of() knows nothing
    const double exact = 2 / std::sqrt(modes_of(model).squares.maxCoeff());
    const double limit = stability_limit(model, 0);
    EXPECT_LT(limit, 0.99505 * exact) << "scene " << scene;
    EXPECT_GT(limit, 0.9945 * exact) << "scene " << scene;
  }
}

// Stages that are alike share what is found of one; those that are not have their own.
TEST(StabilityLimit, IsThatOfEachStage) {
  std::mt19937 random(21);
  for (int scene = 0; scene < 20; ++scene) {
    const RandomBondedScene drawn(random, true);
    Model model = drawn.with(drawn.random_stage(random, 0.3 * drawn.stable_dt(), 1));
    model.supports.push_back({0, model.blocks[0].moments.centroid, true, true, 1e11, Vec2::Zero(), {}});
    model.supports.back().last_stage = 1;
    model.stages.resize(6, model.stages[0]);
    model.stages[3].strain_inertia = 2;
    model.stages[4].dt = model.stages[4].duration = 0.7 * model.stages[0].dt;
    finish_model(model);
    const std::vector<double> limits = kept_stability_limits(make_contacts(model), model);
    for (std::size_t i = 0; i < limits.size(); ++i) EXPECT_EQ(limits[i], stability_limit(model, i)) << i;
    EXPECT_EQ(limits[0], limits[1]);
    EXPECT_LT(limits[0], limits[2]);  // without the support
  }
}

// What is set in motion in all modes at once, at 0.999 of the limit, keeps its energy for twenty thousand steps. (Not
// in rigid motion: the scenes would move through kilometres, of which strains are a difference.)
TEST(StabilityLimit, IsKeptByRuns) {
  std::mt19937 random(99);
  std::normal_distribution<double> velocity(0, 1);
  for (int scene = 0; scene < 4; ++scene) {
    const RandomBondedScene drawn(random, false);
    constexpr int steps = 20'000;
    Model model = drawn.with(explicit_stage(0.999 * drawn.stable_dt(), steps));
    model.edge_loads.clear();
    const DenseModes modes = modes_of(model);
    Eigen::VectorXd start = Eigen::VectorXd::Zero(modes.squares.size());
    for (Eigen::Index mode = 3; mode < start.size(); ++mode) start += velocity(random) * modes.shapes.col(mode);
    set_in_motion(start, model);
    Simulation simulation(model);
    const double begun = simulation.energy().kinetic;
    for (int i = 0; i < steps; ++i) ASSERT_EQ(simulation.step(), Status::ok);
    const EnergyLedger& energy = simulation.energy();
    // Round-off: 1e-12 was measured.
    EXPECT_NEAR(energy.kinetic + energy.strain + energy.contact, begun, 1e-10 * begun) << "scene " << scene;
  }
}

TEST(StabilityLimit, IsRefusedBeforeAnythingIsRun) {
  std::mt19937 random(7);
  for (int scene = 0; scene < 5; ++scene) {
    const RandomBondedScene drawn(random, true);
    EXPECT_NO_THROW(Simulation(drawn.with(explicit_stage(0.999 * drawn.stable_dt(), 10))));
    try {
      const Simulation simulation(drawn.with(explicit_stage(1.05 * drawn.stable_dt(), 10)));
      FAIL() << "scene " << scene;
    } catch (const InputError& error) {
      EXPECT_EQ(error.field(), "stages \"run\" dt");
      EXPECT_NE(error.expected().find("central differences are stable"), std::string::npos) << error.what();
    }
  }
}

// Left to the engine, dt is stable, not much shorter than it must be, and said with its reason. A wave that asks for
// less than what is stable has its way.
TEST(StabilityLimit, IsKeptWhereDtIsLeftToTheEngine) {
  std::mt19937 random(17);
  int shortened = 0;
  for (int scene = 0; scene < 40; ++scene) {
    const RandomBondedScene drawn(random, true);
    Stage stage = RandomBondedScene::random_stage(random, 0, 0);
    stage.chosen.dt.automatic = true;
    stage.duration = 0.5;
    const Model left_open = drawn.with(stage);
    const double asked = left_open.stages[0].dt;
    const Simulation simulation(left_open);
    const Stage& chosen = simulation.model().stages[0];
    const double limit = simulation.stability_limit(0);
    ASSERT_LE(chosen.dt, limit) << "scene " << scene;
    if (chosen.dt == asked) continue;
    ++shortened;
    EXPECT_GT(asked, limit);
    EXPECT_GT(chosen.dt, 0.84 * limit) << "scene " << scene;  // 0.95, two digits (10 % at 0.10) and a softer rock
    EXPECT_NE(chosen.chosen.dt.reason.find("stable"), std::string::npos);
  }
  EXPECT_GT(shortened, 10);
  EXPECT_LT(shortened, 40);
}

// A limit that is named is one that is taken.
TEST(StabilityLimit, ThatIsNamedIsTaken) {
  std::mt19937 random(8);
  for (int scene = 0; scene < 20; ++scene) {
    const RandomBondedScene drawn(random, true);
    Stage stage = explicit_stage(1, 10);
    stage.correct_block_dispersion = stage.correct_time_dispersion = true;
    const double named = stability_limit(drawn.with(stage), 0);
    EXPECT_NO_THROW(Simulation(drawn.with([&] {
      Stage shorter = stage;
      shorter.dt = named;
      shorter.duration = 10 * named;
      return shorter;
    }())))
        << "scene " << scene;
  }
}

// One sentence for what explicit steps are not for.
TEST(StabilityLimit, OtherScenesAreRefused) {
  const auto sentence_of = [](Model model) -> std::string {
    try {
      finish_model(model);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  Model open = bar_of(2, strong(InterfaceLaw::consistent));
  open.stages = {explicit_stage(1e-5, 10)};
  EXPECT_NE(sentence_of(open).find("whose joints are all bonded"), std::string::npos) << sentence_of(open);
  Model damped = bar_of(2, bond(InterfaceLaw::consistent));
  damped.stages = {explicit_stage(1e-5, 10)};
  damped.stages[0].material_damping.stiffness = 1e-5;
  EXPECT_NE(sentence_of(damped).find("damping in proportion to stiffness"), std::string::npos) << sentence_of(damped);
  Model finite = bar_of(2, bond(InterfaceLaw::consistent));
  finite.stages = {stage_of(central_difference_integrator(), 1e-5, 10, Kinematics::finite)};
  EXPECT_NE(sentence_of(finite).find("small kinematics"), std::string::npos) << sentence_of(finite);
}

}  // namespace
}  // namespace dda
