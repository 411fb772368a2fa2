#include "engine/app/advise_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "engine/app/app_test_support.h"
#include "engine/app/command_line.h"
#include "engine/core/read_file.h"

namespace dda {
namespace {

struct Outcome {
  int code;
  std::string out, errors;
};

Outcome call(const std::vector<std::string>& arguments) {
  std::vector<const char*> argv = {"dda"};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  std::ostringstream out, errors;
  const int code = run_command_line(static_cast<int>(argv.size()), argv.data(), out, errors);
  return {code, out.str(), errors.str()};
}

class AdviseCommand : public FolderTest {
 protected:
  [[nodiscard]] nlohmann::json json(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"advise", path("scene.json"), "--json"});
    const Outcome outcome = call(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    return nlohmann::json::parse(outcome.out);
  }
  void expect_refusal(const std::vector<std::string>& more, const std::string& sentence) const {
    std::vector<std::string> arguments = {"advise", path("scene.json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = call(arguments);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1);
    EXPECT_NE(outcome.errors.find(sentence), std::string::npos) << outcome.errors;
  }
};

std::string without_load(std::string scene) {
  const auto from = scene.find("\"loads\"");
  return scene.erase(from, scene.find("\"measurements\"") - from);
}

TEST_F(AdviseCommand, ALoadHistoryIsTakenFromTheScene) {
  write("scene.json", bar_scene(40, 3000));
  const auto advice = json({"--distance", "20m"});
  EXPECT_EQ(advice["frequency_hz"], 100);
  const auto& stage = advice["stages"][0];
  EXPECT_EQ(stage["steps"], 3000);
  EXPECT_EQ(stage["factorizations"], 1);
  EXPECT_EQ(stage["solver"], "cholesky");
  const auto& wave = stage["waves"][0];
  EXPECT_EQ(wave["kind"], "bar");
  EXPECT_NEAR(wave["speed_m_per_s"], 4343.72, 0.01);
  EXPECT_EQ(wave["history"]["place_m"], 20);
  EXPECT_TRUE(wave["history"]["with_end"]);
  for (const char* of : {"speed", "amplitude"}) {
    const auto& terms = wave["history"][of];
    EXPECT_NEAR(terms["total"].get<double>(),
                terms["blocks"].get<double>() + terms["interfaces"].get<double>() + terms["time"].get<double>(), 1e-15);
    EXPECT_LT(std::abs(terms["total"].get<double>()), 1e-3);
  }
}

// The place is how far a wave has gone square to the face that is loaded, or that of a block that is moved, wherever on
// the face the first of its pieces is.
TEST_F(AdviseCommand, ThePlaceIsSquareToTheFace) {
  const auto place_of = [&](const std::string& drive, const std::string& point) {
    write("scene.json", R"({"dda": 1, "materials": {"r": {"density": 2500, "young": 25e9, "poisson": 0.2}},
      "joints": {"default": {"bonded": true}},
      "blocks": {"grid": {"name": "g", "columns": 30, "rows": 4, "block_width": 1, "block_height": 1}},)" +
                            drive + R"("measurements": [{"quantity": "traction_normal", "point": )" + point + R"(}],
      "steps": {"dt": 5e-5, "duration": 0.02, "kinematics": "small"}})");
    return json({})["stages"][0]["waves"][0]["history"]["place_m"].get<double>();
  };
  const std::string history = R"("history": {"sine": {"frequency": 200, "cycles": 2}})";
  const std::string sides = R"({"edge": "top", "hold": "normal"}, {"edge": "bottom", "hold": "normal"})";
  const std::string loaded = R"("loads": [{"edge": "left", "pressure": 1, )" + history + "}], ";
  EXPECT_NEAR(place_of(loaded + R"("supports": [)" + sides + "],", "[5, 3.4]"), 5, 1e-9);
  EXPECT_NEAR(place_of(loaded + R"("supports": [)" + sides + "],", "[9, 0.4]"), 9, 1e-9);
  std::string moved;
  for (const char* block : {"g 1.1", "g 2.1", "g 3.1", "g 4.1"})
    moved += fmt::format(R"({{"block": "{}", "velocity": [1e-3, 0], {}}}, )", block, history);
  EXPECT_NEAR(place_of(R"("supports": [)" + moved + sides + "],", "[6, 1.4]"), 5, 1e-9) << "from the face at 1 m";
}

// What keeps the wanted error does when it is asked about again, and half as much again does not.
TEST_F(AdviseCommand, LimitsHold) {
  const std::string scene = bar_scene(40, 3000);
  write("scene.json", scene);
  const double dt = json({"--distance", "20m", "--error", "0.5%"})["stages"][0]["waves"][0]["limits"]["dt_s"];
  const auto errors_at = [&](double step) {
    std::string changed = scene;
    changed.replace(changed.find("\"dt\": 1e-5"), 10, fmt::format("\"dt\": {:.9g}", step));
    const auto duration = changed.find("\"duration\": ");
    changed.replace(duration, changed.find(',', duration) - duration,
                    fmt::format("\"duration\": {:.12g}", std::ceil(0.03 / step) * step));
    write("scene.json", changed);
    const auto history = json({"--distance", "20m"})["stages"][0]["waves"][0]["history"];
    return std::max(std::abs(history["speed"]["total"].get<double>()),
                    std::abs(history["amplitude"]["total"].get<double>()));
  };
  EXPECT_LE(errors_at(dt), 0.005 * 1.0001);  // dt in nine digits
  EXPECT_GT(errors_at(1.5 * dt), 0.005);
}

TEST_F(AdviseCommand, FrequencyOfASteadyWave) {
  write("scene.json", without_load(bar_scene(40, 3000)));
  const auto advice = json({"--frequency", "200Hz"});
  EXPECT_EQ(advice["frequency_hz"], 200);
  EXPECT_TRUE(advice["load"].is_null());
  const auto& wave = advice["stages"][0]["waves"][0];
  EXPECT_TRUE(wave["history"].is_null());
  EXPECT_NEAR(wave["distance_m"], 43.4372 / 2, 1e-3);  // a wavelength
  EXPECT_FALSE(wave["steady"].is_null());
}

TEST_F(AdviseCommand, TargetFrequencyIsTheDefault) {
  std::string scene = without_load(bar_scene(40, 3000));
  scene.insert(1, "\"target_frequency\": \"0.15 kHz\", ");
  write("scene.json", scene);
  EXPECT_EQ(json({})["frequency_hz"], 150);
  const Outcome check = call({"check", path("scene.json")});
  EXPECT_NE(check.out.find("predicted for waves of 150 Hz"), std::string::npos) << check.out;
}

TEST_F(AdviseCommand, TextNamesTheCause) {
  std::string scene = bar_scene(40, 3000);
  scene.insert(1, "\"scheme\": \"thesis\", ");
  write("scene.json", scene);
  const Outcome outcome = call({"advise", path("scene.json"), "--distance", "20 m"});
  EXPECT_EQ(outcome.code, 0);
  for (const char* part : {"40 blocks, 39 interfaces", "sine of 100 Hz", "1 factorization;", "of CPU time",
                           "bar wave in \"rock\", along the row", "everywhere", "a steady wave of 100 Hz, after 20 m",
                           "the load's history, stress at the joint after 20 m", "mostly by: interfaces", "for 1 %"})
    EXPECT_NE(outcome.out.find(part), std::string::npos) << part << "\n" << outcome.out;
}

TEST_F(AdviseCommand, CheckHasAShortForm) {
  write("scene.json", bar_scene(40, 3000));
  const Outcome outcome = call({"check", path("scene.json")});
  EXPECT_NE(outcome.out.find("predicted for the whole history of the load"), std::string::npos);
  EXPECT_NE(outcome.out.find("mostly by block size"), std::string::npos) << outcome.out;
  EXPECT_EQ(call({"check", path("scene.json"), "--frequency", "50Hz"}).out.find("whole history"), std::string::npos);
}

TEST_F(AdviseCommand, TheShortFormNamesStagesWhereThereAreSeveral) {
  std::string scene = bar_scene(40, 3000);
  const auto steps = scene.find("\"steps\"");
  scene.replace(steps, scene.find('}', steps) - steps + 1,
                R"("steps": [{"name": "one", "dt": 1e-5, "duration": 0.02, "kinematics": "small"},
                {"name": "two", "dt": 1e-4, "duration": 0.01, "kinematics": "small"}])");
  write("scene.json", scene);
  const Outcome outcome = call({"check", path("scene.json")});
  for (const char* stage : {"one", "two"})
    EXPECT_NE(outcome.out.find(fmt::format("history of the load, stage \"{}\"\n  bar wave", stage)), std::string::npos)
        << outcome.out << outcome.errors;
}

