#include "engine/model/step_choice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <variant>
#include <vector>

namespace dda {
namespace {

// What `steps` steps of u'' = -omega^2 u make of u = 1, u' = 0, without the eigenvalues.
double stepped(const Integrator& i, double theta, int steps) {
  double u = 1;
  double v = 0;               // times dt
  double a = -theta * theta;  // times dt^2
  for (int n = 0; n < steps; ++n) {
    const double ahead = u + v + (0.5 - i.beta) * a;
    const double force = -theta * theta * ((1 - i.alpha_f) * ahead + i.alpha_f * u) - i.alpha_m * a;
    const double next = force / (1 - i.alpha_m + theta * theta * (1 - i.alpha_f) * i.beta);
    u = ahead + i.beta * next;
    v += (1 - i.gamma) * a + i.gamma * next;
    a = next;
  }
  return u;
}

TEST(StepErrors, AreThoseOfAnOscillatorStepped) {
  for (const Integrator& integrator : {thesis_integrator(), trapezoidal_integrator(), hht_integrator(0.2),
                                       generalized_alpha_integrator(0.85), generalized_alpha_integrator(0)}) {
    constexpr int steps_a_period = 40;
    constexpr int periods = 5;
    const double theta = 2 * std::numbers::pi / steps_a_period;
    const StepErrors errors = step_errors(integrator, theta);
    const double faded = std::pow(1 - errors.amplitude, periods);
    const double phase = 2 * std::numbers::pi * periods * (1 + errors.speed);
    // The other roots, and the phase at the start, are of second order in theta.
    EXPECT_NEAR(stepped(integrator, theta, steps_a_period * periods), faded * std::cos(phase), theta * theta)
        << integrator.name;
  }
}

// Leading orders, Newmark (1959): the trapezoidal rule is slow by theta^2/12 and keeps amplitudes; Eq. 5 loses
// exp(-theta/4) a step's angle, pi theta/2 a period.
TEST(StepErrors, HaveTheLeadingOrdersOfTheory) {
  constexpr double theta = 1e-2;
  EXPECT_NEAR(step_errors(trapezoidal_integrator(), theta).speed, -theta * theta / 12, 1e-9);
  EXPECT_NEAR(step_errors(trapezoidal_integrator(), theta).amplitude, 0, 1e-12);
  EXPECT_NEAR(step_errors(thesis_integrator(), theta).amplitude, std::numbers::pi * theta / 2, theta * theta * 2);
}

// Beside a load that changes in days a step is nothing: neither does its round-off count for an error.
TEST(StepErrors, OfStepsThatAreNothingAreNothing) {
  for (const Integrator& integrator : {thesis_integrator(), trapezoidal_integrator(), generalized_alpha_integrator(0)})
    for (double theta = 1e-3; theta > 1e-20; theta /= 7) {
      EXPECT_LE(std::abs(step_errors(integrator, theta).speed), theta) << integrator.name << ", " << theta;
      EXPECT_LE(std::abs(step_errors(integrator, theta).amplitude), 2 * theta) << integrator.name << ", " << theta;
    }
}

Block square(double left, double side) {
  Block block;
  block.shape.outer = {{left, 0}, {left + side, 0}, {left + side, side}, {left, side}};
  return block;
}

Model row_of_squares(bool bonded) {
  Model model;
  model.materials = {{"rock", 2500, 10e9, 0.2, PlaneState::stress}};  // 2000 m/s
  model.joints = {JointMaterial{}};
  model.joints[0].bonded = bonded;
  for (int i = 0; i < 10; ++i) model.blocks.push_back(square(i, 1));
  Stage stage;
  stage.duration = 1;
  stage.integrator = generalized_alpha_integrator(bonded ? 0.85 : 0);
  stage.chosen.dt.automatic = true;
  model.stages = {stage};
  return model;
}

double chosen(Model model) {
  finish_model(model);
  EXPECT_FALSE(model.stages[0].chosen.dt.reason.empty());
  return model.stages[0].dt;
}

TEST(StepChoice, OfBlocksThatFallFollowsTheirSize) {
  Model model = row_of_squares(false);
  model.gravity = {0, -9.81};
  EXPECT_EQ(chosen(model), 2e-3);            // 0.01 sqrt(1/9.81) = 3.2 ms
  model.blocks.push_back(square(10, 1e-3));  // a sliver changes nothing
  EXPECT_EQ(chosen(model), 2e-3);
  for (Block& block : model.blocks) block.initial_velocity = {0, 50};
  EXPECT_EQ(chosen(model), 2e-4);  // 0.01 * 1 m / 50 m/s, to the last digit
}

// A stage has to have some step, also where nothing is left to find.
TEST(StepChoice, OfHeldBlocksAloneIsThatOfAWaveThroughOne) {
  Model model = row_of_squares(false);
  for (int i = 0; i < 10; ++i) model.held_blocks.emplace_back().block = i;
  EXPECT_EQ(chosen(model), 2e-4);  // half of 1 m / (2000 m/s) = 250 us
}

// Not where that is let go over a time: then the change of the load decides.
TEST(StepChoice, OfRockRemovedAtOnceIsThatOfTheBlocksBesideIt) {
  Model model = row_of_squares(false);
  model.gravity = {0, -9.81};
  model.stages.push_back(model.stages[0]);
  model.stages[1].removal.blocks = {3};
  finish_model(model);
  EXPECT_EQ(model.stages[0].dt, 2e-3);                        // 0.01 sqrt(1/9.81) = 3.2 ms, of blocks that fall
  EXPECT_EQ(model.stages[1].chosen.dt.first_steps.dt, 5e-5);  // an eighth of 1 m / (2000 m/s) = 62.5 us

  Model slow = row_of_squares(false);
  slow.gravity = {0, -9.81};
  slow.stages.push_back(slow.stages[0]);
  slow.stages[1].removal = {{3}, PiecewiseLinear{{0, 1}, {1, 0}}};
  finish_model(slow);
  EXPECT_EQ(slow.stages[1].dt, 2e-3);
}

TEST(StepChoice, OfJointsThatGetTheirOwnStrengthAtOnceIsThatOfTheBlocks) {
  Model model = row_of_squares(false);
  model.gravity = {0, -9.81};
  model.stages.push_back(model.stages[0]);
  finish_model(model);
  EXPECT_EQ(model.stages[1].dt, 2e-3);
  for (Stage& stage : model.stages) stage.dt = 0;
  model.stages[0].unlimited_strength = true;
  finish_model(model);
  EXPECT_EQ(model.stages[0].dt, 2e-3);
  EXPECT_EQ(model.stages[1].chosen.dt.first_steps.dt, 5e-5);  // an eighth of 1 m / (2000 m/s) = 62.5 us
}

// From 50 us by the double up to what falling blocks ask for, to the end of the stage.
TEST(StepChoice, OfRockRemovedAtOnceGrows) {
  Model model = row_of_squares(false);
  model.gravity = {0, -9.81};
  model.stages.push_back(model.stages[0]);
  Stage& stage = model.stages[1];
  stage.removal.blocks = {3};
  for (const double duration : {0.5, 1.0, 0.777, 0.1, 0.0111, 0.0109}) {
    stage.dt = 0;
    stage.chosen.dt.first_steps = {};
    stage.duration = duration;
    finish_model(model);
    double time = 0;
    for (std::int64_t step = 0; step < stage.steps(); ++step) {
      ASSERT_NEAR(stage.time_of(step), time, 1e-12);
      const double dt = stage.dt_of(step);
      ASSERT_LE(dt, step < 100 ? 5e-5 : std::min(0.01 * time * (1 + 1e-12), 0.01 * std::sqrt(1 / 9.81)));
      ASSERT_GE(dt, step == 0 ? 0 : 10.0 / 11 * stage.dt_of(step - 1));
      time += dt;
    }
    EXPECT_NEAR(time, duration, 1e-12);
    EXPECT_NEAR(stage.time_of(stage.steps()), duration, 1e-12);
    EXPECT_EQ(stage.chosen.dt.first_steps.grow(), duration > 0.011)
        << duration;  // 200 steps, and ten of twice the length
  }
  EXPECT_EQ(stage.dt, 5e-5);
}

// Clocks that run ten or a thousand times as fast count the same steps: young, gravity and durations are what those
// clocks read. Durations are decimals, as scenes write them.
TEST(StepChoice, KnowsNothingOfTheUnitOfTime) {
  std::mt19937 random(11);
  const auto stage_of = [](int duration, int power, double g, double young) {
    Model model = row_of_squares(false);
    const double unit = std::stod("1e" + std::to_string(power));
    model.materials[0].young = young / (unit * unit);
    model.gravity = Vec2(0, -g) / (unit * unit);
    model.stages.push_back(model.stages[0]);
    model.stages[1].removal.blocks = {3};
    model.stages[1].duration = std::stod(std::to_string(duration) + "e" + std::to_string(power - 3));
    finish_model(model);
    return model.stages[1];
  };
  for (int i = 0; i < 500; ++i) {
    const int duration = std::uniform_int_distribution<int>(10, 2000)(random);  // ms
    const double g = std::uniform_real_distribution<double>(1, 20)(random);
    const double young = 1e10 * std::uniform_int_distribution<int>(1, 4)(random);
    const Stage expected = stage_of(duration, 0, g, young);
    for (const int power : {-4, -3, -2, -1, 1, 2, 3})
      EXPECT_EQ(stage_of(duration, power, g, young).steps(), expected.steps())
          << duration << " ms, " << g << " m/s2, times 1e" << power;
  }
}

// 40 MPa set blocks moving at 40 MPa / (2500 kg/m3 * 2000 m/s) = 8 m/s, a hundredth of 1 m in 1.25 ms.
TEST(StepChoice, OfStressedRockRemovedAtOnceGrowsAsFarAsThrownBlocksLet) {
  Model model = row_of_squares(false);
  model.stages.push_back(model.stages[0]);
  model.stages[1].removal.blocks = {3};
  for (Block& block : model.blocks) block.initial_stress = {-40e6, -1e6, 0};
  finish_model(model);
  EXPECT_EQ(model.stages[1].chosen.dt.first_steps.dt, 5e-5);
  EXPECT_EQ(model.stages[1].chosen.dt.first_steps.doublings, 4);
  EXPECT_NEAR(model.stages[1].dt, 8e-4, 0.1e-4);
}

// Velocities are multiplied by it in every step, whatever its length.
TEST(StepChoice, OfRockRemovedAtOnceStaysAsItIsWhereItsNumberOfStepsDamps) {
  Model model = row_of_squares(false);
  model.stages.push_back(model.stages[0]);
  model.stages[1].removal.blocks = {3};
  model.stages[1].velocity_factor = 0.99;
  finish_model(model);
  EXPECT_FALSE(model.stages[1].chosen.dt.first_steps.grow());
  EXPECT_EQ(model.stages[1].dt, 5e-5);
}

TEST(StepChoice, OfSupportsThatLetGoAtOnceIsThatOfTheBlocks) {
  for (const bool takes_force_along : {false, true}) {
    Model model = row_of_squares(false);
    model.gravity = {0, -10};
    PointSupport prop;
    prop.point = {0.5, 0.5};
    prop.stiffness = 1e9;
    prop.last_stage = 0;
    prop.takes_force_along = takes_force_along;
    model.supports = {prop};
    model.stages.insert(model.stages.begin(), Stage{});
    model.stages[0].integrator = static_integrator();
    model.stages[0].equilibrium = 1e-9;
    finish_model(model);
    const bool is_release = model.stages[1].chosen.dt.reason.find("supports let go at once") != std::string::npos;
    EXPECT_EQ(is_release, takes_force_along) << model.stages[1].chosen.dt.reason;
  }
}

TEST(StepChoice, OfStressThatNothingHasSettledIsThatOfTheBlocks) {
  Model model = row_of_squares(false);
  model.gravity = {0, -10};
  model.blocks[0].initial_stress = {-1e6, -1e6, 0};
  finish_model(model);
  EXPECT_NE(model.stages[0].chosen.dt.reason.find("stress begins to act at once"), std::string::npos)
      << model.stages[0].chosen.dt.reason;
}

TEST(StepChoice, OfWavesFollowsTheFrequencyAndTheIntegrator) {
  Model model = row_of_squares(true);
  EXPECT_EQ(chosen(model), 2e-4);  // half of 1 m / (2000 m/s) = 250 us
  model.edge_loads = {{0, {0, 0}, {0, 1}, {1e6, 0}, SineCycles{100, 1, 0}}};
  const double accurate = chosen(model);
  const StepErrors errors = step_errors(model.stages[0].integrator, 2 * std::numbers::pi * 100 * accurate);
  EXPECT_LE(std::abs(errors.speed), 0.002);
  EXPECT_LE(std::abs(errors.amplitude), 0.002);
  model.stages[0].integrator = thesis_integrator();  // of first order
  EXPECT_LT(chosen(model), accurate / 2);
  model.stages[0].integrator = trapezoidal_integrator();
  const double slow = chosen(model);
  model.expected.frequency = 200;
  EXPECT_NEAR(chosen(model) / slow, 0.5, 0.11);  // but for the rounding to 1, 2 and 5
}

// Samples of sin(2 pi f t) from `start` on, over one period, raised by `preload` over a tenth of a second before.
PiecewiseLinear sampled_sine(double frequency, int points, double size, double preload) {
  PiecewiseLinear table{{0}, {0}};
  const double start = preload > 0 ? 0.1 : 0;
  if (preload > 0) {
    table.times.push_back(start);
    table.values.push_back(preload);
  }
  for (int i = 1; i <= points; ++i) {
    table.times.push_back(start + i / (points * frequency));
    table.values.push_back(preload + size * std::sin(2 * std::numbers::pi * i / points));
  }
  return table;
}

// A table is as fast as what it draws, and not as the lines that it is made of: a sine of 100 Hz counts as 157 Hz, from
// 20 points (which gave a third of the step once, and 1,000 points a hundredth) to as many as there may be.
TEST(StepChoice, OfTablesDoesNotDependOnTheirPoints) {
  Model model = row_of_squares(true);
  model.edge_loads = {{0, {0, 0}, {0, 1}, {1e6, 0}, SineCycles{157, 1, 0}}};
  const double of_sine = chosen(model);
  for (const int points : {20, 100, 1000, 10000}) {
    model.edge_loads[0].history = sampled_sine(100, points, 1, 0);
    EXPECT_EQ(chosen(model), of_sine) << points;
    model.edge_loads[0].history = sampled_sine(100, points, 0.2, 1);  // on a preload
    EXPECT_EQ(chosen(model), of_sine) << points << ", behind a preload";
  }
  model.edge_loads[0].history = PiecewiseLinear{{0, 0.25 / 157, 1}, {0, 1, 1}};
  EXPECT_EQ(chosen(model), of_sine);  // a ramp is a quarter of a period, as before
}

// 10 points a period of 100 Hz, as a recorder gives them: the interval of its samples is 1 ms, where steps took 5 % of
// a wave's amplitude.
TEST(StepChoice, OfRecordingsIsThatOfTheirLargeSwings) {
  const PiecewiseLinear signal = sampled_sine(100, 10, 1, 0);
  std::vector<double> noisy = signal.values;
  for (std::size_t i = 0; i < noisy.size(); ++i) noisy[i] += i % 2 == 0 ? 0.02 : -0.02;
  Model model = row_of_squares(true);
  model.edge_loads = {{0, {0, 0}, {0, 1}, {1e6, 0}, SineCycles{157, 1, 0}}};
  const double of_sine = chosen(model);
  const auto record = [](const PiecewiseLinear& table, const std::vector<double>& values) {
    return Recorded{std::make_shared<const Recording>("record", table.times, values), 0};
  };
  model.edge_loads[0].history = record(signal, signal.values);
  EXPECT_EQ(chosen(model), of_sine);
  model.edge_loads[0].history = record(signal, noisy);
  EXPECT_NEAR(chosen(model), of_sine, 0.5 * of_sine) << "noise of 2 % of the peak in every sample";
}

TEST(StepChoice, OfTablesLeavesRipplesOut) {
  Model model = row_of_squares(true);
  model.edge_loads = {{0, {0, 0}, {0, 1}, {1e6, 0}, sampled_sine(80, 1000, 1, 0)}};
  const double smooth = chosen(model);
  auto& table = std::get<PiecewiseLinear>(model.edge_loads[0].history);
  for (std::size_t i = 1; i < table.values.size(); i += 2) table.values[i] += 1e-5;  // a third of a line at most
  EXPECT_EQ(chosen(model), smooth);
  table.times.insert(table.times.begin() + 1, 1e-9);  // round-off before the rise
  table.values.insert(table.values.begin() + 1, -1e-12);
  EXPECT_EQ(chosen(model), smooth);
}

TEST(StepChoice, StaysWithinItsBounds) {
  Model model = row_of_squares(true);
  model.edge_loads = {{0, {0, 0}, {0, 1}, {1e6, 0}, SineCycles{1e9, 1, 0}}};
  EXPECT_EQ(chosen(model), 2e-5);  // a twentieth of 500 us
  model.edge_loads[0].history = SineCycles{1e-3, 1, 0};
  EXPECT_EQ(chosen(model), 1e-2);  // a hundredth of the stage
}

TEST(StepChoice, LeavesStatedStepsAlone) {
  Model model = row_of_squares(true);
  model.stages[0].chosen.dt.automatic = false;
  model.stages[0].dt = 0.123;
  finish_model(model);
  EXPECT_EQ(model.stages[0].dt, 0.123);
  EXPECT_EQ(model.stages[0].chosen.dt.reason, "");
}

}  // namespace
}  // namespace dda
