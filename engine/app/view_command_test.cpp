// What dda run writes for dda view, and what that makes of it.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/app/command_line_test_support.h"
#include "engine/app/stopped_run.h"
#include "engine/view/run_results.h"

namespace dda {
namespace {

// A block hanging from a fixed one by two bolts; the thin one breaks at once.
std::string hanging_block(int steps, bool bolts) {
  return fmt::format(R"({{"dda": 1, "gravity": 10,
 "materials": {{"rock": {{"density": 2500, "young": "1 GPa", "poisson": 0}}}},
 "joints": {{"default": {{}}}},
 "blocks": [{{"polygon": {{"name": "roof", "vertices": [[0, 2], [2, 2], [2, 3], [0, 3]]}}}},
            {{"polygon": {{"name": "block", "vertices": [[0, 0.5], [2, 0.5], [2, 1.5], [0, 1.5]]}}}}],
 "supports": [{{"block": "roof"}}],{}
 "steps": {{"dt": "1 ms", "duration": {}, "integrator": "thesis"}}}})",
                     bolts ? R"(
 "bolts": [{"name": "left", "from": [0.5, 2.5], "to": [0.5, 1], "stiffness": "10 MN/m", "spacing": 2},
           {"name": "right", "from": [1.5, 2.5], "to": [1.5, 1], "stiffness": "10 MN/m", "yield_force": "1 kN",
            "rupture_elongation": "0.3 mm"}],
 "measurements": [{"quantity": "bolt_force", "bolt": "left"}],)"
                           : "",
                     steps * 1e-3);
}

TEST_F(CommandLine, FramesHoldTheBolts) {
  write("scene.json", hanging_block(40, true));
  const Outcome whole = call({"run", path("scene.json"), "--out", path("whole"), "--frame-interval", "10ms"});
  ASSERT_EQ(whole.code, 0) << whole.errors;
  EXPECT_EQ(nlohmann::json::parse(text("whole/summary.json"))["outputs"].back(), "bolts.pvd");
  const RunResults results(path("whole"));
  ASSERT_EQ(results.times().size(), 5U);
  const std::vector<DrawnBolt> last = results.frame(4).bolts;
  ASSERT_EQ(last.size(), 2U);
  EXPECT_EQ(last[0].name, "left");
  EXPECT_EQ(last[0].condition, DrawnCondition::elastic);
  EXPECT_EQ(last[1].condition, DrawnCondition::broken);
  EXPECT_EQ(last[1].force, 0);
  const std::string rows = text("whole/histories.csv");
  const std::string row = rows.substr(rows.rfind('\n', rows.size() - 2) + 1);
  EXPECT_EQ(last[0].force, std::stod(row.substr(row.find(',') + 1)));  // of one bolt, as measured
  EXPECT_GT(last[0].force, 0);

  leave_stopped_run(path("scene.json"), path("out"), 0.01, 25);
  const Outcome rest = call({"run", path("scene.json"), "--out", path("out"), "--frame-interval", "10ms", "--resume"});
  ASSERT_EQ(rest.code, 0) << rest.errors;
  EXPECT_EQ(text("out/bolts.pvd"), text("whole/bolts.pvd"));
  EXPECT_EQ(files_below("out/bolts"), files_below("whole/bolts"));
}

TEST_F(CommandLine, BoltsOfAnotherRunAreNotTaken) {
  write("scene.json", hanging_block(40, true));
  const std::vector<std::string> run = {"run", path("scene.json"), "--out", path("out"), "--frame-interval", "10ms"};
  ASSERT_EQ(call(run).code, 0);
  EXPECT_TRUE(RunResults(path("out")).has_bolts());
  write("bare.json", hanging_block(4, false));
  ASSERT_EQ(call({"run", path("bare.json"), "--out", path("out"), "--frames", "2"}).code, 0);
  EXPECT_FALSE(RunResults(path("out")).has_bolts());
  EXPECT_TRUE(RunResults(path("out")).frame(0).bolts.empty());
}

TEST_F(CommandLine, ViewMakesAPageOrAPicture) {
  write("scene.json", bar_scene(3, 100));
  ASSERT_EQ(call({"run", path("scene.json"), "--out", path("out"), "--frames", "4", "--quiet"}).code, 0);
  const Outcome page = call({"view", path("out"), "--quantity", "stress_xx"});
  EXPECT_EQ(page.code, 0) << page.errors;
  EXPECT_TRUE(contains(page.out, "out/view.html: 3 blocks, 5 frames, ")) << page.out;
  EXPECT_TRUE(text("out/view.html").starts_with("<!doctype html>"));
  EXPECT_EQ(call({"view", path("out"), "--out", path("other.html")}).code, 0);
  EXPECT_TRUE(exists("other.html"));

  const Outcome picture = call({"view", path("out"), "--svg", "last", "--out", path("bar.svg"), "--crosses", "--forces",
                                "contacts", "--deformation-scale", "1000", "--window", "-1,-1,4,2"});
  EXPECT_EQ(picture.code, 0) << picture.errors;
  EXPECT_TRUE(contains(picture.out, "bar.svg: frame 4 of 0 to 4, t = 0.001 s")) << picture.out;
  EXPECT_TRUE(contains(text("bar.svg"), "deformation \u00d7 1000"));
  const std::string last = text("bar.svg");
  EXPECT_EQ(call({"view", path("out"), "--svg", "2", "--out", path("bar.svg")}).code, 0);
  EXPECT_NE(text("bar.svg"), last);
}

