#include "engine/advice/advice.h"
#include "engine/advice/advise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "engine/advice/lattice_test_support.h"
#include "engine/geometry/cut_pieces.h"

namespace dda {
namespace {

WaveQuestion question_of(const Lattice& lattice, const Integrator& integrator, double dt) {
  return {lattice, steps(integrator, dt), WaveKind::bar, {1, 0}, 20};
}

JointMaterial springs(double over_young) {
  JointMaterial joint = bonded(InterfaceLaw::classical);
  joint.spring_over_young = over_young;
  joint.shear_to_normal = 0;
  return joint;
}

// Each cause alone to leading order, at 40 blocks in a wavelength: eta_s/2, theta^2/12, and Omega^2/24 less what the
// inertia of the sideways strain takes (Love), (nu k h)^2/24.
TEST(WaveErrors, EveryCauseHasItsTerm) {
  const Lattice lattice = lattice_of(row_of_blocks(springs(40)));
  const double speed = continuum_speed(lattice.material, WaveKind::bar);
  const double frequency = speed / 40;
  const double theta = 0.1;
  const double dt = theta / (2 * std::numbers::pi * frequency);
  const auto errors = steady_errors(question_of(lattice, trapezoidal_integrator(), dt), frequency);
  ASSERT_TRUE(errors.has_value());
  const double blocks = std::pow(2 * std::numbers::pi / 40, 2) / 24 * (1 - std::pow(0.25 * 0.8, 2));
  const double interfaces = -0.8 / (2 * 40) / 2;  // E area/(k L) with two springs of 40 E on 0.8 m
  EXPECT_NEAR(errors->speed.blocks / blocks, 1, 0.02);
  EXPECT_NEAR(errors->speed.interfaces / interfaces, 1, 0.03);
  EXPECT_NEAR(errors->speed.time / (-theta * theta / 12), 1, 0.03);
  EXPECT_NEAR(errors->amplitude.total(), 0, 1e-9);
  // Eq. 5 of the thesis: exp(-omega^2 dt t/4).
  const auto damped = steady_errors(question_of(lattice, thesis_integrator(), dt), frequency);
  const double time = 20 / speed;
  EXPECT_NEAR(damped->amplitude.time / std::expm1(-std::pow(2 * std::numbers::pi * frequency, 2) * dt * time / 4), 1,
              0.03);
}

// To leading order a wave loses the share (a + b omega^2)/2 of itself per second: its damping ratio a/(2 omega) + b
// omega/2, times omega. Velocities that lose exp(-a dt) in a step are damped like a mass.
TEST(WaveErrors, DampingIsACauseOfItsOwn) {
  const Lattice lattice = lattice_of(row_of_blocks(springs(40)));
  const double frequency = continuum_speed(lattice.material, WaveKind::bar) / 40;
  const double omega = 2 * std::numbers::pi * frequency;
  WaveQuestion question = question_of(lattice, trapezoidal_integrator(), 0.05 / omega);
  const auto plain = steady_errors(question, frequency);
  const double time = question.distance / continuum_speed(lattice.material, WaveKind::bar);
  const double share = 0.01;
  const auto loses = [&](double rate) {
    const auto damped = steady_errors(question, frequency);
    ASSERT_TRUE(damped && plain);
    EXPECT_NEAR(damped->amplitude.damping / std::expm1(-rate * time / 2), 1, 0.03);
    EXPECT_EQ(damped->amplitude.time, plain->amplitude.time);
    EXPECT_NEAR(damped->speed.damping, 0, 2 * share * share);  // 3/8 (2 share)^2
  };
  question.stage.material_damping = {2 * share * omega, 0};
  loses(2 * share * omega);
  question.stage.material_damping = {0, 2 * share / omega};
  loses(2 * share * omega);
  question.stage.material_damping = {};
  question.stage.damping_rate = share * omega;
  question.stage.velocity_factor = std::exp(-share * omega * question.stage.dt);
  loses(2 * share * omega);
}

// What the correction of cubic joints takes out of the period error belongs to time: blocks are as they were, and the
// rest is of fourth order, theta^4/10 or less.
TEST(WaveErrors, CorrectedTimeStepsAreTime) {
  const Lattice lattice = lattice_of(row_of_blocks(bonded(InterfaceLaw::cubic)));
  const double frequency = continuum_speed(lattice.material, WaveKind::bar) / 20;
  const double theta = 0.2;
  WaveQuestion question = question_of(lattice, trapezoidal_integrator(), theta / (2 * std::numbers::pi * frequency));
  const auto plain = steady_errors(question, frequency);
  question.stage.correct_time_dispersion = true;
  const auto corrected = steady_errors(question, frequency);
  ASSERT_TRUE(plain && corrected);
  EXPECT_NEAR(plain->speed.time, -theta * theta / 12, std::pow(theta, 4) / 10);
  EXPECT_NEAR(corrected->speed.time, 0, std::pow(theta, 4) / 10);
  EXPECT_NEAR(corrected->speed.blocks, plain->speed.blocks, 1e-12);
}

// A narrow band is as wrong as its middle: 20 cycles whose band of 5 % blurs errors in proportion to frequency squared.
TEST(WaveErrors, ALongToneIsAsWrongAsASteadyWave) {
  const Lattice row = lattice_of(row_of_blocks(springs(40)));
  const Lattice squares = lattice_of(courses(bonded(InterfaceLaw::consistent), 0));
  const auto compare = [](WaveQuestion question) {
    const double speed = continuum_speed(question.lattice.material, question.kind);
    const double frequency = speed / 15;
    question.stage.dt = 0.05 / (2 * std::numbers::pi * frequency);
    question.distance = 30;
    const double duration = 20 / frequency;
    const LoadHistory load{[=](double t) {
                             return t <= 0 || t >= duration ? 0
                                                            : std::pow(std::sin(std::numbers::pi * t / duration), 2) *
                                                                  std::sin(2 * std::numbers::pi * frequency * t);
                           },
                           duration, 1 / frequency, 0};
    const auto history = history_errors(question, load);
    const auto steady = steady_errors(question, frequency);
    ASSERT_TRUE(history && steady);
    EXPECT_NEAR(history->speed.total() / steady->speed.total(), 1, 0.1);
  };
  compare(question_of(row, thesis_integrator(), 0));
  for (const WaveKind kind : {WaveKind::p, WaveKind::s})
    for (const Vec2& direction : {Vec2(0, 1), Vec2(1, 1).normalized(), Vec2(std::cos(0.3), std::sin(0.3))})
      compare({squares, steps(trapezoidal_integrator(), 1), kind, direction, 0});
}

TEST(WaveErrors, NothingWithoutTwoStepsInAPeriod) {
  const Lattice lattice = lattice_of(row_of_blocks(springs(40)));
  EXPECT_FALSE(steady_errors(question_of(lattice, trapezoidal_integrator(), 0.1), 5).has_value());
  EXPECT_TRUE(steady_errors(question_of(lattice, trapezoidal_integrator(), 0.1), 4.9).has_value());
}

Simulation bar(const JointMaterial& joint) {
  Model model = row_of_blocks(joint, 1, 30);
  model.stages[0].duration = 0.05;
  model.edge_loads.push_back({0, {0, 0.8}, {0, 0}, {1, 0}, SineCycles{20, 1, 0}});
  finish_model(model);
  return Simulation(model);
}

TEST(Advice, NamesTheLargestCause) {
  AdviceQuestion question;
  question.limits = false;
  question.distance = 15;
  EXPECT_EQ(advise(bar(springs(2)), question).stages[0].waves[0].cause(), "interfaces");
  EXPECT_EQ(advise(bar(bonded(InterfaceLaw::consistent)), question).stages[0].waves[0].cause(), "block size");
}

// A push across a bar bends it: no history, and no blocks and steps that it would need.
TEST(Advice, NoLimitsOfWhatCannotBeForetold) {
  const auto wave_of = [](const Vec2& traction) {
    Model model = row_of_blocks(bonded(InterfaceLaw::consistent), 1, 30);
    model.stages[0].duration = 0.05;
    model.edge_loads.push_back({0, {0, 0.8}, {0, 0}, traction, SineCycles{20, 1, 0}});
    finish_model(model);
    AdviceQuestion question;
    question.distance = 15;
    return advise(Simulation(model), question).stages[0].waves.at(0);
  };
  EXPECT_TRUE(wave_of({1, 0}).limits.has_value());
  const WaveAdvice bent = wave_of({0, 1});
  EXPECT_NE(bent.not_foretold.find("cannot be foretold"), std::string::npos) << bent.not_foretold;
  EXPECT_FALSE(bent.limits.has_value());
}

std::vector<std::string> kinds_of_waves(const Model& model) {
  AdviceQuestion question;
  question.limits = false;
  question.frequency = 50;
  const Advice advice = advise(Simulation(model), question);
  std::vector<std::string> kinds;
  for (const WaveAdvice& wave : advice.stages.at(0).waves) kinds.push_back(wave.kind);
  return kinds;
}

// Two narrow blocks beside each other on a wide one on a foot: all joints are level, but that is no bar.
TEST(Advice, BranchesAreNoBar) {
  Model branches;
  branches.materials = {rock()};
  branches.joints = {bonded(InterfaceLaw::consistent)};
  for (const Ring& ring : {box_ring(0, 0, 3, 1), box_ring(0, 1, 3, 2), box_ring(0, 2, 1, 3), box_ring(2, 2, 3, 3)})
    branches.blocks.emplace_back().shape.outer = ring;
  const std::vector<std::string> kinds = kinds_of_waves(finished(std::move(branches)));
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), "bar"), 0);
  EXPECT_GT(std::count(kinds.begin(), kinds.end(), "P"), 0);
  EXPECT_GT(std::count(kinds.begin(), kinds.end(), "S"), 0);
  EXPECT_EQ(kinds_of_waves(row_of_blocks(bonded(InterfaceLaw::consistent))), std::vector<std::string>{"bar"});
}

