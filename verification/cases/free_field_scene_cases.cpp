// Scenes as text: what a user does.
#include "verification/cases/free_field_scene_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "engine/scene/scene.h"
#include "verification/cases/bar_case.h"
#include "verification/exact/layered_ground.h"
#include "verification/harness/histories.h"
#include "verification/harness/recorded_run.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

constexpr double depth = 20;    // m
constexpr double pulse = 0.15;  // s
constexpr double poisson = 0.3;

struct Soil {
  double density, young;
};
constexpr Soil stiff{2000, 500e6};
constexpr Soil soft{1900, 150e6};

dda::Material material_of(const Soil& soil) {
  return {"soil", soil.density, soil.young, poisson, dda::PlaneState::strain};
}

double speed(const Soil& soil, bool p) {
  return p ? dda::p_wave_speed(material_of(soil)) : dda::s_wave_speed(material_of(soil));
}

enum class Sides { free_field, dashpots };

// Ground on a base that absorbs what comes down and lets a wave rise.
struct Ground {
  int columns = 30, rows = 20;
  double block = 1;    // m
  Soil upper = stiff;  // of the upper half
  bool p = false;      // a P wave, and not an SV wave
  Sides sides = Sides::free_field;
  double duration = 0.5;  // s, of the shaking
  std::string kinematics = "small";
  bool gravity = false;          // and a static stage before
  double quiet = 0;              // s, before the wave in its stage
  std::string on_top = {};       // a block on the surface, with a comma before
  std::vector<double> measured;  // x, on the surface
};

double dt_of(const Ground& ground) { return 2e-3 * ground.block; }
double settled_at(const Ground& ground) { return ground.gravity ? 400 : 0; }

// Velocity of the rising wave at the base, m/s.
double incident(double time) { return smooth_push(1, pulse)(time); }

std::string history(const Ground& ground) {
  std::string rows;
  const double start = settled_at(ground) + ground.quiet;
  if (start > 0) rows = "[0, 0], ";
  const int samples = static_cast<int>(std::lround(pulse / dt_of(ground)));
  for (int i = 0; i <= samples; ++i)
    rows += fmt::format("{}[{}, {}]", i > 0 ? ", " : "", start + i * dt_of(ground), incident(i * dt_of(ground)));
  return rows;
}

std::string blocks(const Ground& ground) {
  const double half = depth / 2;
  const auto grid = [&](const char* name, double bottom) {
    return fmt::format(R"({{"grid": {{"name": "{0}", "material": "{0}", "origin": [0, {1}], "columns": {2}, "rows": {3},
        "block_width": {4}, "block_height": {4}}}}})",
                       name, bottom, ground.columns, ground.rows / 2, ground.block);
  };
  return grid("lower", 0) + ", " + grid("upper", half) + ground.on_top;
}

std::string materials(const Ground& ground) {
  const auto entry = [](const char* name, const Soil& soil) {
    return fmt::format(R"("{}": {{"density": {}, "young": {}, "poisson": {}}})", name, soil.density, soil.young,
                       poisson);
  };
  return entry("lower", stiff) + ", " + entry("upper", ground.upper) + ", " + entry("iron", {6000, 50e9});
}

std::string steps(const Ground& ground) {
  const std::string settle =
      R"({"name": "settle", "integrator": "static", "equilibrium": 1e-10, "dt": 20, "duration": 400, )"
      R"("kinematics": ")" +
      ground.kinematics + "\"}, ";
  return (ground.gravity ? settle : "") +
         fmt::format(R"({{"name": "wave", "dt": {}, "duration": {}, "kinematics": "{}"}})", dt_of(ground),
                     ground.duration, ground.kinematics);
}

