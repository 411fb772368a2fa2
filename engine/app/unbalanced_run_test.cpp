// `dda run` of rock with a loose block, and what it leaves about energy release rates and excess shear stress.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "engine/app/command_line_test_support.h"

namespace dda {
namespace {

// A box on a held floor, a stone in the air, and under it a core that a later stage may take out.
std::string loose_rock(const std::string& on_unbalanced, const std::string& later_stages) {
  return fmt::format(R"({{"dda": 1, "gravity": 9.81,
 "materials": {{"rock": {{"density": 2600, "young": 1e10, "poisson": 0.2}}}},
 "joints": {{"default": {{"friction_angle": "20 deg"}}}},
 "blocks": [{{"polygon": {{"name": "floor", "vertices": [[-2, -1], [6, -1], [6, 0], [-2, 0]]}}}},
            {{"polygon": {{"name": "box", "vertices": [[-1, 0], [0, 0], [0, 1], [-1, 1]]}}}},
            {{"polygon": {{"name": "lid", "group": "spoil", "vertices": [[-1, 1], [0, 1], [0, 2], [-1, 2]]}}}},
            {{"polygon": {{"name": "stone", "vertices": [[4, 20], [5, 20], [5, 21], [4, 21]]}}}}],
 "fixed": ["floor"],
 "steps": [{{"name": "settle", "integrator": "static"{}}}{}]}})",
                     on_unbalanced, later_stages);
}

const std::string goes_on = R"(, "on_unbalanced": "continue")";
const std::string stops = R"(, "on_unbalanced": "stop")";
const std::string moves = R"(, {"name": "move", "dt": 1e-3, "duration": 5e-3})";
const std::string digs =
    R"(, {"name": "dig", "integrator": "static", "on_unbalanced": "continue", "remove": ["spoil"]})";

class UnbalancedRun : public CommandLine {
 protected:
  [[nodiscard]] nlohmann::json summary() const { return nlohmann::json::parse(text("out/summary.json")); }
};

TEST_F(UnbalancedRun, EndsOrGoesOnAsItIsTold) {
  EXPECT_EQ(run_scene(loose_rock("", ""), "out").code, 3);
  EXPECT_EQ(run_scene(loose_rock(goes_on, ""), "out").code, 0);
  EXPECT_EQ(run_scene(loose_rock("", moves), "out").code, 0);
  const Outcome stopped = run_scene(loose_rock(stops, moves), "out");
  EXPECT_EQ(stopped.code, 3);
  EXPECT_TRUE(contains(stopped.errors, "\"settle\" has no equilibrium for block \"stone\" at (4.5, 20) m"))
      << stopped.errors;
  EXPECT_EQ(summary()["status"], "not_in_equilibrium");
  EXPECT_EQ(summary()["loose_blocks"].at(0)["block"], "stone");
}

TEST_F(UnbalancedRun, ListsBlocksWithNumberMassAndFaces) {
  write("scene.json", loose_rock(goes_on, moves));
  const Outcome outcome = call({"run", path("scene.json"), "--out", path("out")});
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_TRUE(contains(outcome.out, "loose in stage \"settle\": block \"stone\" (number 3) at (4.5, 20) m"))
      << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "2600 kg/m, held by no face")) << outcome.out;
  const nlohmann::json listed = summary()["loose_blocks"].at(0);
  EXPECT_EQ(listed["stage"], "settle");
  EXPECT_EQ(listed["number"], 3);
  EXPECT_NEAR(listed["mass_kg_per_m"].get<double>(), 2600, 1e-9);
  EXPECT_EQ(listed["held_by"].size(), 0U);
  EXPECT_TRUE(summary()["blocks_out_of_balance"].empty());
  ASSERT_EQ(call({"report", path("out")}).code, 0);
  const std::string page = text("out/report.html");
  EXPECT_TRUE(contains(page, "block &quot;stone&quot; (number 3, 2600 kg/m)")) << page.substr(0, 4000);
}