TEST_F(CommandLine, ViewRefusesInOneSentence) {
  expect_refusal({"view", path("out")}, "out is missing, expected results with frames: dda run SCENE.json --out");
  write("scene.json", bar_scene(3, 10));
  ASSERT_EQ(call({"run", path("scene.json"), "--out", path("run"), "--frames", "2", "--quiet"}).code, 0);
  const std::string run = path("run");
  expect_refusal({"view", run, "--quantity", "colour"}, "--quantity is \"colour\", expected one of mean_stress, ");
  expect_refusal({"view", run, "--svg", "3", "--out", path("a.svg")}, "--svg is \"3\", expected a frame from 0 to 2");
  expect_refusal({"view", run, "--svg", "-1", "--out", path("a.svg")}, "--svg is \"-1\", expected a frame");
  expect_refusal({"view", run, "--svg", "1"}, "--out is missing");
  expect_refusal({"view", run, "--svg", "1", "--out", path("no/a.svg")}, "a name in a folder that exists");
  expect_refusal({"view", run, "--out", path("no/a.html")}, "a name in a folder that exists");
  expect_refusal({"report", run, "--out", path("no/a.html")}, "a name in a folder that exists");
  expect_refusal({"view", run, "--svg", "1", "--out", path("a.svg"), "--forces", "all"}, "joints, contacts or none");
  expect_refusal({"view", run, "--svg", "1", "--out", path("a.svg"), "--window", "1,1,0,2"}, "LEFT,BOTTOM,RIGHT,TOP");
  expect_refusal({"view", run, "--crosses"}, "--svg");
  for (const char* size : {"0", "1e-9", "1e30", "nan", "inf", "-5"})
    expect_refusal({"view", run, "--max-size", size},
                   "--max-size: is \"" + std::string(size) + "\", expected a number");
  const auto refuse_picture = [&](const std::string& option, std::string_view part) {
    expect_refusal({"view", run, "--svg", "last", "--out", path("a.svg"), option}, part);
  };
  for (const char* scale : {"nan", "inf", "-1", "1e300"})
    refuse_picture("--deformation-scale=" + std::string(scale), "--deformation-scale: is");
  for (const char* window : {"0,0,1e-300,1e-300", "0,0,1e300,1", "0,0,nan,1", "0,0,inf,1", "0,0,1,1e-5", "0,0,1"})
    refuse_picture("--window=" + std::string(window), "LEFT,BOTTOM,RIGHT,TOP in m, ");
  refuse_picture("--out=", "--out");
  for (const char* file : {"a.png", "a.html", "a.svg.gz"})
    expect_refusal({"view", run, "--svg", "last", "--out", path(file)}, "expected a name that ends in .svg");
  expect_refusal({"view", run, "--out", path("a.svg")}, "expected a name that ends in .html or .htm");
  expect_refusal({"view", run, "--out", "/dev/null"}, "--out is /dev/null, which is a device");
  std::filesystem::create_symlink(path("elsewhere.html"), path("link.html"));
  expect_refusal({"view", run, "--out", path("link.html")}, "link.html, which is a symbolic link");
  expect_refusal({"view", run + "/histories.csv"}, "which is a table of measurements, expected a folder with results");
  expect_refusal({"view", run, "--unit", "mm"}, "--unit is given beside a run");
  expect_refusal({"view", run, "--window", "0,0,1,1"}, "--window is given without --svg");
  write("run/frames/000001.vtp", "no frame");
  expect_refusal({"view", run}, "frames/000001.vtp: the file is ");
  EXPECT_FALSE(exists("run/view.html"));
  EXPECT_FALSE(exists("a.svg"));
}