std::string measurements(const Ground& ground) {
  std::string list;
  for (std::size_t i = 0; i < ground.measured.size(); ++i)
    list +=
        fmt::format(R"({}{{"name": "v {}", "quantity": "velocity_{}", "point": [{}, {}], "side": "{}"}})",
                    i > 0 ? ", " : "", i, ground.p ? "y" : "x", ground.measured[i], depth, i == 0 ? "right" : "left");
  return list;
}

std::string scene_of(const Ground& ground) {
  const double traction = 2 * stiff.density * speed(stiff, ground.p);
  const char* free_field = ground.sides == Sides::free_field ? R"(, "free_field": true)" : "";
  const char* supports =
      ground.gravity ? R"("gravity": "9.81 m/s2", "supports": [{"edge": "bottom", "until_stage": "settle"}],)" : "";
  return fmt::format(R"({{"dda": 1, "plane": "strain", "materials": {{{}}}, "joints": {{"default": {{"bonded": true}}}},
      "blocks": [{}], {}
      "viscous_boundaries": [{{"edge": "bottom"{}}},
        {{"edge": {{"from": [0, 0], "to": [0, {}]}}{}}}, {{"edge": {{"from": [{}, 0], "to": [{}, {}]}}{}}}],
      "loads": [{{"edge": "bottom", "traction": [{}, {}], "history": {{"table": [{}]}}}}],
      "measurements": [{}], "steps": [{}]}})",
                     materials(ground), blocks(ground), supports, ground.gravity ? R"(, "from_stage": "wave")" : "",
                     depth, free_field, ground.columns * ground.block, ground.columns * ground.block, depth, free_field,
                     ground.p ? 0 : traction, ground.p ? traction : 0, history(ground), measurements(ground),
                     steps(ground));
}

dda::Model model_of(const Ground& ground) { return dda::parse_scene(scene_of(ground), "ground"); }

Ground finer(Ground ground) {
  ground.columns *= 2;
  ground.rows *= 2;
  ground.block /= 2;
  return ground;
}

// What the surface does as a column in one dimension.
std::vector<double> column_surface(const Ground& ground, std::size_t samples) {
  const double below = speed(stiff, ground.p);
  const double above = speed(ground.upper, ground.p);
  const exact::LayeredGround layers{stiff.density * below, ground.upper.density * above, depth / 2 / below,
                                    depth / 2 / above};
  std::vector<double> surface;
  for (std::size_t i = 0; i < samples; ++i)
    surface.push_back(exact::surface_velocity(layers, incident, static_cast<double>(i) * dt_of(ground)));
  return surface;
}

// Largest difference at any measured point from the column, of the column's largest.
double difference_from_column(const Ground& ground, Outcome& outcome) {
  const RecordedRun run = record_run(model_of(ground));
  outcome.counters += run.counters;
  double largest = 0;
  for (const std::vector<double>& velocity : run.histories)
    keep_largest(largest, largest_difference(velocity, column_surface(ground, velocity.size())));
  return largest;
}

void assert_surface(const Ground& ground, const std::string& wave, const char* measured, double tolerance,
                    const std::string& source, Outcome& outcome) {
  const double coarse = difference_from_column(ground, outcome);
  const double fine = difference_from_column(finer(ground), outcome);
  outcome.assertions.push_back(
      expect("largest difference of any point of the surface from the exact motion, " + wave, "-")
          .is(coarse)
          .against(0, source)
          .absolutely()
          // Blocks' errors are of order 4 inside a layer, of order 2 at its edges; steps' of order 2.
          .of_order({order(coarse, fine), 2, 0.4})
          .within(tolerance, fmt::format("measured {} with margin", measured)));
  Ground alone = ground;
  alone.sides = Sides::dashpots;
  const double without = difference_from_column(alone, outcome);
  outcome.assertions.push_back(expect("the same with dashpots alone, over that, " + wave, "-")
                                   .is(without / coarse)
                                   .against(0, "they hold the sides back; tolerance on the inverse")
                                   .off_by(coarse / without)
                                   .within(0.02, "that the case tells one from the other; measured with margin"));
}