// Rock cut by lot under a stress by lot, which its surroundings press on with and nothing else holds, and what is dug
// in it. `more`: pieces of the scene beside that.
std::string surrounded_rock(int seed, double stress, const std::string& kinematics, const std::string& more) {
  return fmt::format(R"({{"dda": 1,
 "materials": {{"rock": {{"density": 2600, "young": 2e10, "poisson": 0.25}}}},
 "joints": {{"default": {{"bonded": true}}}},
 "blocks": {{"rock": {{"boundary": [[-20, -20], [20, -20], [20, 20], [-20, 20]], "seed": {},
   "joint_sets": [{{"dip": {{"mean": "30 deg", "deviation": "8 deg"}}, "spacing": 4, "joint": "default"}},
                  {{"dip": {{"mean": "120 deg", "deviation": "8 deg"}}, "spacing": 4, "joint": "default"}}],
   "openings": [{{"name": "tunnel", "circle": {{"centre": [0, 0], "radius": 3}}}}],
   "merge": {{"area": 0.08, "angle": "5 deg"}}}}}},
 "stress_field": {{"xx": {}, "yy": {}, "xy": {}}},
 {}
 "steps": [{{"name": "in situ", "integrator": "static", "kinematics": "{}"}},
           {{"name": "dug", "remove": ["tunnel"], "integrator": "static", "kinematics": "{}"}}]}})",
                     seed, stress, (1 + 0.1 * seed) * stress, 0.05 * seed * stress, more, kinematics, kinematics);
}

// All around: traction of one stress has no resultant on a closed outline, whatever the outline, to round-off.
const std::string all_around = R"("loads": [{"edge": "outside", "traction": "in-situ"}],)";

// It was said to have no equilibrium in all of these.
TEST_F(UnbalancedRun, IsForetoldOfRockThatNothingHoldsByWhatActsOnIt) {
  const auto remarks = [&](const std::string& scene) {
    write("scene.json", scene);
    return call({"check", path("scene.json")}).out;
  };
  for (int seed = 1; seed <= 4; ++seed) {
    const std::string pressed = remarks(surrounded_rock(seed, -5e6, "finite", all_around));
    EXPECT_TRUE(contains(pressed, "\"in situ\" is static, and block \"rock 1\" and ")) << pressed;
    EXPECT_TRUE(contains(pressed, "stage \"dug\" is static, and block \"rock 1\" and ")) << pressed;
    EXPECT_TRUE(contains(pressed, "in balance, but presses in directions that stay, so that it turns")) << pressed;
    EXPECT_FALSE(contains(pressed, "no equilibrium")) << pressed;
    for (const std::string& steady : {remarks(surrounded_rock(seed, -5e6, "small", all_around)),
                                      remarks(surrounded_rock(seed, 5e6, "finite", all_around))}) {
      EXPECT_TRUE(contains(steady, "in balance, but nothing keeps it where it is")) << steady;
      EXPECT_FALSE(contains(steady, "no equilibrium")) << steady;
    }
    const std::string pushed =
        remarks(surrounded_rock(seed, -5e6, "finite", R"("loads": [{"edge": "outside", "traction": "in-situ"},
                                           {"edge": "top", "traction": [1e3, 0]}],)"));
    EXPECT_TRUE(contains(pushed, "touches nothing that is held: it has no equilibrium")) << pushed;
    const std::string turned =
        remarks(surrounded_rock(seed, -5e6, "finite", R"("loads": [{"edge": "outside", "traction": "in-situ"},
                                           {"edge": "top", "traction": [1e3, 0]},
                                           {"edge": "bottom", "traction": [-1e3, 0]}],)"));
    EXPECT_TRUE(contains(turned, "touches nothing that is held: it has no equilibrium")) << turned;
    const std::string held = remarks(surrounded_rock(
        seed, -5e6, "finite", R"("supports": [{"point": [-20, -20]}, {"point": [20, -20], "hold": "y"}],)"));
    EXPECT_FALSE(contains(held, "touches nothing")) << held;
  }
}