// What damps a wave lessens it, but for damping that what is moved has to press its rock on against: of that it is said
// why it adds.
TEST(Advice, SaysWhyDampingRaisesStress) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SeededNumbers random(seed);
    const auto terms = [&random] {
      return ErrorTerms{random.number(-0.1, 0.1), random.number(-0.1, 0.1), random.number(-0.1, 0.1),
                        random.number(-0.5, 0.5)};
    };
    WaveAdvice wave;
    wave.steady = SteadyErrors{terms(), terms()};
    Advice advice;
    advice.frequency = 1;
    advice.stages.emplace_back().dt = 1e-3;
    advice.stages.back().waves = {wave};
    const bool raises = wave.cause() == "damping" && wave.steady->amplitude.damping > 0;
    EXPECT_EQ(to_text(advice).find("takes more stress") != std::string::npos, raises) << to_text(advice);
  }
}

TEST(Advice, NoWavesInStaticStages) {
  Model still = row_of_blocks(bonded(InterfaceLaw::consistent));
  still.stages[0].integrator = static_integrator();
  EXPECT_TRUE(kinds_of_waves(still).empty());
}

TEST(Advice, CountsWhatItCan) {
  AdviceQuestion question;
  question.limits = false;
  const Advice advice = advise(bar(springs(10)), question);
  EXPECT_EQ(advice.size.blocks, 30);
  EXPECT_EQ(advice.size.interfaces, 29);
  EXPECT_EQ(advice.size.coupled_pairs, 29);
  EXPECT_EQ(advice.stages[0].cost.steps, 500);
  EXPECT_EQ(advice.stages[0].cost.factorizations, 1);
  EXPECT_GT(advice.stages[0].cost.seconds, 0);
  EXPECT_FALSE(advice.stages[0].cost.at_least);
}

