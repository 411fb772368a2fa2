// Peaks of a run: the files, the page, and what is refused.
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/app/command_line_test_support.h"

namespace dda {
namespace {

using nlohmann::json;

json box(const char* name, double left, double bottom, double width, double height) {
  const double right = left + width;
  const double top = bottom + height;
  return {{"polygon", {{"name", name}, {"vertices", {{left, bottom}, {right, bottom}, {right, top}, {left, top}}}}}};
}

// A floor, a lump on it that is removed, and two stones that have been thrown: they fly for 0.2 s without touching
// anything.
json thrown_stones() {
  json scene = {
      {"dda", 1},
      {"gravity", 10},
      {"materials", {{"rock", {{"density", 2000}, {"young", "1 GPa"}, {"poisson", 0.2}}}}},
      {"joints", {{"default", {{"friction_angle", "30 deg"}}}}},
      {"blocks",
       {box("floor", -50, -11, 100, 1), box("lump", 20, -10, 2, 3), box("slow", 0, 0, 1, 1), box("fast", 5, 0, 2, 1)}},
      {"fixed", {"floor"}},
      {"measurements", {{{"quantity", "velocity_y"}, {"block", "fast"}}}},
      {"peaks",
       {{"stage", "flight"},
        {"ejected", {{"distance", "0.5 m"}, {"opening", "lump"}}},
        {"attenuation", {{"source", {-1.5, 0.5}}, {"charge", "4 kg"}}}}},
      {"steps",
       {{{"name", "wait"}, {"dt", "1 ms"}, {"duration", "1 ms"}, {"integrator", "trapezoidal"}},
        {{"name", "flight"},
         {"remove", {"lump"}},
         {"dt", "1 ms"},
         {"duration", "0.2 s"},
         {"integrator", "trapezoidal"}},
        {{"name", "after"}, {"dt", "1 ms"}, {"duration", "10 ms"}, {"integrator", "trapezoidal"}}}}};
  scene["blocks"][2]["polygon"]["initial_velocity"] = {0, 1.01};  // 1 m/s when the flight begins
  scene["blocks"][3]["polygon"]["initial_velocity"] = {0, 4.01};
  return scene;
}

class Peaks : public CommandLine {
 protected:
  Outcome run(const json& scene, const std::string& folder, const std::vector<std::string>& options = {}) const {
    return run_scene(scene.dump(), folder, options);
  }
  [[nodiscard]] json summary(const std::string& folder) const { return json::parse(text(folder + "/summary.json")); }
};

TEST_F(Peaks, AreThoseOfAKnownFlight) {
  ASSERT_EQ(run(thrown_stones(), "out").code, 0);
  const json peaks = summary("out")["peaks"];
  EXPECT_EQ(peaks["stage"], "flight");
  EXPECT_EQ(peaks["complete"], true);
  EXPECT_EQ(peaks["blocks"], 2);
  EXPECT_EQ(peaks["velocity"]["block"], "fast");
  EXPECT_NEAR(peaks["velocity"]["m_s"].get<double>(), 4, 1e-12);
  EXPECT_NEAR(peaks["velocity"]["time_s"].get<double>(), 1e-3, 1e-15);
  // 4/dt^2 = 4e6 times the round-off of increments of 4e-3 m, over 200 steps.
  EXPECT_NEAR(peaks["acceleration"]["m_s2"].get<double>(), 10, 1e-8);
  // "slow" goes 0.05 m up, "fast" 0.6 m: 2 m2 of 2 t/m2 at 4 m/s; the lump leaves 2 m of wall.
  const json& ejected = peaks["ejected"];
  EXPECT_EQ(ejected["blocks"], 1);
  EXPECT_NEAR(ejected["mass_kg_per_m"].get<double>(), 4000, 1e-9);
  EXPECT_NEAR(ejected["kinetic_energy_J_per_m"].get<double>(), 32000, 1e-7);
  EXPECT_NEAR(ejected["kinetic_energy_at_end_J_per_m"].get<double>(), 8000, 1e-7);
  EXPECT_NEAR(ejected["largest_velocity_m_s"].get<double>(), 4, 1e-12);
  EXPECT_NEAR(ejected["wall_m"].get<double>(), 2, 1e-12);
  EXPECT_NEAR(ejected["kinetic_energy_kJ_per_m2"].get<double>(), 16, 1e-10);
  EXPECT_TRUE(ejected["velocity_m_s"].is_null());
  // Both at the end of the flight: 1 - 2 and 4 - 2 m/s; the ledger has that of the end of the run.
  EXPECT_NEAR(peaks["kinetic_energy_J_per_m"].get<double>(), 1000 * 1 + 2000 * 4, 1e-7);
  EXPECT_EQ(lines(text("out/peaks.csv")), 3);
  EXPECT_TRUE(contains(text("out/peaks.csv"), "\nslow,0.5,")) << text("out/peaks.csv");
  EXPECT_TRUE(peaks["attenuation"]["K_m_s"].is_null()) << "one block that is not ejected";
}

// 10 x 6 m of rock in squares of 1 m, and a pit 2 m wide and 2 m deep from its surface down, whose drawn outline ends 1
// m above it.
json pit(bool left_out) {
  json opening = {{"name", "pit"}, {"rectangle", {{"foot", {5, 4}}, {"width", 2}, {"height", 3}}}};
  if (left_out) opening["left_out"] = true;
  const json joints = {{{"dip", 0}, {"spacing", 1}, {"joint", "default"}, {"start", {0, 0}}},
                       {{"dip", "90 deg"}, {"spacing", 1}, {"joint", "default"}, {"start", {0, 0}}}};
  json dig = {{"name", "dig"}, {"dt", "1 ms"}, {"duration", "5 ms"}};
  if (!left_out) dig["remove"] = {"pit"};
  return {
      {"dda", 1},
      {"gravity", 9.81},
      {"materials", {{"rock", {{"density", 2600}, {"young", "20 GPa"}, {"poisson", 0.2}}}}},
      {"joints", {{"default", {{"friction_angle", "30 deg"}}}}},
      {"blocks",
       {{"rock", {{"boundary", {{0, 0}, {10, 0}, {10, 6}, {0, 6}}}, {"joint_sets", joints}, {"openings", {opening}}}}}},
      {"supports", {{{"edge", "bottom"}}, {{"edge", "left"}, {"hold", "x"}}, {{"edge", "right"}, {"hold", "x"}}}},
      {"peaks", {{"ejected", {{"velocity", "1 mm/s"}, {"opening", "pit"}}}}},
      {"steps", {{{"integrator", "static"}}, dig}}};
}

// Energy was spread over the surface of the ground as well, 8 m with it.
TEST_F(Peaks, SpreadEnergyOverRockThatStays) {
  ASSERT_EQ(run(pit(false), "dug").code, 0);
  const json dug = summary("dug");
  EXPECT_NEAR(dug["peaks"]["ejected"]["wall_m"].get<double>(), 6, 1e-12);
  EXPECT_NEAR(dug["energy_release_rates"][0]["wall_m"].get<double>(), 6, 1e-12);
  ASSERT_EQ(run(pit(true), "there").code, 0);
  EXPECT_NEAR(summary("there")["peaks"]["ejected"]["wall_m"].get<double>(), 6, 1e-12);
}

// The wall of blocks that nobody takes out was that of their outline.
TEST_F(Peaks, OfAnOpeningThatIsStillThereAreRefused) {
  json scene = pit(false);
  scene["steps"][1].erase("remove");
  const Outcome outcome = run(scene, "out");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(contains(outcome.errors,
                       "peaks.ejected.opening is \"pit\", of which \"pit 1\" is there in stage \"dig\", "
                       "expected blocks that are away in the stage of peaks"))
      << outcome.errors;
}

// The end of the stage is the end of the run: energies are those of its ledger.
TEST_F(Peaks, HaveTheEnergyOfTheLedger) {
  json scene = thrown_stones();
  scene["steps"].erase(2);
  scene["peaks"].erase("ejected");
  ASSERT_EQ(run(scene, "out").code, 0);
  const json all = summary("out");
  const double kinetic = all["energy"]["kinetic"];
  EXPECT_NEAR(all["peaks"]["kinetic_energy_J_per_m"].get<double>(), kinetic, 1e-12 * kinetic);
  EXPECT_TRUE(all["peaks"]["ejected"].is_null());
  // Two distances, two speeds: the line goes through both. R/2 = 1 and 3.75 m but for the 1 and 4 mm that the stones
  // have risen by then (2e-7); 1 and 4 m/s are what they begin with.
  const json& law = all["peaks"]["attenuation"];
  EXPECT_EQ(law["points"], 2);
  EXPECT_NEAR(law["n"].get<double>(), -std::log(4) / std::log(3.75), 1e-6);
  EXPECT_NEAR(law["K_m_s"].get<double>(), 1, 1e-6);
  EXPECT_NEAR(law["correlation"].get<double>(), 1, 1e-12);
}

TEST_F(Peaks, AreOnThePage) {
  json scene = thrown_stones();
  scene["peaks"]["ejected"]["distance"] = "5 m";
  scene["peaks"]["ejected"]["velocity"] = "4.5 m/s";
  ASSERT_EQ(run(scene, "out").code, 0);
  ASSERT_EQ(call({"report", path("out")}).code, 0);
  const std::string page = text("out/report.html");
  for (const char* part : {"Strongest motion", "In stage flight: largest velocity 4 m/s, of fast at 0.001 s",
                           "Ejected: 0 blocks", "Peak velocity v = K", "scaled distance R/sqrt(W) (m/sqrt(kg/m))"})
    EXPECT_TRUE(contains(page, part)) << part;
  EXPECT_FALSE(contains(page, "nan"));
}

TEST_F(Peaks, CostNothingWhereNobodyAsks) {
  json scene = thrown_stones();
  scene.erase("peaks");
  ASSERT_EQ(run(scene, "out").code, 0);
  EXPECT_FALSE(exists("out/peaks.csv"));
  EXPECT_TRUE(summary("out")["peaks"].is_null());
  ASSERT_EQ(call({"report", path("out")}).code, 0);
  EXPECT_FALSE(contains(text("out/report.html"), "Strongest motion"));
}

TEST_F(Peaks, GoOnInABranchThatBeginsBeforeThem) {
  ASSERT_EQ(run(thrown_stones(), "whole").code, 0);
  json wait = thrown_stones();
  wait["steps"].erase(2);
  wait["steps"].erase(1);
  wait.erase("peaks");
  ASSERT_EQ(run(wait, "wait").code, 0);
  ASSERT_EQ(run(thrown_stones(), "branch", {"--from", path("wait")}).code, 0);
  EXPECT_EQ(text("branch/peaks.csv"), text("whole/peaks.csv"));
  EXPECT_EQ(summary("branch")["peaks"], summary("whole")["peaks"]);

  json late = thrown_stones();
  late["peaks"]["stage"] = "wait";
  late["peaks"]["ejected"].erase("opening");  // which is there in that stage
  write("late.json", late.dump());
  expect_refusal({"run", path("late.json"), "--out", path("out"), "--from", path("wait")},
                 "late.json: peaks.stage is \"wait\", which is done in");
}

}  // namespace
}  // namespace dda
