// dda cut: what it writes, and what it refuses.
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/app/command_line_test_support.h"
#include "engine/record/folder_lock.h"

namespace dda {
namespace {

const std::string plan =
    "layer,x1,y1,x2,y2,x,y\nboundary,0,0,4,0,,\nboundary,4,0,4,4,,\nboundary,4,4,0,4,,\nboundary,0,4,0,0,,\n"
    "rock,0,1,4,2,,\nrock,2,2,2,3,,\nmeasure point,,,,,2,3\n";

class Cut : public CommandLine {
 protected:
  Cut() { write("plan.csv", plan); }

  // Cuts the plan, and returns its blocks as the text of a DXF file.
  std::string text_of_blocks() {
    const Outcome cut = call({"cut", path("plan.csv"), "--out", path("first"), "--export", path("first.dxf")});
    EXPECT_EQ(cut.code, 0) << cut.errors;
    return text("first.dxf");
  }
};

TEST_F(Cut, ADrawingBecomesASceneThatRunsAndADrawingOfItsBlocks) {
  const Outcome cut = call({"cut", path("plan.csv"), "--out", path("out"), "--export", path("blocks.dxf")});
  ASSERT_EQ(cut.code, 0) << cut.errors;
  EXPECT_TRUE(contains(cut.out, "2 blocks of 16 m2 in all, from 2 lines")) << cut.out;
  EXPECT_TRUE(contains(cut.out, "plan.csv does not say its unit: coordinates are taken in m")) << cut.out;
  const auto report = nlohmann::json::parse(text("out/cut.json"));
  EXPECT_EQ(report["blocks"], 2);
  EXPECT_EQ(report["points"][0]["layer"], "measure point");
  EXPECT_EQ(report["points"][0]["drawn"], path("plan.csv") + " line 8 (layer measure point)");
  EXPECT_EQ(report["cleaned"][0]["line"], path("plan.csv") + " line 7 (layer rock)");
  EXPECT_TRUE(contains(text("out/cut.svg"), "<svg "));
  EXPECT_TRUE(contains(text("out/statistics.svg"), "rock: 2 blocks, mean area 8 m2, P20 "))
      << text("out/statistics.svg");
  EXPECT_FALSE(exists("out/run.lock"));

  const Outcome check = call({"check", path("out/scene.json")});
  EXPECT_EQ(check.code, 0) << check.errors;
  write("again.json", R"({"dda": 1, "materials": {"rock": {"density": 2600, "young": 2e10, "poisson": 0.25}},
 "blocks": {"rock": {"drawing": {"file": "blocks.dxf", "layers": {"block_rock": "rock", "joint_default": "ignored"}},
                     "boundary": [[0, 0], [4, 0], [4, 4], [0, 4]]}}, "steps": {"dt": 1e-3, "duration": 1e-3}})");
  const Outcome again = call({"cut", path("again.json"), "--out", path("again"), "--export", path("again.geojson")});
  ASSERT_EQ(again.code, 0) << again.errors;
  EXPECT_EQ(nlohmann::json::parse(text("again/cut.json"))["blocks"], 2);
  EXPECT_EQ(nlohmann::json::parse(text("again.geojson"))["features"].size(), 3U);
}

// Parts of the files are written without the JSON library, by as many threads as there are; all is as it would write
// it.
TEST_F(Cut, FilesAreThoseOfTheJsonLibraryWithAnyNumberOfThreads) {
  std::string lines;
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 40; ++j)
      lines += (lines.empty() ? "" : ",") + std::string(R"({"joint": "default", "points": [[)") +
               std::to_string(i + 0.013 * j) + "," + std::to_string(j) + "],[" + std::to_string(i + 2.4) + "," +
               std::to_string(j + (i % 2 == 0 ? 1.7 : -1.7)) + "]]}";
  write("lines.json", R"({"dda": 1, "materials": {"a": {"density": 2600, "young": 2e10, "poisson": 0.25},
      "rock \"b\"": {"density": 2600, "young": 2e10, "poisson": 0.25}}, "steps": {"dt": 1e-3, "duration": 1e-3},
      "blocks": {"rock": {"name": "r\u00f6ck", "material": "a", "initial_velocity": [0, 1], "boundary": [[0, 0], [40, 0],
      [40, 40], [0, 40]], "regions": [{"outline": [[-1, -1], [41, -1], [41, 20.1], [-1, 20.1]], "material":
      "rock \"b\""}], "lines": [)" +
                          lines + R"(,{"joint": "default", "points": [[0, 5], [9, 5]]},
      {"joint": "default", "points": [[3, 2], [8, 2], [8, 8], [3, 8], [3, 2]]}]}}})");
  std::vector<std::string> scenes, reports;
  for (const char* threads : {"1", "2", "4"}) {
    const Outcome cut = call({"cut", path("lines.json"), "--out", path("out"), "--threads", threads});
    ASSERT_EQ(cut.code, 0) << cut.errors;
    auto report = nlohmann::json::parse(text("out/cut.json"));
    EXPECT_EQ(report.dump(1) + "\n", text("out/cut.json"));
    report.erase("seconds");
    reports.push_back(report.dump());
    scenes.push_back(text("out/scene.json"));
    EXPECT_EQ(reports.back(), reports.front()) << threads;
    EXPECT_EQ(scenes.back(), scenes.front()) << threads;
  }
  const auto scene = nlohmann::json::parse(scenes.front());
  EXPECT_GT(scene["blocks"].size(), 100U);
  for (const auto& block : scene["blocks"]) EXPECT_TRUE(contains(scenes.front(), "\n    " + block.dump())) << block;
}