// Rock with an opening that a stage takes out, held and loaded.
constexpr auto rock_scene = R"({"dda": 1, "gravity": 9.81,
 "materials": {"rock": {"density": 2600, "young": "20 GPa", "poisson": 0.25}},
 "joints": {"default": {"friction_angle": "35 deg"}, "bedding": {"friction_angle": "25 deg"}},
 "blocks": {"rock": {"boundary": [[0, 0], [6, 0], [6, 6], [0, 6]],
   "joint_sets": [{"dip": 0, "spacing": 1, "joint": "bedding"}, {"dip": "90 deg", "spacing": 2, "joint": "default"}],
   "openings": [{"name": "drift", "rectangle": {"width": 2, "height": 2, "foot": [3, 2]}}]}},
 "loads": [{"edge": "top", "traction": [0, "-1 MPa"]}],
 "supports": [{"edge": "bottom"}],
 "steps": [{"name": "settle", "integrator": "static", "dt": "1 s", "duration": "1 s"},
           {"name": "open", "remove": ["drift"], "dt": "1 ms", "duration": "1 ms"}]})";

std::size_t count_of(const std::string& text, std::string_view part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST_F(CommandLine, ViewCutsAndDrawsAScene) {
  write("rock.json", rock_scene);
  const Outcome view = call({"view", path("rock.json")});
  ASSERT_EQ(view.code, 0) << view.errors;
  EXPECT_TRUE(contains(view.out, "rock.view.svg: ")) << view.out;
  const std::string picture = text("rock.view.svg");
  for (const char* part :
       {"joint bedding", "joint default", ">drift<", "taken out by a stage", ">support<", ">load<", ">rock<"})
    EXPECT_TRUE(contains(picture, part)) << part;
  EXPECT_FALSE(contains(picture, ">bolt<"));
  EXPECT_EQ(files_below("").size(), 2U);  // the scene and its picture, and no folder of results
  const Outcome part = call({"view", path("rock.json"), "--out", path("part.svg"), "--window", "2,2,4,4"});
  ASSERT_EQ(part.code, 0) << part.errors;
  EXPECT_EQ(count_of(text("part.svg"), "clipPath"), 2U);
  EXPECT_FALSE(contains(picture, "clipPath"));
}

TEST_F(CommandLine, ViewDrawsPlainBlocksAndDrawings) {
  write("bar.json", hanging_block(4, true));
  ASSERT_EQ(call({"view", path("bar.json"), "--out", path("bar.svg")}).code, 0);
  EXPECT_TRUE(contains(text("bar.svg"), ">rock<"));
  EXPECT_TRUE(contains(text("bar.svg"), ">bolt<"));
  EXPECT_FALSE(contains(text("bar.svg"), ">load<"));
  const std::string plan =
      "layer,x1,y1,x2,y2\nboundary,0,0,4,0\nboundary,4,0,4,4\nboundary,4,4,0,4\n"
      "boundary,0,4,0,0\nbeds,0,1,4,2\n";
  write("plan.csv", plan);
  expect_refusal({"view", path("plan.csv")}, "plan.csv line 6 is on the unknown layer \"beds\"");
  const Outcome drawn = call({"view", path("plan.csv"), "--layer", "beds=rock"});
  ASSERT_EQ(drawn.code, 0) << drawn.errors;
  EXPECT_TRUE(contains(drawn.out, "plan.view.svg: 2 blocks")) << drawn.out;
  EXPECT_TRUE(contains(drawn.out, "remark: ")) << drawn.out;
}

// A scene that dda check refuses is refused in the same words.
TEST_F(CommandLine, ViewRefusesOfASceneWhatCheckRefuses) {
  write("rock.json", rock_scene);
  const auto refuse = [&](const std::string& option, const std::string& value) {
    std::vector<std::string> arguments{"view", path("rock.json"), option};
    if (!value.empty()) arguments.push_back(value);
    expect_refusal(arguments, option + " is given for a scene, which is drawn before anything moves, expected");
  };
  for (const char* option : {"--quantity", "--svg", "--forces"}) refuse(option, "last");
  for (const char* option : {"--max-size", "--deformation-scale"}) refuse(option, "2");
  refuse("--crosses", "");
  expect_refusal({"view", path("rock.json"), "--unit", "mm"}, "--unit is given beside a scene");
  expect_refusal({"view", path("rock.json"), "--out", path("a.html")}, "expected a name that ends in .svg");
  std::string bad = rock_scene;
  bad.replace(bad.find("\"25 deg\""), 8, "\"95 deg\"");
  write("bad.json", bad);
  write("unset.json", std::string(bar_scene(3, 10)).replace(bar_scene(3, 10).find("[2, 0.5]"), 8, "[2.2, 0.5]"));
  for (const char* scene : {"bad.json", "unset.json", "missing.json"}) {
    const Outcome check = call({"check", path(scene)});
    EXPECT_EQ(check.code, 2);
    expect_refusal({"view", path(scene)}, check.errors);
  }
  EXPECT_FALSE(exists("rock.view.svg"));
}

}  // namespace
}  // namespace dda