// A factor each step where blocks move; iterations where PCG is asked for.
TEST(Cost, FollowsFromThePlan) {
  SceneSize size;
  size.blocks = 100;
  StepPlan plan;
  plan.finite_kinematics = true;
  plan.chi.largest = 1;
  EXPECT_EQ(cost_of(size, plan, 50).factorizations, 50);
  plan.solver = SolverKind::pcg;
  EXPECT_EQ(cost_of(size, plan, 50).factorizations, 0);
  EXPECT_EQ(cost_of(size, plan, 50).iterations, 50 * 5);  // 3 + 2 sqrt(chi) with an incomplete factor: engine/linear
  plan.chi.largest = 0.09;
  EXPECT_EQ(cost_of(size, plan, 50).iterations, 1155);  // 3 + 67 sqrt(chi) with diagonal blocks
}

// Dry walls of bricks on a held floor (5 GPa, springs of 10 E, friction 35 deg, dt = 1 ms): seconds a step as measured
// on the machine of engine/linear/README.md, at rest and after gravity is switched on at once; docs/speed.md has the
// last.
TEST(Cost, OfWallsIsThatOfTheirRuns) {
  struct Wall {
    SceneSize size;
    double at_rest, falling;  // s
  };
  const Wall walls[] = {{{28, 134, 67, {.nonzeros = 4620}}, 5.9e-6, 2.0e-4},
                        {{106, 570, 285, {.nonzeros = 29982}}, 3.6e-5, 1.06e-3},
                        {{411, 2340, 1170, {.nonzeros = 181575}}, 2.5e-4, 4.7e-3},
                        {{1621, 9480, 4740, {.nonzeros = 1069185}}, 0, 2.37e-2},
                        {{6441, 38160, 19080, {}}, 0, 0.13},
                        {{10051, 59700, 29850, {}}, 0, 0.224}};
  StepPlan plan;
  plan.contacts_can_change = plan.finite_kinematics = true;
  plan.chi = {77, 77};
  plan.solver = SolverKind::pcg;
  for (const Wall& wall : walls) {
    constexpr int steps = 1000;
    const StageCost cost = cost_of(wall.size, plan, steps);
    ASSERT_TRUE(cost.sliding.has_value());
    const double middle = std::sqrt(cost.sliding->least * cost.sliding->most);
    EXPECT_LT(std::abs(std::log(middle / (steps * wall.falling))), std::log(3)) << wall.size.blocks;
    EXPECT_LE(cost.sliding->least, steps * wall.falling);
    EXPECT_GE(cost.sliding->most, steps * wall.falling);
    if (wall.at_rest == 0) continue;
    EXPECT_LT(std::abs(std::log(cost.seconds / (steps * wall.at_rest))), std::log(2)) << wall.size.blocks;
  }
}

// A slide costs no less than rest does, and what cannot change has no range.
TEST(Cost, OnlyContactsThatCanChangeHaveARange) {
  SceneSize size;
  size.blocks = 10;
  size.factor.nonzeros = 1e6;
  StepPlan plan;
  EXPECT_FALSE(cost_of(size, plan, 10).sliding.has_value());
  plan.contacts_can_change = true;
  const StageCost cost = cost_of(size, plan, 10);
  ASSERT_TRUE(cost.sliding.has_value());
  EXPECT_GE(cost.sliding->least, cost.seconds);
  EXPECT_GE(cost.sliding->most, cost.sliding->least);
}

}  // namespace
}  // namespace dda