TEST_F(Cut, NothingIsWrittenOfWhatIsWrong) {
  write("open.csv", plan.substr(0, plan.find("boundary,0,4")));
  write("none.csv", "layer,x1,y1,x2,y2\nrock,0,0,1,1\ntunnel,0,0,1,0\ntunnel,1,0,1,1\ntunnel,1,1,0,0\n");
  write("layer.csv", plan + "Text,0,0,1,1,,\n");
  write("point.csv", plan + "measure point,,,,,5,5\n");
  write("scene.json", R"({"dda": 1, "materials": {"rock": {"density": 2600, "young": 2e10, "poisson": 0.25}},
 "blocks": {"rock": {"drawing": "open.csv"}}, "steps": {"dt": 1e-3, "duration": 1e-3}})");
  const auto refused = [this](const std::string& file, const std::string& sentence) {
    expect_refusal({"cut", path(file), "--out", path("out")}, sentence);
  };
  refused("open.csv", "open.csv line 4 (layer boundary) is open at (0, 4) m, 4 m from the nearest other end, of");
  refused("layer.csv", "layer.csv line 9 is on the unknown layer \"Text\", expected one of boundary, ");
  refused("layer.csv",
          R"(, or a word on what it is: --layer "Text=rock" for joints, --layer "Text=ignored" to leave it )"
          R"(out, in a scene "layers": {"Text": "rock"})");
  refused("none.csv",
          path("none.csv") + R"( is without a line on a layer boundary; its layers are "rock", )" +
              R"("tunnel", expected lines around the rock that close, on a layer boundary or on one that )" +
              R"(is said to be it: --layer "NAME=boundary")");
  refused("point.csv",
          "point.csv line 9 (layer measure point) is at (5, 5) m, in no block, expected a place in the rock");
  refused("scene.json", "scene.json: open.csv line 4 (layer boundary) is open at (0, 4) m");
  refused("none.dxf", "none.dxf is missing, expected a drawing");
  expect_refusal({"cut", path("plan.csv"), "--out", path("plan.csv")},
                 "--out is " + path("plan.csv") + ", which is a file");
  expect_refusal({"cut", path("plan.csv"), "--out", path("out"), "--export", path("blocks.pdf")},
                 "blocks.pdf, expected a name that ends in .dxf, .geojson or .dc");
  expect_refusal({"cut", path("plan.csv"), "--out", path("out"), "--export", path("missing/blocks.dxf")},
                 "missing/blocks.dxf, expected a name in a folder that exists");
}