// A block that a later stage sets on one that is held touched nothing before it was there, nor when it was.
TEST_F(UnbalancedRun, IsNotForetoldOfBlocksThatAreNotThereYet) {
  const std::string built = R"({"dda": 1, "gravity": 9.81,
 "materials": {"rock": {"density": 2600, "young": 1e10, "poisson": 0.2}},
 "joints": {"default": {"friction_angle": "20 deg"}},
 "blocks": [{"grid": {"columns": 1, "rows": 3, "block_width": 1, "block_height": 1}}],
 "fixed": ["grid 1.1"],
 "steps": [{"name": "one", "integrator": "static"},
           {"name": "two", "integrator": "static", "add": ["grid 3.1"]}]})";
  write("scene.json", built);
  EXPECT_FALSE(contains(call({"run", path("scene.json"), "--out", path("out")}).out, "touches nothing"));
  EXPECT_FALSE(contains(call({"check", path("scene.json")}).out, "touches nothing"));
}

// Dug, it turns as a whole. Two points that hold it are enough.
TEST_F(UnbalancedRun, OfRockThatNothingHoldsSaysSo) {
  const Outcome loose = run_scene(surrounded_rock(2, -5e6, "finite", all_around), "out");
  EXPECT_EQ(loose.code, 3);
  EXPECT_TRUE(contains(loose.errors, "may drift and turn as a whole")) << loose.errors;
  const std::string supports = R"("supports": [{"point": [-20, -20]}, {"point": [20, -20], "hold": "y"}],)";
  const Outcome held = run_scene(surrounded_rock(2, -5e6, "finite", all_around + supports), "out");
  EXPECT_EQ(held.code, 0) << held.errors;
}

// It was "ok" with exit code 0 when it was resumed.
TEST_F(UnbalancedRun, ThatHasEndedHasEndedWhenItIsResumed) {
  for (const std::string& scene : {loose_rock("", ""), loose_rock(stops, moves)}) {
    const Outcome first = run_scene(scene, "out");
    ASSERT_EQ(first.code, 3);
    const std::string message = summary()["message"];
    const Outcome again = call({"run", path("out.json"), "--out", path("out"), "--quiet", "--resume"});
    EXPECT_EQ(again.code, 3);
    EXPECT_EQ(again.errors, first.errors);
    EXPECT_EQ(summary()["status"], "not_in_equilibrium");
    EXPECT_EQ(summary()["message"], message);
  }
}

TEST_F(UnbalancedRun, SaysWhatDiggingReleasedAndWhatJointsCarry) {
  const Outcome outcome = run_scene(loose_rock(goes_on, digs), "out");
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const nlohmann::json rates = summary()["energy_release_rates"];
  ASSERT_EQ(rates.size(), 1U);
  EXPECT_EQ(rates[0]["stage"], "dig");
  EXPECT_NEAR(rates[0]["area_m2"].get<double>(), 1, 1e-12);
  EXPECT_NEAR(rates[0]["wall_m"].get<double>(), 1, 1e-12);
  const double released = rates[0]["released_J_per_m"];
  EXPECT_GT(released, 0);
  EXPECT_EQ(rates[0]["per_volume_J_per_m3"], released);
  EXPECT_EQ(released, summary()["energy_released"]["stages"].at(1)["released_by_fate"]);
  const nlohmann::json excess = summary()["excess_shear"];
  ASSERT_EQ(excess.size(), 2U);
  EXPECT_EQ(excess[1]["joint"], "default");
  // The weight of the box on a level floor, without shear: -tan(20 deg) of 1 m of it.
  EXPECT_NEAR(excess[1]["largest_Pa"].get<double>() / (-2600 * 9.81 * 0.36397023), 1, 1e-6);
  ASSERT_EQ(call({"report", path("out")}).code, 0);
  EXPECT_TRUE(contains(text("out/report.html"), "ERR per volume (J/m3)"));
  EXPECT_TRUE(contains(text("out/report.html"), "largest ESS (Pa)"));
}