TEST_F(AdviseCommand, CheckAsksForAFrequencyWhereItHasNone) {
  const std::string asked = "no load with a history in the scene: give --frequency";
  write("scene.json", without_load(bar_scene(40, 3000)));
  EXPECT_NE(call({"check", path("scene.json")}).out.find(asked), std::string::npos);
  std::string decay = bar_scene(40, 3000);
  const auto sine = decay.find("{\"sine\"");
  decay.replace(sine, decay.find("}}", sine) - sine + 2, R"({"decay": {"decay_time": "1 ms", "rise": "1 ms"}})");
  write("scene.json", decay);
  const Outcome outcome = call({"check", path("scene.json")});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_EQ(outcome.out.find(asked), std::string::npos);
  EXPECT_NE(outcome.out.find("predicted for the whole history"), std::string::npos) << outcome.out;
}

TEST_F(AdviseCommand, CostsAreKnownWithoutAWave) {
  write("scene.json", without_load(bar_scene(40, 3000)));
  const auto advice = json({});
  EXPECT_TRUE(advice["frequency_hz"].is_null());
  EXPECT_EQ(advice["stages"][0]["steps"], 3000);
  EXPECT_TRUE(advice["stages"][0]["waves"].empty());
  EXPECT_NE(call({"advise", path("scene.json")}).out.find("nothing is said of waves: give --frequency"),
            std::string::npos);
}