TEST_F(Cut, WhatIsReadIsNotWrittenOver) {
  write("plan.dxf", text_of_blocks());
  const std::string before = text("plan.dxf");
  expect_refusal({"cut", path("plan.dxf"), "--out", path("out"), "--export", path("plan.dxf")},
                 "plan.dxf, which is the drawing to cut, expected another name");
  EXPECT_EQ(text("plan.dxf"), before);
  ASSERT_EQ(call({"cut", path("plan.dxf"), "--out", path("made")}).code, 0);
  expect_refusal({"cut", path("made/scene.json"), "--out", path("made")},
                 "made, whose scene.json is the scene to cut, expected another folder");
}

// A scene says what a drawing of blocks cannot; what would cut them is refused.
TEST_F(Cut, WordsOfASceneBesideADrawingOfBlocks) {
  write("blocks.dxf", text_of_blocks());
  const auto scene = [this](const std::string& rock, const std::string& joints) {
    write("again.json",
          R"({"dda": 1, "materials": {"rock": {"density": 2600, "young": 2e10, "poisson": 0.25}}, "joints": {)" +
              joints + R"(}, "blocks": {"rock": {"drawing": "blocks.dxf")" + rock +
              R"(}}, "steps": {"dt": 1e-3, "duration": 1e-3}})");
    return std::vector<std::string>{"cut", path("again.json"), "--out", path("out")};
  };
  expect_refusal(scene(R"(, "merge": {"area": 1})", ""),
                 "blocks.rock.merge is given beside a drawing of blocks, which are not cut again, expected regions");
  const Outcome unused = call(scene("", R"("bedding": {"friction_angle": "30 deg"})"));
  EXPECT_EQ(unused.code, 0) << unused.errors;
  EXPECT_TRUE(contains(unused.out,
                       "remark: joints.bedding is in no entry of joint_pairs, joint_lines or rock, and no "
                       "line of the drawing is on a layer \"joint bedding\""))
      << unused.out;
  EXPECT_EQ(call(scene("", R"("default": {"friction_angle": "30 deg"})")).code, 0);
}

TEST_F(Cut, NamesOfADrawingMustBeThoseOfItsScene) {
  std::string bedding = plan;
  bedding.replace(bedding.find("rock,0,1"), 4, "joint bedding");
  write("bedding.csv", bedding);
  const auto scene = [this](const std::string& joints) {
    write("named.json",
          R"({"dda": 1, "materials": {"rock": {"density": 2600, "young": 2e10, "poisson": 0.25}}, "joints": {)" +
              joints +
              R"(}, "blocks": {"rock": {"drawing": "bedding.csv"}}, "steps": {"dt": 1e-3, "duration": 1e-3}})");
    return std::vector<std::string>{"cut", path("named.json"), "--out", path("out")};
  };
  expect_refusal(scene(""),
                 "bedding.csv line 6 (layer joint bedding) is of the joint \"bedding\", expected one of the scene's");
  const Outcome cut = call(scene(R"("bedding": {"friction_angle": "30 deg"})"));
  ASSERT_EQ(cut.code, 0) << cut.errors;
  EXPECT_EQ(nlohmann::json::parse(text("out/scene.json"))["joint_lines"][0]["joint"], "bedding");
}