Ground surface_of(const Soil& upper, bool p) {
  Ground ground;
  ground.upper = upper;
  ground.p = p;
  for (const double x : {0.0, 1.0, 5.0, 15.0, 29.0, 30.0}) ground.measured.push_back(x);
  return ground;
}

Outcome rising_pulse() {
  Outcome outcome;
  const std::string source = "2 incident(t - depth/speed)";
  assert_surface(surface_of(stiff, false), "SV", "9.1e-4", 1e-3, source, outcome);
  assert_surface(surface_of(stiff, true), "P", "1.3e-3", 2e-3, source, outcome);
  return outcome;
}

Outcome layers() {
  Outcome outcome;
  const std::string source = "verification/exact/layered_ground.h";
  assert_surface(surface_of(soft, false), "SV", "1.3e-3", 2e-3, source, outcome);
  assert_surface(surface_of(soft, true), "P", "1.1e-3", 2e-3, source, outcome);
  return outcome;
}

// Largest velocity of any block's centroid.
double largest_velocity(const dda::State& state) {
  double largest = 0;
  for (const dda::Vec6& velocity : state.velocity) keep_largest(largest, velocity.head<2>().norm());
  return largest;
}

void advance_until(dda::Simulation& simulation, double time) {
  while (!simulation.finished() && simulation.state().time < time - 1e-9) advance(simulation, 1);
}

double largest_change(const dda::State& settled, const dda::State& state) {
  double largest = 0;
  for (std::size_t block = 0; block < settled.stress.size(); ++block)
    keep_largest(largest, (state.stress[block] - settled.stress[block]).norm());
  return largest;
}

// Settled, quiet, shaken, quiet again: nothing but what is left of the wave may show, in either kinematics.
void assert_gravity(const std::string& kinematics, Outcome& outcome) {
  Ground ground = surface_of(soft, false);
  ground.gravity = true;
  ground.kinematics = kinematics;
  ground.quiet = 0.2;
  ground.duration = 4;
  dda::Simulation simulation(model_of(ground));
  advance_until(simulation, settled_at(ground));
  const dda::State settled = simulation.state();
  const dda::State settled_columns = simulation.free_field_columns()->state();
  double largest = 0;
  for (const dda::Vec3& stress : settled.stress) keep_largest(largest, stress.norm());
  const auto assert_small = [&](const std::string& quantity, const std::string& unit, double value,
                                const std::string& source) {
    outcome.assertions.push_back(
        expect(quantity + ", " + kinematics + " kinematics", unit)
            .is(value)
            .against(0, source)
            .absolutely()
            .within(1e-6, "equilibrium to 1e-10 of the load; what is left of the wave after 3.3 s"));
  };
  advance_until(simulation, settled_at(ground) + ground.quiet - 2 * dt_of(ground));  // loads are known a step ahead
  assert_small("largest velocity 0.2 s after the supports went, before a wave of 1 m/s", "m/s",
               largest_velocity(simulation.state()), "sides in equilibrium");
  double pushed = 0;
  while (!simulation.finished()) {
    advance(simulation, 1);
    for (std::size_t block = 0; block < settled.stress.size(); ++block)
      keep_largest(pushed, simulation.state().stress[block](0) - settled.stress[block](0));
  }
  const double strain = 2 * incident(pulse / 2) / speed(soft, false);
  const double shear_modulus = soft.young / (2 * (1 + poisson));
  const double sheared = pushed / (strain * shear_modulus);
  outcome.assertions.push_back(
      expect("largest horizontal stress while the wave passes, of its shear stress, " + kinematics + " kinematics", "-")
          .is(sheared)
          .against(0, "a plane wave shears alone")
          .absolutely()
          .within(strain, "finite shear has normal stress of second order in the strain"));
  assert_small("largest velocity 3.3 s after the wave has left", "m/s", largest_velocity(simulation.state()),
               "the ground at rest again");
  assert_small("largest change of any stress since it settled, of the largest", "-",
               largest_change(settled, simulation.state()) / largest, "no creep of the sides");
  assert_small("the same of the columns", "-",
               largest_change(settled_columns, simulation.free_field_columns()->state()) / largest,
               "strains that come and go leave nothing behind");
  outcome.counters += simulation.counters();
}

