// Runs whose energies say that the result is wrong.
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "engine/app/command_line_test_support.h"
#include "engine/geometry/cut_pieces.h"
#include "engine/geometry/rotation.h"

namespace dda {
namespace {

class Verdict : public CommandLine {};

// A support that moves off at once pushes a damped bar.
nlohmann::json pushed_bar(const char* dt) {
  return {{"dda", 1},
          {"materials", {{"rock", {{"density", 2500}, {"young", 20e9}, {"poisson", 0}}}}},
          {"joints", {{"default", {{"bonded", true}}}}},
          {"blocks", {{"bar", {{"length", 20}, {"height", 1}, {"block_length", 0.5}}}}},
          {"supports",
           {{{"name", "piston"}, {"edge", "left"}, {"hold", "x"}, {"velocity", {0.1, 0}}},
            {{"point", {0.25, 0}}, {"hold", "y"}},
            {{"point", {20, 0}}, {"hold", "y"}}}},
          {"steps",
           {{"dt", dt},
            {"duration", "2 ms"},
            {"kinematics", "small"},
            {"damping", {{"ratio", 0.02}, {"frequency", "100 Hz"}}}}}};
}

// A block that two others press, glued to one of them by a joint with springs that are not stiff: they take over the
// whole force as it breaks, and store F^2/2k of it at any dt.
TEST_F(Verdict, EnergyOfSpringsThatTakeOverIsSaidToBeTheirs) {
  const auto square = [](const char* name, double x) {
    return nlohmann::json{{"polygon",
                           {{"name", name},
                            {"vertices", {{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}}},
                            {"initial_stress", {{"xx", "-20 MPa"}}}}}};
  };
  for (const double dt : {1e-5, 1e-6}) {
    const nlohmann::json scene = {
        {"dda", 1},
        {"materials", {{"rock", {{"density", 2500}, {"young", 1e10}, {"poisson", 0}}}}},
        {"joints", {{"default", {{"cohesion", "1 MPa"}, {"law", "consistent"}, {"spring_over_young", 10}}}}},
        {"blocks", {square("wall", -1), square("block", 0)}},
        {"fixed", {"wall"}},
        {"loads",
         {{{"edge", {{"from", {1, 0}}, {"to", {1, 1}}}}, {"traction", {-20e6, 0}}},
          {{"point", {0.5, 0.5}}, {"force", {0, 2e6}}, {"history", {{"table", {{0, 0}, {4e-4, 1}}}}}}}},
        {"steps", {{"dt", dt}, {"duration", 2e-3}, {"kinematics", "small"}}}};
    write("glued.json", scene.dump());
    const Outcome outcome = call({"run", path("glued.json"), "--out", path("out"), "--quiet"});
    EXPECT_TRUE(contains(outcome.errors, "joints that went over to springs as they slid or broke added"))
        << outcome.errors;
    const nlohmann::json energy = nlohmann::json::parse(text("out/summary.json"))["energy"];
    const double stored = 2e7 * 2e7 / (2 * 2 * 10 * 1e10);  // by two springs of 10 E
    EXPECT_NEAR(energy["law_changes"].get<double>(), -stored, 0.05 * stored);
    EXPECT_LT(std::abs(energy["numerical"].get<double>()), 0.05 * stored);
  }
}

// Most of every velocity goes at the end of every step, and the accelerations stay: what they do in the next step is no
// gain.
TEST_F(Verdict, StepsThatTakeVelocitiesDoNotGain) {
  for (const double factor : {0.0, 0.25, 0.5}) {
    const nlohmann::json scene = {
        {"dda", 1},
        {"materials", {{"rock", {{"density", 2500}, {"young", 1e10}, {"poisson", 0.2}}}}},
        {"joints", {{"default", {{"friction_angle", "35 deg"}}}}},
        {"blocks",
         {{{"polygon", {{"name", "base"}, {"vertices", {{-1, -1}, {3, -1}, {3, 0}, {-1, 0}}}}}},
          {{"grid", {{"name", "w"}, {"columns", 2}, {"rows", 2}, {"block_width", 1}, {"block_height", 1}}}}}},
        {"fixed", {"base"}},
        {"gravity", 9.81},
        {"steps", {{"dt", 1e-3}, {"duration", 0.5}, {"velocity_factor", factor}}}};
    write("wall.json", scene.dump());
    const Outcome outcome = call({"run", path("wall.json"), "--out", path("out"), "--quiet"});
    EXPECT_EQ(outcome.code, 0) << factor << outcome.errors;
    EXPECT_EQ(outcome.errors, "") << factor;
    const nlohmann::json energy = nlohmann::json::parse(text("out/summary.json"))["energy"];
    EXPECT_GT(energy["damping"].get<double>(), 0);
    EXPECT_LT(std::abs(energy["residual_relative"].get<double>()), 1e-9);
  }
}

// A displacement that jumps within a step: the damping is proportional to a velocity that no step sees.
TEST_F(Verdict, DampersThatGiveEnergyMakeARunInaccurate) {
  nlohmann::json scene = pushed_bar("1 ms");
  scene["supports"][0].erase("velocity");
  scene["supports"][0]["displacement"] = {1e-3, 0};
  scene["supports"][0]["history"] = {{"table", {{0, 0}, {0.01, 0}, {0.0100001, 1}, {1, 1}}}};
  scene["steps"]["duration"] = "20 ms";
  scene["steps"]["integrator"] = "trapezoidal";
  write("bar.json", scene.dump());
  const Outcome outcome = call({"run", path("bar.json"), "--out", path("out"), "--quiet"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_TRUE(contains(outcome.errors, "damping gave")) << outcome.errors;
  EXPECT_TRUE(contains(outcome.errors, "take a smaller dt")) << outcome.errors;
}

// Work and losses are those of the bar, whatever dt and integrator: what dampers do at once is done at once.
TEST_F(Verdict, ASupportThatMovesOffAtOnceIsFineAtAnyTimeStep) {
  double work = 0;
  for (const char* dt : {"1e-6 s", "1e-5 s", "1e-4 s"})
    for (const nlohmann::json& integrator :
         {nlohmann::json("trapezoidal"), nlohmann::json{{"hht", 0.1}}, nlohmann::json{{"generalized_alpha", 0.85}}}) {
      nlohmann::json scene = pushed_bar(dt);
      scene["steps"]["integrator"] = integrator;
      scene["steps"]["correct_time_dispersion"] = false;
      write("bar.json", scene.dump());
      const Outcome outcome = call({"run", path("bar.json"), "--out", path("out"), "--quiet"});
      EXPECT_EQ(outcome.code, 0) << dt << integrator << outcome.errors;
      EXPECT_EQ(outcome.errors, "");
      const nlohmann::json energy = nlohmann::json::parse(text("out/summary.json"))["energy"];
      const double lost = energy["damping"].get<double>() + energy["numerical"].get<double>();
      EXPECT_GT(lost, 0) << dt << integrator;
      if (work == 0) work = energy["external_work"];
      EXPECT_NEAR(energy["external_work"].get<double>() / work, 1, 0.05) << dt << integrator;
    }
}

// Damping where nothing moves yet, as before a load that begins late, or in a stage that ends before it.
TEST_F(Verdict, ARunInWhichNothingHappensIsFine) {
  for (const char* integrator : {"trapezoidal", "thesis"}) {
    nlohmann::json scene = pushed_bar("1e-5 s");
    scene["supports"][0].erase("velocity");
    scene["loads"] = {{{"edge", "right"},
                       {"force", {1000, 0}},
                       {"history", {{"sine", {{"frequency", 100}, {"cycles", 1}, {"start", 1}}}}}}};
    scene["steps"]["integrator"] = integrator;
    write("bar.json", scene.dump());
    const Outcome outcome = call({"run", path("bar.json"), "--out", path("out"), "--quiet"});
    EXPECT_EQ(outcome.code, 0) << integrator << outcome.errors;
    EXPECT_EQ(outcome.errors, "") << integrator;
    EXPECT_FALSE(contains(text("out/summary.json"), "nan")) << integrator;
  }
}

// A box above a fixed floor, by `gap`.
nlohmann::json box_above_floor(double gap, const char* duration) {
  const auto outline = [](double left, double bottom, double right, double top) -> nlohmann::json {
    return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
  };
  return {{"dda", 1},
          {"gravity", 9.81},
          {"materials", {{"rock", {{"density", 2600}, {"young", "20 GPa"}, {"poisson", 0.2}}}}},
          {"joints", {{"default", {{"friction_angle", "30 deg"}, {"law", "classical"}}}}},
          {"blocks",
           {{{"polygon", {{"name", "floor"}, {"vertices", outline(0, -1, 4, 0)}}}},
            {{"polygon", {{"name", "box"}, {"vertices", outline(1.5, gap, 2.5, 1 + gap)}}}}}},
          {"fixed", {"floor"}},
          {"steps", {{"dt", "2 ms"}, {"duration", duration}, {"integrator", "thesis"}}}};
}

// What lands and stays has lost all it had; what is put down and settles loses half of next to nothing.
TEST_F(Verdict, WhatStepsLoseIsSaid) {
  const auto errors_of = [&](const nlohmann::json& scene) {
    write("box.json", scene.dump());
    const Outcome outcome = call({"run", path("box.json"), "--out", path("out"), "--quiet"});
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    return outcome.errors;
  };
  EXPECT_TRUE(contains(errors_of(box_above_floor(0.3, "1 s")), "warning: time integration took"));
  EXPECT_EQ(errors_of(box_above_floor(0, "0.5 s")), "");
  EXPECT_EQ(errors_of(box_above_floor(0.3, "0.1 s")), "");  // it is still falling
}

// A block that is let go on ground which no step resolves.
nlohmann::json block_on_ground(int steps, const nlohmann::json& integrator) {
  const auto box = [](const char* name, double left, double bottom, double right, double top) {
    return nlohmann::json{
        {"polygon", {{"name", name}, {"vertices", {{left, bottom}, {right, bottom}, {right, top}, {left, top}}}}}};
  };
  return {{"dda", 1},
          {"gravity", 9.81},
          {"materials", {{"stone", {{"density", 2500}, {"young", 1e9}, {"poisson", 0.2}}}}},
          {"joints", {{"default", {{"friction_angle", 0.6}}}}},
          {"blocks", {box("base", -2, -1, 4, 0), box("b", 0, 0, 1, 1)}},
          {"fixed", {"base"}},
          {"steps", {{"dt", 0.01}, {"duration", 0.01 * steps}, {"integrator", integrator}}}};
}

// A run of one step has half of its velocities from a fall that did not happen; the second takes them out again.
TEST_F(Verdict, WhatTheFirstStepsMakeOfTheStartIsNoGain) {
  for (const double rho : {0.0, 0.25, 0.5, 0.75})
    for (const int steps : {1, 2, 3, 5, 8}) {
      write("block.json", block_on_ground(steps, {{"generalized_alpha", rho}}).dump());
      const Outcome outcome = call({"run", path("block.json"), "--out", path("out"), "--quiet"});
      EXPECT_EQ(outcome.code, 0) << rho << ", " << steps << ": " << outcome.errors;
      if (rho == 0 && steps == 1) {
        EXPECT_TRUE(contains(outcome.errors, "warning: time integration added 0.716 J/m")) << outcome.errors;
        EXPECT_TRUE(contains(outcome.errors, "take more steps, or a smaller dt")) << outcome.errors;
      }
    }
}

// Nor is it a gain for a while. All that is stored in a block that stands is what its weight presses into it, far less
// than the fall that did not happen.
TEST_F(Verdict, ABlockThatStandsGainsNothingForAWhile) {
  for (const char* dt : {"2 ms", "0.5 ms", "0.1 ms"})
    for (const double rho : {0.0, 0.25, 0.5}) {
      nlohmann::json scene = block_on_ground(100, {{"generalized_alpha", rho}});
      scene["steps"]["dt"] = dt;
      scene["steps"]["duration"] = "0.1 s";
      scene["materials"]["stone"]["young"] = "20 GPa";
      write("block.json", scene.dump());
      const Outcome outcome = call({"run", path("block.json"), "--out", path("out"), "--quiet"});
      EXPECT_EQ(outcome.code, 0) << dt << ", " << rho << ": " << outcome.errors;
      EXPECT_EQ(outcome.errors, "") << dt << ", " << rho;
    }
}

// Polygons by lot on their way to each other, three to seven corners each.
nlohmann::json cloud(std::uint64_t seed) {
  SeededNumbers random(seed);
  nlohmann::json blocks = nlohmann::json::array();
  const int count = random.integer(4, 11);
  for (int i = 0; i < count; ++i) {
    const int corners = random.integer(3, 7);
    const double radius = random.number(0.15, 0.5), flat = random.number(0.4, 1), turn = random.number(0, 6);
    const Vec2 middle(1.3 * (i % 4) + random.number(-0.1, 0.1), 1.3 * (i / 4) + random.number(-0.1, 0.1));
    nlohmann::json vertices;
    for (int k = 0; k < corners; ++k) {
      const double at = 2 * std::numbers::pi * k / corners;
      const Vec2 corner = middle + rotation(turn) * Vec2(radius * std::cos(at), flat * radius * std::sin(at));
      vertices.push_back({corner.x(), corner.y()});
    }
    const Vec2 velocity = Vec2(2, 1.3) - middle + Vec2(random.number(-0.3, 0.3), random.number(-0.3, 0.3));
    blocks.push_back({{"polygon",
                       {{"name", "b" + std::to_string(i)},
                        {"vertices", vertices},
                        {"initial_velocity", {velocity.x(), velocity.y()}},
                        {"initial_spin", random.number(-1, 1)}}}});
  }
  return {{"dda", 1},
          {"materials", {{"rock", {{"density", 2500}, {"young", 5e9}, {"poisson", 0.25}}}}},
          {"joints", {{"default", {{"friction_angle", 0}}}}},
          {"blocks", blocks},
          {"steps", {{"dt", "1 ms"}, {"duration", "2 s"}}}};
}

// Where a vertex goes over to another edge the force that it pressed with is shear there, in part. What there is no
// friction for is lost by the impact: booked as friction it made a gain of integration of the rest.
TEST_F(Verdict, BlocksWithoutFrictionLoseNothingByIt) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    write("cloud.json", cloud(seed).dump());
    const Outcome outcome = call({"run", path("cloud.json"), "--out", path("out"), "--quiet"});
    EXPECT_EQ(outcome.code, 0) << seed << outcome.errors;
    const nlohmann::json energy = nlohmann::json::parse(text("out/summary.json"))["energy"];
    EXPECT_EQ(energy["friction"], 0.0) << seed;
    EXPECT_LE(energy["kinetic"].get<double>(), energy["initial_kinetic"].get<double>()) << seed;
    EXPECT_LT(std::abs(energy["residual_relative"].get<double>()), 1e-9) << seed;
  }
}

}  // namespace
}  // namespace dda