// DXF does not tell layers apart by capitals, nor do people who fill tables.
TEST_F(Cut, LayersThatDifferInCapitalsOnlyAreOne) {
  write("two.csv", plan + "joint Bedding,0,1.5,4,2.5\njoint BEDDING,0,0.5,4,1.5\nTUNNEL,1,3,2,3\ntunnel,2,3,2,3.5\n" +
                       "Tunnel,2,3.5,1,3\n");
  const Outcome cut = call({"cut", path("two.csv"), "--out", path("out")});
  ASSERT_EQ(cut.code, 0) << cut.errors;
  EXPECT_TRUE(contains(cut.out, "two.csv: the layers \"joint Bedding\" and \"joint BEDDING\" are one")) << cut.out;
  const auto scene = nlohmann::json::parse(text("out/scene.json"));
  EXPECT_EQ(scene["joints"].size(), 2U) << scene["joints"];
  EXPECT_TRUE(scene["joints"].contains("Bedding"));
  write("named.json",
        R"({"dda": 1, "materials": {"rock": {"density": 2600, "young": 2e10, "poisson": 0.25}},
 "joints": {"bedding": {"friction_angle": "30 deg"}}, "blocks": {"rock": {"drawing": "two.csv"}},
 "steps": {"dt": 1e-3, "duration": 1e-3}})");
  const Outcome named = call({"cut", path("named.json"), "--out", path("named")});
  ASSERT_EQ(named.code, 0) << named.errors;
  const auto written = nlohmann::json::parse(text("named/scene.json"));
  ASSERT_GT(written["joint_lines"].size(), 0U);
  for (const auto& line : written["joint_lines"]) EXPECT_EQ(line["joint"], "bedding");
}

TEST_F(Cut, LayersAndUnitAreGivenOnTheCommandLine) {
  std::string other = plan;
  for (std::size_t at = other.find("rock"); at != std::string::npos; at = other.find("rock", at))
    other.replace(at, 4, "Bed");
  write("other.csv", other);
  expect_refusal({"cut", path("other.csv"), "--out", path("out")}, "is on the unknown layer \"Bed\"");
  expect_refusal({"cut", path("other.csv"), "--out", path("out"), "--layer", "bed=rok"},
                 "--layer bed is \"rok\", expected one of");
  expect_refusal({"cut", path("other.csv"), "--out", path("out"), "--layer", "bed joints=rok"},
                 "--layer bed joints is \"rok\", expected one of");
  expect_refusal({"cut", path("plan.csv"), "--out", path("out"), "--unit", "kg"}, "--unit is \"kg\", expected one of");
  expect_refusal({"cut", path("other.csv"), "--out", path("out"), "--layer", "bed"},
                 "--layer is \"bed\", expected NAME=");
  expect_refusal({"cut", path("scene.json"), "--out", path("out"), "--unit", "mm"}, "--unit is given beside a scene");
  const Outcome cut = call({"cut", path("other.csv"), "--out", path("out"), "--layer", "bed=rock", "--unit", "km"});
  ASSERT_EQ(cut.code, 0) << cut.errors;
  EXPECT_EQ(nlohmann::json::parse(text("out/cut.json"))["area"], 16e6);
  ASSERT_EQ(call({"cut", path("other.csv"), "--out", path("feet"), "--layer", "bed=rock", "--unit", "ft"}).code, 0);
  EXPECT_NEAR(nlohmann::json::parse(text("feet/cut.json"))["area"], 16 * 0.3048 * 0.3048,
              1e-12);  // exact by definition
}

// Which of the two is right the drawing cannot tell, so that what it says is not overruled without a word.
TEST_F(Cut, AUnitThatIsNotTheDrawingsIsTold) {
  write("blocks.dxf", text_of_blocks());
  const auto outcome = [&](const std::string& unit) {
    const Outcome cut = call({"cut", path("blocks.dxf"), "--out", path("out"), "--unit", unit});
    EXPECT_EQ(cut.code, 0) << cut.errors;
    return cut.out;
  };
  EXPECT_TRUE(contains(outcome("mm"), "says that its coordinates are in m; they are taken in units of 0.001 m"))
      << outcome("mm");
  EXPECT_FALSE(contains(outcome("m"), "its coordinates")) << outcome("m");
}