// How far it was from balance stood in summary.json alone.
TEST_F(UnbalancedRun, RemarksOnAStageThatWasTooShortToSettle) {
  const auto run = [&](const std::string& steps) {
    nlohmann::json scene = nlohmann::json::parse(loose_rock("", ""));
    scene["blocks"].erase(3);
    scene["steps"] = nlohmann::json::parse(steps);
    write("scene.json", scene.dump());
    const Outcome outcome = call({"run", path("scene.json"), "--out", path("out")});
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    return outcome.out;
  };
  const std::string short_one = R"({"name": "short", "integrator": "static", "dt": 1e-6, "duration": 2e-6)";
  const std::string sentence = "static stage \"short\" ended with forces out of balance by ";
  const std::string out = run("[" + short_one + "}]");
  EXPECT_TRUE(contains(out, "remark: " + sentence)) << out;
  EXPECT_TRUE(contains(out, "was not asked for equilibrium")) << out;
  const std::string said = summary()["remarks"].back();
  EXPECT_TRUE(contains(said, sentence)) << said;
  const std::string shorter = R"(, {"name": "shorter", "integrator": "static", "dt": 1e-7, "duration": 1e-7})";
  EXPECT_TRUE(contains(run("[" + short_one + "}" + shorter + "]"), "(1 other by less) ended with forces"));
  EXPECT_FALSE(contains(run(R"([{"integrator": "static", "dt": 0.1, "duration": 2}])"), "was not asked for"));
  EXPECT_FALSE(contains(run("[" + short_one + R"(, "equilibrium": 1}])"), "was not asked for"));
}

// A block pushed over its floor by friction of 7.08 kN: in steps of 20 ms at 0.1 m/s the push was 19.6 kN, and as it
// had come to rest by the end of the stage nothing was said.
TEST_F(UnbalancedRun, RemarksOnStaticStepsThatHoldBackWhatMoves) {
  const auto said = [&](double dt, double time, double duration, const std::string& more = "") {
    const Outcome outcome = run_scene(
        fmt::format(
            R"({{"dda": 1, "gravity": 9.81, "materials": {{"r": {{"density": 2500, "young": 2e10, "poisson": 0.2}}}},
          "joints": {{"default": {{"friction_angle": "30 deg"}}}},
          "blocks": [{{"polygon": {{"name": "floor", "vertices": [[-2, -1], [4, -1], [4, 0], [-2, 0]]}}}},
                     {{"polygon": {{"name": "block", "vertices": [[0, 0], [1, 0], [1, 0.5], [0, 0.5]]}}}}],
          "fixed": ["floor"],
          "supports": [{{"point": [0, 0.05], "block": "block", "hold": "x", "displacement": [0.1, 0],
                         "history": {{"table": [[0, 0], [{0}, 1]]}}}}],
          "steps": {{"name": "push", "integrator": "static", "dt": {1}, "duration": {2}{3}}}}})",
            time, dt, duration, more),
        "out");
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    return summary()["remarks"].dump();
  };
  const std::string sentence = "inertia took 64 % of the work of what moved or changed in it";
  EXPECT_TRUE(contains(said(0.02, 1, 1.5), sentence));
  EXPECT_TRUE(contains(said(0.02, 1, 1.5, R"(, "equilibrium": 1e-9)"), sentence)) << "asked for equilibrium at its end";
  EXPECT_FALSE(contains(said(1, 50, 75), "inertia took"));
  EXPECT_FALSE(contains(said(1e9, 1, 2e9), "inertia took")) << "moved at once";
}

TEST_F(UnbalancedRun, RefusesTheKeyWhereNothingAsksForEquilibrium) {
  for (const char* steps : {R"({"dt": 1e-3, "duration": 1, "on_unbalanced": "stop"})",
                            R"({"integrator": "static", "dt": 1e-3, "duration": 1, "on_unbalanced": "stop"})"}) {
    nlohmann::json scene = nlohmann::json::parse(loose_rock("", ""));
    scene["steps"] = nlohmann::json::parse(steps);
    write("scene.json", scene.dump());
    expect_refusal({"check", path("scene.json")}, "on_unbalanced is \"stop\", expected to be left out");
  }
  nlohmann::json scene = nlohmann::json::parse(loose_rock(R"(, "on_unbalanced": "go on")", ""));
  write("scene.json", scene.dump());
  expect_refusal({"check", path("scene.json")}, "on_unbalanced is \"go on\"");
}

}  // namespace
}  // namespace dda
