// A lottery of scenes as one draws them from docs/scene.md: waves whose load has kinks, through courses and rows of two
// rocks, between rollers, through blocks of few to a wavelength, and with damping in steps. What is advised of all six
// readings against runs. Each kind was missed in a lottery that knew of the adviser only what the documents say.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engine/advice/advice.h"
#include "engine/advice/advise.h"
#include "engine/advice/chain_run_test_support.h"
#include "engine/scene/scene.h"
#include "engine/simulation/simulation.h"

namespace dda {
namespace {

using std::numbers::pi;

double triangle(double share, double top) { return share < top ? share / top : (1 - share) / (1 - top); }

// Kinks are at tenths of the load's time, which is a whole number of tens of units: what should come is followed from
// unit to unit, and is straight between.
struct Shape {
  const char* name;
  double cycles;
  double (*value)(double share);
};
const Shape kinked[] = {
    {"triangle", 1, [](double share) { return triangle(share, 0.5); }},
    {"steep triangle", 1, [](double share) { return triangle(share, 0.3); }},
    {"saw", 1,
     [](double share) { return share < 0.2 ? 5 * share : (share < 0.7 ? 1 - 4 * (share - 0.2) : (share - 1) / 0.3); }},
    {"half sine", 0.5, [](double share) { return std::sin(pi * share); }},
};

void choose_times(Row& row, Dice& dice, double blocks_in_wave, double steps_in_period) {
  row.unit = 0.05 / row.speed(0);
  double block = 0;
  for (const TestLayer& layer : row.blocks) block += layer.units * row.unit / static_cast<double>(row.blocks.size());
  const double tens = std::max(1.0, std::round(blocks_in_wave * block * row.cycles / row.unit / 10));
  row.frequency = row.cycles / (10 * tens * row.unit);
  row.dt = 1 / row.frequency / steps_in_period;
  const double due = row.units_before() * row.unit;
  row.duration = std::ceil((1.25 * due + (row.cycles + 1.5) / row.frequency) / row.dt) * row.dt;
  row.steps = dice.one_of(
      std::vector<std::string>{"", R"(, "integrator": "thesis")", R"(, "integrator": {"generalized_alpha": 0.5})"});
}

void give_shape(Row& row, unsigned seed) {
  const Shape& shape = kinked[seed % std::size(kinked)];
  row.shape = shape.value;
  row.cycles = shape.cycles;
  row.name += fmt::format(" ({})", shape.name);
}

// Courses of two to five equal layers, of two rocks by turns.
void lay_courses(Row& row, Dice& dice, int layers) {
  row.rocks = {{dice.between(2200, 3000), dice.between(10e9, 80e9)},
               {dice.between(2200, 3000), dice.between(10e9, 80e9)}};
  for (int rock = 0; static_cast<int>(row.blocks.size()) < layers; rock = 1 - rock) {
    const int units = static_cast<int>(dice.between(16, 40));
    const int of_course = static_cast<int>(dice.between(2, 6));
    for (int i = 0; i < of_course; ++i) row.blocks.push_back({rock, units});
  }
  row.joint = static_cast<int>(dice.between(layers / 5.0, layers / 3.0));
}

Row courses(unsigned seed) {
  Dice dice(seed);
  Row row;
  row.name = fmt::format("courses {}", seed);
  give_shape(row, seed);
  row.wave = dice.between(0, 1) < 0.5 ? 'p' : 's';
  row.columns = static_cast<int>(dice.between(4, 6));
  row.running_bond = dice.between(0, 1) < 0.5;
  lay_courses(row, dice, 60);
  row.angle = row.wave == 's' ? dice.one_of(std::vector<double>{0, pi / 2}) : dice.between(0, 3);
  choose_times(row, dice, dice.between(8, 18), dice.between(15, 80));
  return row;
}

Row alternating_row(unsigned seed) {
  Dice dice(seed);
  Row row;
  row.name = fmt::format("alternating {}", seed);
  give_shape(row, seed);
  lay_courses(row, dice, 110);
  choose_times(row, dice, dice.between(8, 25), dice.between(15, 80));
  return row;
}

void lay_equal_blocks(Row& row, Dice& dice, int blocks) {
  row.rocks = {{dice.between(2200, 3000), dice.between(10e9, 80e9)}};
  row.blocks.assign(static_cast<std::size_t>(blocks), {0, 20});
}

// Few blocks to a wavelength, between rollers: these hold blocks as no neighbour does.
Row coarse_mesh(unsigned seed) {
  Dice dice(seed);
  Row row;
  row.name = fmt::format("coarse {}", seed);
  row.wave = seed % 2 == 0 ? 's' : 'p';
  row.columns = 4;
  row.running_bond = dice.between(0, 1) < 0.5;
  lay_equal_blocks(row, dice, 60);
  row.joint = static_cast<int>(dice.between(10, 18));
  row.joint_law = R"(, "law": "consistent")";
  if (dice.between(0, 1) < 0.5) row.joint_law += R"(, "penalty": 20)";
  row.scheme = dice.one_of(std::vector<std::string>{"accurate", "thesis"});
  choose_times(row, dice, dice.between(4.5, 8), dice.between(8, 25));
  return row;
}

Row damped_row(unsigned seed) {
  Dice dice(seed);
  Row row;
  row.name = fmt::format("damped {}", seed);
  lay_equal_blocks(row, dice, 110);
  row.joint = static_cast<int>(dice.between(18, 36));
  row.joint_law = R"(, "law": "consistent")";
  choose_times(row, dice, dice.between(8, 20), dice.between(20, 80));
  row.steps = R"(, "integrator": "thesis")";
  row.steps += seed % 2 == 0 ? fmt::format(R"(, "damping_rate": {:.9g})", 0.2 * row.frequency)
                             : fmt::format(R"(, "velocity_factor": {:.9g})", 1 - 0.2 * row.frequency * row.dt);
  return row;
}

// Rock that hardly gives way in volume, whose P waves the corrections for blocks do not correct in full (ADR 24).
Row nearly_incompressible(unsigned seed) {
  Dice dice(seed);
  Row row;
  row.plane_strain = true;
  row.poisson = dice.between(0.47, 0.495);
  row.wave = 'p';
  row.name = fmt::format("nu {:.3f}, seed {}", row.poisson, seed);
  row.columns = 4;
  row.running_bond = dice.between(0, 1) < 0.5;
  lay_equal_blocks(row, dice, 60);
  row.joint = static_cast<int>(dice.between(10, 18));
  choose_times(row, dice, dice.between(6, 20), dice.between(10, 60));
  return row;
}

// Cubic rows sharpen a load's kinks, the first of them where the run has begun before.
Row late_row(unsigned seed) {
  Dice dice(seed);
  Row row;
  row.name = fmt::format("late {}", seed);
  give_shape(row, seed % 3);
  lay_equal_blocks(row, dice, 110);
  row.joint = static_cast<int>(dice.between(18, 36));
  choose_times(row, dice, dice.between(10, 20), dice.between(10, 16));
  row.steps = R"(, "integrator": "trapezoidal")";
  row.start = row.unit * std::round(dice.between(3, 20) * row.dt / row.unit);
  row.duration += std::ceil(row.start / row.dt) * row.dt;
  return row;
}

int misses_of(const Row& row) {
  const Model model = parse_scene(scene_of(row), row.name);
  AdviceQuestion question;
  question.limits = false;
  const Advice advice = advise(Simulation(model), question);
  const std::string kind = row.wave == 'b' ? "bar" : (row.wave == 'p' ? "P" : "S");
  const auto& waves = advice.stages[0].waves;
  const auto wave = std::ranges::find_if(
      waves, [&](const WaveAdvice& each) { return each.kind == kind && each.direction_name.find("diagonal") != 0; });
  const auto found = measured(row, model);
  if (wave == waves.end() || !wave->history || !found) {
    ADD_FAILURE() << row.name << ": " << (wave == waves.end() ? "no wave" : wave->not_foretold);
    return 1;
  }
  const ArrivalErrors& advised = wave->history->arrival;
  std::vector<NamedReading> readings = {{"speed", &ArrivalErrors::speed},
                                        {"amplitude", &ArrivalErrors::amplitude},
                                        {"largest", &ArrivalErrors::largest},
                                        {"speed by onset", &ArrivalErrors::onset_speed}};
  if (advised.has_peak) {
    readings.push_back({"peak", &ArrivalErrors::peak});
    readings.push_back({"speed by peak", &ArrivalErrors::peak_speed});
  }
  return misses_of(row.name, advised, *found, readings);
}

template <typename Draw>
int misses_of(const Draw& draw, unsigned from, unsigned to) {
  int misses = 0;
  for (unsigned seed = from; seed < to; ++seed) misses += misses_of(draw(seed));
  return misses;
}

TEST(Lottery, KinkedLoadsThroughCoursesAreAsAdvised) { EXPECT_EQ(misses_of(courses, 0, 8), 0); }
TEST(Lottery, KinkedLoadsThroughRowsOfTwoRocksAreAsAdvised) { EXPECT_EQ(misses_of(alternating_row, 0, 8), 0); }
TEST(Lottery, FewBlocksBetweenRollersAreAsAdvised) { EXPECT_EQ(misses_of(coarse_mesh, 0, 8), 0); }
TEST(Lottery, LoadsThatBeginLateAreAsAdvised) { EXPECT_EQ(misses_of(late_row, 0, 6), 0); }
TEST(Lottery, PWavesInNearlyIncompressibleRockAreAsAdvised) { EXPECT_EQ(misses_of(nearly_incompressible, 0, 12), 0); }
TEST(Lottery, VelocitiesDampedInStepsAreAsAdvised) { EXPECT_EQ(misses_of(damped_row, 0, 6), 0); }

}  // namespace
}  // namespace dda