// Left out, but not without a word: lines on the layer of dimensions, which is ignored as long as nobody names it.
TEST_F(Cut, LinesAmongThePointsOfDimensionsAreTold) {
  write("other.csv", plan + "Defpoints,0,1,4,1\n");
  const auto remarks = [&] { return nlohmann::json::parse(text("out/cut.json"))["remarks"].dump(); };
  ASSERT_EQ(call({"cut", path("other.csv"), "--out", path("out")}).code, 0);
  EXPECT_TRUE(contains(remarks(), "1 lines on Defpoints")) << remarks();
  ASSERT_EQ(call({"cut", path("other.csv"), "--out", path("out"), "--layer", "Defpoints=ignored"}).code, 0);
  EXPECT_FALSE(contains(remarks(), "Defpoints")) << remarks();
}

// Drawn twice, the other way round, over parts and over the corner of two: each place absorbs once.
TEST_F(Cut, LinesThatAbsorbCountOnceWhereTheyAreDrawnTwice) {
  write("absorbing.csv", plan + "absorbing boundary,0,1,0,3\nabsorbing boundary,0,4,0,0\nabsorbing boundary,0,0,0,4\n" +
                             "absorbing boundary,0,4,4,4\nabsorbing boundary,1,4,2,4\n");
  const Outcome cut = call({"cut", path("absorbing.csv"), "--out", path("out")});
  ASSERT_EQ(cut.code, 0) << cut.errors;
  double length = 0;
  const nlohmann::json scene = nlohmann::json::parse(text("out/scene.json"));
  for (const nlohmann::json& boundary : scene["viscous_boundaries"]) {
    const std::vector<double> from = boundary["edge"]["from"], to = boundary["edge"]["to"];
    length += std::hypot(to[0] - from[0], to[1] - from[1]);
  }
  EXPECT_NEAR(length, 8, 1e-12);
  EXPECT_EQ(call({"check", path("out/scene.json")}).code, 0);
}

TEST_F(Cut, FilesForDcSayWhichNumberIsWhichJoint) {
  write("named.csv", plan + "joint bed,0,0.5,4,1.5\njoint shear,0,3.5,4,3.7\n");
  const Outcome cut = call({"cut", path("named.csv"), "--out", path("out"), "--export", path("blocks.dc")});
  ASSERT_EQ(cut.code, 0) << cut.errors;
  const std::string dc = text("blocks.dc");
  const std::string said = "blocks.dc; joints are numbers there: 1 the outline of the blocks and the joint ";
  const std::size_t at = cut.out.find(said);
  ASSERT_NE(at, std::string::npos) << cut.out;
  const std::string names = cut.out.substr(at + said.size());
  EXPECT_TRUE(contains(names, "; names of groups and materials are left out")) << names;
  // The level of the left end tells the lines apart.
  const auto number_of = [&](const std::string& joint) {
    const std::size_t place = names.find(joint);
    return place == 0 ? '1' : names[place - 2];
  };
  EXPECT_TRUE(contains(dc, std::string("0 0.5 4 1.5 ") + number_of("bed") + "\n")) << names << dc;
  EXPECT_TRUE(contains(dc, std::string("0 3.5 4 3.7 ") + number_of("shear") + "\n")) << names << dc;
  EXPECT_FALSE(
      contains(call({"cut", path("named.csv"), "--out", path("out"), "--export", path("blocks.dxf")}).out, "numbers"));
}