// The fenced block of the page that begins with these words.
std::string quoted(const std::string& page, const std::string& beginning) {
  const auto from = page.find("```\n" + beginning);
  if (from == std::string::npos) return "";
  return page.substr(from + 4, page.find("```", from + 4) - from - 4);
}

TEST_F(AdviseCommand, TheDocumentationQuotesWhatIsSaid) {
  const std::string examples = DDA_EXAMPLES;
  const std::string page = read_file(std::filesystem::path(DDA_EXAMPLES).parent_path() / "running.md");
  const std::string scene = examples + "/p_bar_2m_thesis.json";
  const std::string advised = quoted(page, "bar wave in");
  const std::string checked = quoted(page, "predicted for waves of");
  ASSERT_GT(advised.size(), 100U);
  ASSERT_GT(checked.size(), 100U);
  const std::string advice = call({"advise", scene}).out;
  EXPECT_NE(advice.find(advised), std::string::npos) << advice;
  const std::string check = call({"check", scene}).out;
  EXPECT_NE(check.find(checked), std::string::npos) << check;
}

TEST_F(AdviseCommand, LooseBlocksHaveARangeOfCosts) {
  const Outcome outcome = call({"advise", std::string(DDA_EXAMPLES) + "/dry_wall.json"});
  EXPECT_NE(outcome.out.find("while contacts rest; "), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("as if all joints"), std::string::npos) << "nothing is said of waves";
}

TEST_F(AdviseCommand, AnErrorOutOfBoundsIsRefusedWithThem) {
  write("scene.json", without_load(bar_scene(40, 3000)));
  for (const std::string wanted :
       {"0", "0%", "-1", "-1e-3", "1e-30", "9e-10", "nan", "inf", "-inf", "1", "1e9", "100%", "100 %", "1e300", "150%"})
    expect_refusal({"--frequency", "100", "--error=" + wanted}, "with %, from 1e-09 to 0.99");
  for (const std::string wanted : {"1e-400", "1e400", "one", "1 percent", "1%%", "1%5", "%", "1 m", "0,01", "nan%"})
    expect_refusal({"--frequency", "100", "--error=" + wanted},
                   "--error is \"" + wanted + "\", expected a finite number");
}

// Whatever the bound, what keeps it is foretold to keep it; where nothing does, it says how fine was tried.
TEST_F(AdviseCommand, ErrorsWithinBoundsAreAnsweredHonestly) {
  const std::string scene = without_load(bar_scene(40, 3000));
  for (const std::string wanted : {"0.99", "99%", "10 %", "1 %", "1e-3", "1e-5", "1e-7", "1e-9"}) {
    SCOPED_TRACE(wanted);
    write("scene.json", scene);
    const auto advice = json({"--frequency", "100", "--error", wanted});
    const double error = advice["wanted_error"];
    const auto limits = advice["stages"][0]["waves"][0]["limits"];
    const Outcome said = call({"advise", path("scene.json"), "--frequency", "100", "--error", wanted});
    if (limits["dt_s"].is_null()) {
      EXPECT_NE(said.out.find(fmt::format("dt down to {:.3g} s", limits["finest_dt_tried_s"].get<double>())),
                std::string::npos)
          << said.out;
      continue;
    }
    const bool coarsest = limits["dt_s"] == limits["coarsest_dt_tried_s"];
    EXPECT_EQ(said.out.find(" s, the coarsest tried, with these blocks") != std::string::npos, coarsest) << said.out;
    std::string changed = scene;
    changed.replace(changed.find("\"dt\": 1e-5"), 10, fmt::format("\"dt\": {}", limits["dt_s"].get<double>()));
    const auto duration = changed.find("\"duration\": ");
    changed.replace(duration, changed.find(',', duration) - duration,
                    fmt::format("\"duration\": {}", 1000 * limits["dt_s"].get<double>()));
    write("scene.json", changed);
    const auto steady = json({"--frequency", "100"})["stages"][0]["waves"][0]["steady"];
    for (const char* of : {"speed", "amplitude"}) EXPECT_LE(std::abs(steady[of]["total"].get<double>()), error) << of;
  }
}

TEST_F(AdviseCommand, MistakesGetOneSentence) {
  write("scene.json", without_load(bar_scene(40, 3000)));
  expect_refusal({"--frequency", "5 m"}, "--frequency is \"5 m\", expected");
  expect_refusal({"--frequency", "100", "--distance", "-3"}, "--distance is -3, expected");
  write("scene.json", "{");
  expect_refusal({"--frequency", "100"}, "scene.json");
}

}  // namespace
}  // namespace dda