Outcome gravity() {
  Outcome outcome;
  for (const char* kinematics : {"small", "finite"}) assert_gravity(kinematics, outcome);
  return outcome;
}

// A block of iron on the surface, sideways waves of which must leave through the sides.
Ground with_iron(int columns, double left, Sides sides) {
  Ground ground;
  ground.columns = columns;
  ground.sides = sides;
  ground.duration = 0.6;
  const double centre = columns / 2.0;
  ground.on_top = fmt::format(
      R"(, {{"polygon": {{"name": "iron", "material": "iron", "vertices": [[{0}, {2}], [{1}, {2}], [{1}, {3}], [{0}, {3}]]}}}})",
      centre - 2, centre + 2, depth, depth + 2);
  for (const double x : {0.0, 5.0, 10.0, 20.0, 25.0, 30.0}) ground.measured.push_back(left + x);
  return ground;
}

Outcome scattered() {
  constexpr int wide = 230;  // Rayleigh and S waves from its sides need 0.6 s to come
  Outcome outcome;
  const RecordedRun reference = record_run(model_of(with_iron(wide, (wide - 30) / 2.0, Sides::free_field)));
  const RecordedRun narrow = record_run(model_of(with_iron(30, 0, Sides::free_field)));
  const RecordedRun alone = record_run(model_of(with_iron(30, 0, Sides::dashpots)));
  for (const RecordedRun* run : {&reference, &narrow, &alone}) outcome.counters += run->counters;
  const std::vector<double> column = column_surface(with_iron(30, 0, Sides::free_field), reference.histories[0].size());
  double scattering = 0, error = 0, error_alone = 0;
  for (std::size_t i = 0; i < reference.histories.size(); ++i)
    for (std::size_t step = 0; step < column.size(); ++step) {
      keep_largest(scattering, reference.histories[i][step] - column[step]);
      keep_largest(error, narrow.histories[i][step] - reference.histories[i][step]);
      keep_largest(error_alone, alone.histories[i][step] - reference.histories[i][step]);
    }
  const std::string source = "the same 230 m wide, whose sides are too far to be felt";
  outcome.assertions.push_back(expect("largest difference of any point of the surface, of the incident wave", "-")
                                   .is(error)
                                   .against(0, source)
                                   .absolutely()
                                   .within(0.1, "dashpots at the sides meet waves at an angle; measured with margin"));
  outcome.assertions.push_back(expect("the same, of the largest scattered velocity", "-")
                                   .is(error / scattering)
                                   .against(0, source)
                                   .absolutely()
                                   .within(0.25, "the same"));
  outcome.assertions.push_back(expect("with dashpots alone, over that", "-")
                                   .is(error_alone / error)
                                   .against(0, "they hold the sides back; tolerance on the inverse")
                                   .off_by(error / error_alone)
                                   .within(0.1, "that the case tells one from the other; measured with margin"));
  return outcome;
}

}  // namespace

std::vector<Case> free_field_scene_cases() {
  return {{"free-field-pulse",
           "P and SV pulses rise through ground with free-field sides",
           {39},
           CaseLabel::slow,
           rising_pulse},
          {"free-field-layers", "The same through two layers", {39}, CaseLabel::slow, layers},
          {"free-field-gravity", "The same after the ground settled under its weight", {39}, CaseLabel::slow, gravity},
          {"free-field-scattering",
           "What a heavy block on the surface scatters leaves through free-field sides",
           {39},
           CaseLabel::slow,
           scattered}};
}

}  // namespace verify