// The corner is where the side begins, and the bottom no longer level to the bit.
TEST_F(Cut, AGapThatIsClosedIsListedAndTiltsTheBottomThatHolds) {
  std::string gap = plan;
  gap.replace(gap.find("4,0,4,4"), 7, "4,0.000001,4,4");
  write("gap.csv", gap);
  const Outcome cut = call({"cut", path("gap.csv"), "--out", path("out")});
  ASSERT_EQ(cut.code, 0) << cut.errors;
  EXPECT_TRUE(contains(cut.out, "1 x gap closed")) << cut.out;
  const auto cleaned = nlohmann::json::parse(text("out/cut.json"))["cleaned"][0];
  EXPECT_EQ(cleaned["what"], "gap closed");
  EXPECT_EQ(cleaned["at"], nlohmann::json({4, 0}));
  EXPECT_EQ(cleaned["line"], path("gap.csv") + " line 2 (layer boundary)");
  EXPECT_EQ(nlohmann::json::parse(text("out/scene.json"))["supports"].size(), 1U);
  EXPECT_EQ(call({"check", path("out/scene.json")}).code, 0);
}

// Joints that no line of the drawing has are remarked on, whether a table of layers names them or the scene itself.
TEST_F(Cut, JointsWithoutALineAreRemarked) {
  write("unused.json",
        R"({"dda": 1, "materials": {"rock": {"density": 2600, "young": 2e10, "poisson": 0.25}},
 "joints": {"bed": {"friction_angle": "30 deg"}},
 "blocks": {"rock": {"drawing": {"file": "plan.csv", "layers": {"beds": {"as": "rock", "joint": "bed"}}}}},
 "supports": [{"edge": "bottom"}], "steps": {"dt": 1e-3, "duration": 1e-3}})");
  const std::string remark = "plan.csv: no line is on the layer \"beds\", which is said to have joints";
  const Outcome cut = call({"cut", path("unused.json"), "--out", path("made")});
  ASSERT_EQ(cut.code, 0) << cut.errors;
  EXPECT_TRUE(contains(cut.out, remark)) << cut.out;
  EXPECT_EQ(call({"check", path("made/scene.json")}).code, 0);
  const Outcome check = call({"check", path("unused.json")});
  ASSERT_EQ(check.code, 0) << check.errors;
  EXPECT_TRUE(contains(check.out, remark)) << check.out;
  expect_refusal({"cut", path("plan.csv"), "--out", path("none"), "--layer", "umris=boundary"},
                 "--layer umris is for a layer on which nothing is drawn, expected a layer of " + path("plan.csv"));
}

TEST_F(Cut, SetsWithoutAJointAreRemarkedByCutAndCheck) {
  write("empty.json",
        R"({"dda": 1, "materials": {"rock": {"density": 2600, "young": 2e10, "poisson": 0.25}},
 "joints": {"default": {"friction_angle": "30 deg"}},
 "blocks": {"rock": {"boundary": [[0, 0], [10, 0], [10, 10], [0, 10]],
   "joint_sets": [{"name": "J1", "dip": 0, "spacing": "1 km", "start": [5, 500], "joint": "default"}]}},
 "supports": [{"edge": "bottom"}], "steps": {"dt": 1e-3, "duration": 1e-3}})");
  const std::string remark = "blocks.rock.joint_sets[0] (\"J1\") has no joint in the rock";
  const Outcome cut = call({"cut", path("empty.json"), "--out", path("made")});
  ASSERT_EQ(cut.code, 0) << cut.errors;
  EXPECT_TRUE(contains(cut.out, "remark: " + remark)) << cut.out;
  EXPECT_TRUE(contains(text("made/cut.json"), "has no joint in the rock"));
  const Outcome check = call({"check", path("empty.json")});
  ASSERT_EQ(check.code, 0) << check.errors;
  EXPECT_TRUE(contains(check.out, remark)) << check.out;
}

TEST_F(Cut, AFolderToWhichARunWritesIsRefused) {
  const FolderLock run(path("busy"));
  const Outcome cut = call({"cut", path("plan.csv"), "--out", path("busy")});
  EXPECT_EQ(cut.code, 2);
  EXPECT_TRUE(contains(cut.errors, "to which a run of process ")) << cut.errors;
  EXPECT_FALSE(exists("busy/scene.json"));
}

}  // namespace
}  // namespace dda
