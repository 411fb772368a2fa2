#include "engine/app/command_line.h"

#include <sys/stat.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/app/command_line_test_support.h"
#include "engine/linear/over_processes.h"
#include "engine/scene/scene.h"
#include "engine/scene/scene_schema.h"

namespace dda {
namespace {

TEST_F(CommandLine, HelpOfEveryCommandHasExamples) {
  for (const std::string command :
       {"", "check", "advise", "keyblocks", "fos", "reaction", "run", "view", "spectrum", "schema"}) {
    std::vector<std::string> arguments = {"--help"};
    if (!command.empty()) arguments.insert(arguments.begin(), command);
    const Outcome outcome = call(arguments);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.errors, "");
    EXPECT_TRUE(contains(outcome.out, "Example")) << command;
    EXPECT_TRUE(contains(outcome.out, "dda " + (command.empty() ? "run" : command))) << outcome.out;
    for (std::istringstream stream(outcome.out); std::getline(stream, arguments[0]);)
      EXPECT_LE(arguments[0].size(), 120U) << arguments[0];
  }
}

TEST_F(CommandLine, VersionAndSchema) {
  EXPECT_EQ(call({"--version"}).out, "dda " DDA_VERSION "\n");
  EXPECT_EQ(call({"schema"}).out, scene_schema());
}

TEST_F(CommandLine, MistakesInTheCommandItself) {
  write("scene.json", bar_scene(3, 10));
  expect_refusal({}, "subcommand is required");
  expect_refusal({"solve", "scene.json"},
                 "the command is \"solve\", expected check, advise, cut, keyblocks, fos, reaction, run, view, report, "
                 "spectrum or schema");
  expect_refusal({"run", path("scene.json")}, "--out is required");
  expect_refusal({"run", path("scene.json"), "--out", ""}, "--out: is empty, expected a value");
  expect_refusal({"check", ""}, "scene: is empty, expected a value");
  expect_refusal({"run", path("scene.json"), "--out", path("out"), "--frames", "0"}, "--frames");
  expect_refusal({"run", path("scene.json"), "--out", path("out"), "--frames", "abc"},
                 "--frames: is \"abc\", expected a whole number above 0");
  expect_refusal({"run", path("scene.json"), "--out", path("out"), "--every", "-1"}, "--every");
  expect_refusal({"run", path("scene.json"), "--out", path("out"), "--frames", "3", "--frame-interval", "1ms"},
                 "excludes");
  expect_refusal({"run", path("scene.json"), "--out", path("out"), "--frame-interval", "5Hz"},
                 "--frame-interval is \"5Hz\", expected a finite number with a unit of time");
  expect_refusal({"run", path("scene.json"), "--out", path("out"), "--frame-interval", "-1ms"},
                 "from 1e-12 to 1e+12 s");
  expect_refusal({"check", path("scene.json"), "--frequency", "0"}, "--frequency is 0, expected");
  expect_refusal({"check", path("scene.json"), "--colour"}, "--colour");
  expect_refusal({"advise", path("scene.json"), "--frequency", "1e300"}, ", from 1e-06 to 1e+09 Hz");
  expect_refusal({"advise", path("scene.json"), "--distance", "1e300"},
                 "--distance is 1e300, expected a finite number");
  expect_refusal({"run", path("scene.json"), "--out", path("out"), "--checkpoint-interval", "0"},
                 "--checkpoint-interval is 0, expected");
}

TEST_F(CommandLine, BadScenesGiveOneSentenceAndNoFolder) {
  expect_refusal({"run", path("none.json"), "--out", path("out")}, "none.json: the scene file is missing");
  std::string scene = bar_scene(3, 10);
  const auto refuse = [&](const std::string& from, const std::string& to, std::string_view part) {
    std::string bad = scene;
    bad.replace(bad.find(from), from.size(), to);
    write("scene.json", bad);
    expect_refusal({"run", path("scene.json"), "--out", path("out")}, path("scene.json") + ": ");
    expect_refusal({"run", path("scene.json"), "--out", path("out")}, part);
    expect_refusal({"check", path("scene.json")}, part);
  };
  refuse("2650", "-2650", "density");
  refuse("2650", "NaN", "NaN");
  refuse("50 GPa", "50 GPy", "50 GPy");
  refuse("\"left\"", "\"lefft\"", "lefft");
  refuse("\"dt\"", "\"dtt\"", "dtt");
  refuse("\"dda\": 1,", "\"dda\": 1", "");
  refuse("[2, 0.5]", "[2.5, 0.5]", "measurements[1].point");
}

// The tests of every build are linked without it.
TEST_F(CommandLine, RefusesPetscWhereTheProgramHasNone) {
  std::string scene = bar_scene(3, 10);
  scene.insert(scene.find("\"dt\""), "\"solver\": \"petsc\", ");
  write("scene.json", scene);
  for (const char* command : {"check", "run"}) {
    std::vector<std::string> arguments{command, path("scene.json")};
    if (std::string_view(command) == "run") arguments.insert(arguments.end(), {"--out", path("out")});
    const Outcome outcome = call(arguments);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.errors, "dda: " + path("scene.json") +
                                  ": steps.solver is \"petsc\", expected a solver of this program, which was built "
                                  "without PETSc (ci/petsc builds it with)\n");
  }
  EXPECT_FALSE(exists("out"));
}

// Only mpirun starts more than one.
TEST_F(CommandLine, SaysThatProcessesAreIdle) {
  write("scene.json", bar_scene(3, 10));
  share_over_processes({.processes = 2});
  const Outcome outcome = call({"run", path("scene.json"), "--out", path("out")});
  share_over_processes({});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(
      contains(outcome.out, "remark: of 2 processes one does all the work, as no stage has \"solver\": \"petsc\"\n"));
  EXPECT_FALSE(contains(call({"run", path("scene.json"), "--out", path("out")}).out, "processes"));
}

TEST_F(CommandLine, WhereResultsCannotGo) {
  write("scene.json", bar_scene(3, 10));
  write("file", "mine");
  const Outcome onto_file = call({"run", path("scene.json"), "--out", path("file")});
  EXPECT_EQ(onto_file.code, 2);
  EXPECT_EQ(onto_file.errors, "dda: --out is " + path("file") + ", which is a file, expected a folder\n");
  EXPECT_EQ(text("file"), "mine");
  const Outcome below_file = call({"run", path("scene.json"), "--out", path("file/out")});
  EXPECT_EQ(below_file.code, 2);
  EXPECT_EQ(lines(below_file.errors), 1);
}

// Folders below /proc cannot be made, nor files in the one of a process.
TEST_F(CommandLine, PlacesWhereNothingCanBeMadeAreBadInput) {
  write("scene.json", bar_scene(3, 10));
  ASSERT_EQ(call({"run", path("scene.json"), "--out", path("results"), "--frames", "1"}).code, 0);
  const auto before = files_below("results");
  for (const std::string& place : {std::string("/proc/1/x"), std::string("/proc/x"), std::string(300, 'x')}) {
    for (const std::string command : {"run", "keyblocks", "fos"})
      expect_refusal({command, path("scene.json"), "--out", place}, "--out is " + place + ", which cannot be made");
    for (const std::string command : {"view", "report"})
      expect_refusal({command, path("results"), "--out", place + ".html"},
                     "--out is " + place + ".html, where nothing can be written");
  }
  EXPECT_EQ(files_below("results"), before);
}

TEST_F(CommandLine, FoldersInThePlaceOfResultsAreBadInput) {
  write("scene.json", bar_scene(3, 10));
  for (const std::string name : {"summary.json", "histories.csv", "energies.csv"}) {
    ASSERT_EQ(call({"run", path("scene.json"), "--out", path("results"), "--frames", "1"}).code, 0);
    std::filesystem::remove(path("results/" + name));
    std::filesystem::create_directories(path("results/" + name));
    expect_refusal({"run", path("scene.json"), "--out", path("results")}, "where " + name + " is a directory");
    expect_refusal({"report", path("results")}, "cannot read " + path("results/" + name) + ": it is a directory");
    if (name == "energies.csv") continue;  // which a page does without
    expect_refusal({"view", path("results")}, "cannot read " + path("results/" + name) + ": it is a directory");
    std::filesystem::remove(path("results/" + name));
  }
  for (const std::string name : {"run.lock", "keyblocks.svg"}) {
    std::filesystem::create_directories(path("other/" + name));
    expect_refusal({"keyblocks", path("scene.json"), "--out", path("other")}, "--out is " + path("other") + ", where ");
    std::filesystem::remove(path("other/" + name));
    EXPECT_TRUE(files_below("other").empty());
  }
}

TEST_F(CommandLine, CheckSaysWhatWillBeRun) {
  write("scene.json", bar_scene(40, 300));
  const Outcome outcome = call({"check", path("scene.json")});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.errors, "");
  for (const char* part :
       {"bar\n", "40, 1 m to 1 m", "\"rock\": 2650 kg/m3, E = 50 GPa", "39 interfaces", "39 cubic, bonded",
        "1 edge load", "stress [Pa]: stress_xx at [1.5, 0.5]", "240 unknowns", "300 steps of 1e-05 s",
        "waves: corrected for the time steps", "geometry: as drawn, matrix built once", "predicted for waves of 100 Hz",
        "bar wave in \"rock\", along the row: 4343.72 m/s, wavelength 43.44 m", "eta) 0.023 at 1 m", "theta) 0.00628"})
    EXPECT_TRUE(contains(outcome.out, part)) << part << "\n" << outcome.out;
  EXPECT_TRUE(contains(call({"check", path("scene.json"), "--frequency", "0.2 kHz"}).out, "waves of 200 Hz"));
  EXPECT_TRUE(contains(call({"check", path("scene.json"), "--frequency", "50"}).out, "waves of 50 Hz"));
  EXPECT_FALSE(exists("out"));
}

TEST_F(CommandLine, RunWritesItsResults) {
  write("scene.json", bar_scene(5, 100));
  const Outcome outcome = call({"run", path("scene.json"), "--out", path("out"), "--frames", "4", "--every", "10"});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  EXPECT_TRUE(contains(outcome.out, "ok: 100 steps to 0.001 s")) << outcome.out;
  const std::string histories = text("out/histories.csv");
  EXPECT_EQ(lines(histories), 1 + 11);
  EXPECT_TRUE(histories.starts_with("time [s],stress [Pa],traction_normal [Pa]\n0,0,0\n"));
  EXPECT_TRUE(exists("out/frames.pvd"));
  EXPECT_TRUE(exists("out/frames/000004.vtp"));
  EXPECT_FALSE(exists("out/frames/000005.vtp"));
  EXPECT_TRUE(exists("out/contacts/000004.vtp"));
  EXPECT_FALSE(exists("out/contacts/000005.vtp"));
  const auto summary = nlohmann::json::parse(text("out/summary.json"));
  EXPECT_EQ(summary["status"], "ok");
  EXPECT_EQ(summary["steps"], 100);
  EXPECT_EQ(summary["counters"]["factorizations"], 1);
  EXPECT_EQ(summary["histories"][0]["rows"], 11);
  EXPECT_LT(std::abs(summary["energy"]["residual_relative"].get<double>()), 1e-10);
  EXPECT_EQ(summary["outputs"].size(), 7U);
  for (const auto& output : summary["outputs"]) EXPECT_TRUE(exists("out/" + output.get<std::string>()));
}

// The end has a frame whether or not it is due: it is what a run is for.
TEST_F(CommandLine, FrameIntervalIsSimulatedTime) {
  write("scene.json", bar_scene(3, 100));
  EXPECT_EQ(call({"run", path("scene.json"), "--out", path("out"), "--frame-interval", "0.3 ms", "--quiet"}).out, "");
  const std::string index = text("out/frames.pvd");
  for (const double time : {0.0, 3e-4, 6e-4, 9e-4, 1e-3}) {
    const auto found = index.find(fmt::format("timestep=\"{:.4g}", time));
    EXPECT_NE(found, std::string::npos) << time << "\n" << index;
  }
  EXPECT_FALSE(exists("out/frames/000005.vtp"));
}

TEST_F(CommandLine, OverwritesItsOwnFilesOnly) {
  write("scene.json", bar_scene(3, 20));
  std::filesystem::create_directories(path("out/frames"));
  write("out/notes.txt", "mine");
  write("out/histories.csv", "old");
  write("out/checkpoint.bin", "old");
  write("out/frames/mine.vtp", "mine");
  EXPECT_EQ(call({"run", path("scene.json"), "--out", path("out"), "--frames", "1"}).code, 0);
  EXPECT_EQ(text("out/notes.txt"), "mine");
  EXPECT_EQ(text("out/frames/mine.vtp"), "mine");
  EXPECT_EQ(lines(text("out/histories.csv")), 1 + 21);
  EXPECT_TRUE(text("out/checkpoint.bin").starts_with("DDASTATE"));
}

TEST_F(CommandLine, ARunThatEndsEarlySaysWhyAndKeepsItsResults) {
  write("scene.json", falling_stone);
  const Outcome outcome = call({"run", path("scene.json"), "--out", path("out"), "--frames", "2"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(lines(outcome.errors), 1);
  EXPECT_TRUE(contains(outcome.errors, "left_contact_range after step ")) << outcome.errors;
  EXPECT_TRUE(contains(outcome.errors, "\"floor\" and \"stone\"")) << outcome.errors;
  const auto summary = nlohmann::json::parse(text("out/summary.json"));
  EXPECT_EQ(summary["status"], "left_contact_range");
  EXPECT_TRUE(contains(summary["message"], "not followed yet"));
  EXPECT_EQ(lines(text("out/histories.csv")), 2 + summary["steps"].get<int>()) << "a row each step, start and header";
  EXPECT_TRUE(contains(text("out/frames.pvd"), fmt::format("timestep=\"{}\"", summary["time_s"].get<double>())));
}

TEST_F(CommandLine, CheckRefusesToPredictWavesShorterThanTwoSteps) {
  write("scene.json", bar_scene(3, 20));  // steps of 1e-5 s
  EXPECT_TRUE(
      contains(call({"check", path("scene.json"), "--frequency", "60 kHz"}).out, "less than two steps a period"));
  EXPECT_FALSE(
      contains(call({"check", path("scene.json"), "--frequency", "40 kHz"}).out, "less than two steps a period"));
}

// An integrator that damps little carries contact accelerations into free flight: a light slab on a floor gains energy
// by them.
TEST_F(CommandLine, ARunThatGainsEnergySaysSo) {
  write("scene.json", restless_slab);
  const Outcome outcome = call({"run", path("scene.json"), "--out", path("out")});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_TRUE(contains(outcome.errors, "gained_energy: time integration added ")) << outcome.errors;
  EXPECT_TRUE(contains(outcome.errors, "that of blocks \"slab\" at (")) << outcome.errors;
  const auto summary = nlohmann::json::parse(text("out/summary.json"));
  EXPECT_EQ(summary["status"], "gained_energy");
  EXPECT_TRUE(contains(summary["message"], "time integration added"));
  std::string damped = restless_slab;
  const std::string integrator = R"({"generalized_alpha": 0.95})";
  damped.replace(damped.find(integrator), integrator.size(), R"("thesis")");
  write("scene.json", damped);
  EXPECT_EQ(call({"run", path("scene.json"), "--out", path("damped")}).errors, "");
}

// Springs a million times stiffer than their blocks, in steps of 200 transit times of a block: k dt^2/m is 1e11 and
// more, and as many digits of every solve are lost.
TEST_F(CommandLine, ARunWhoseEnergiesDoNotAddUpIsInaccurate) {
  const auto scene_with = [](const std::string& spring_over_young) {
    return R"({"dda": 1, "materials": {"rock": {"density": 2500, "young": "10 GPa", "poisson": 0.2}},
      "joints": {"default": {"bonded": true, "law": "classical", "spring_over_young": )" +
           spring_over_young +
           R"(}}, "blocks": {"grid": {"columns": 10, "rows": 10, "block_width": 1, "block_height": 1}},
      "supports": [{"edge": "bottom", "hold": "normal"}],
      "loads": [{"edge": "left", "traction": ["1 MPa", 0], "history": {"triangle": {"rise": 0.5, "fall": 0.5}}}],
      "steps": {"dt": "0.1 s", "duration": "15 s", "kinematics": "small"}})";
  };
  write("scene.json", scene_with("1e6"));
  const Outcome stiff = call({"run", path("scene.json"), "--out", path("out")});
  EXPECT_EQ(stiff.code, 3);
  EXPECT_TRUE(contains(stiff.errors, "inaccurate: the energies do not add up: ")) << stiff.errors;
  EXPECT_EQ(nlohmann::json::parse(text("out/summary.json"))["status"], "inaccurate");
  write("scene.json", scene_with("1"));
  const Outcome soft = call({"run", path("scene.json"), "--out", path("soft")});
  EXPECT_EQ(soft.code, 0) << soft.errors;
  EXPECT_FALSE(contains(soft.errors, "energies do not add up")) << soft.errors;
}

// A box of 1 m that its joint of 1 MPa/m lets sink in by 2.6 cm and more.
TEST_F(CommandLine, ARunWithDeepPenetrationNamesTheBlocks) {
  const auto scene_with = [](const std::string& stiffness) {
    return R"({"dda": 1, "materials": {"rock": {"density": 2650, "young": "1 GPa", "poisson": 0.25}},
      "joints": {"default": {"friction_angle": "30 deg", "normal_stiffness": )" +
           stiffness + R"(}}, "gravity": 9.81,
      "blocks": [{"polygon": {"name": "floor", "vertices": [[-1, -1], [2, -1], [2, 0], [-1, 0]]}},
                 {"polygon": {"name": "box", "vertices": [[0, 0], [1, 0], [1, 1], [0, 1]]}}],
      "supports": [{"edge": "bottom"}], "steps": {"dt": "1 ms", "duration": "0.5 s", "integrator": "thesis"}})";
  };
  write("scene.json", scene_with(R"("1 MPa/m")"));
  const Outcome soft = call({"run", path("scene.json"), "--out", path("out")});
  EXPECT_EQ(soft.code, 0);
  EXPECT_TRUE(contains(soft.errors, "warning: blocks \"floor\" and \"box\" were 0.0")) << soft.errors;
  const auto deepest = nlohmann::json::parse(text("out/summary.json"))["deepest_penetration"];
  // Dropped onto its springs, it sinks twice as deep as it would rest.
  EXPECT_NEAR(deepest["depth_m"].get<double>(), 2 * 2650 * 9.81 / 1e6, 2e-3);
  EXPECT_NEAR(deepest["of_smaller_block"].get<double>(), deepest["depth_m"].get<double>(), 1e-4) << "of 1 m";
  EXPECT_EQ(deepest["blocks"], nlohmann::json({"floor", "box"}));
  write("scene.json", scene_with(R"("auto")"));
  EXPECT_EQ(call({"run", path("scene.json"), "--out", path("stiff")}).errors, "");
  EXPECT_LT(nlohmann::json::parse(text("stiff/summary.json"))["deepest_penetration"]["of_smaller_block"], 1e-5);
}

TEST_F(CommandLine, CheckAndRunRemarkOnWhatIsOdd) {
  const std::string remark = "material \"rock\": density is 2.65 kg/m3; rock has 2000 to 3000 kg/m3";
  std::string scene = bar_scene(3, 10);
  write("scene.json", scene);
  EXPECT_FALSE(contains(call({"check", path("scene.json")}).out, "remark"));
  write("scene.json", scene.replace(scene.find("2650"), 4, "2.65"));
  const Outcome check = call({"check", path("scene.json")});
  EXPECT_TRUE(contains(check.out, remark)) << check.out;
  const Outcome run = call({"run", path("scene.json"), "--out", path("out")});
  EXPECT_EQ(run.code, 0) << run.errors;
  EXPECT_TRUE(contains(run.out, "remark: " + remark)) << run.out;
  EXPECT_EQ(nlohmann::json::parse(text("out/summary.json"))["remarks"], nlohmann::json({remark}));
}

// Where blocks move contacts are followed before they close: those that do not touch are not taken to.
TEST_F(CommandLine, CheckRemarksOnGapsWhateverTheKinematics) {
  for (const char* kinematics : {"small", "finite"}) {
    write("scene.json", std::string(R"({"dda": 1, "gravity": 9.81, "fixed": ["low"],
      "materials": {"rock": {"density": 2600, "young": "10 GPa", "poisson": 0.2}},
      "joints": {"default": {"friction_angle": "30 deg"}},
      "blocks": [{"polygon": {"name": "low", "vertices": [[0, 0], [1, 0], [1, 1], [0, 1]]}},
                 {"polygon": {"name": "up", "vertices": [[0, 1.001], [1, 1.001], [1, 2], [0, 2]]}}],
      "steps": {"dt": "1 ms", "duration": "0.01 s", "kinematics": ")") +
                            kinematics + R"("}})");
    const Outcome check = call({"check", path("scene.json")});
    EXPECT_TRUE(contains(check.out, "blocks \"low\" and \"up\" are 0.001 m apart and do not touch")) << check.out;
  }
}

// A plate of 1 m at 100 rad/s: rho omega^2/12 = 2.2 MPa.
TEST_F(CommandLine, RunsOfBlocksThatSpinWarnOfTheStressThatTheyBeginWithout) {
  write("scene.json", R"({"dda": 1, "materials": {"rock": {"density": 2650, "young": "50 GPa", "poisson": 0.2}},
    "blocks": [{"polygon": {"name": "plate", "vertices": [[0, 0], [1, 0], [1, 1], [0, 1]], "initial_spin": 100}}],
    "steps": {"dt": "20 us", "duration": "1 ms", "integrator": "trapezoidal"}})");
  const Outcome run = call({"run", path("scene.json"), "--out", path("out"), "--quiet"});
  EXPECT_EQ(run.code, 0) << run.errors;
  EXPECT_TRUE(contains(run.errors, "warning: block \"plate\" spins at 100 rad/s")) << run.errors;
}

TEST_F(CommandLine, ScenesAreRegularFiles) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  expect_refusal({"check", path("pipe")}, "pipe: the scene file is a named pipe, expected a JSON file");
  for (const char* device : {"/dev/zero", "/dev/random"})
    for (const char* command : {"check", "advise"})
      expect_refusal({command, device}, std::string(device) + ": the scene file is a device, expected a JSON file");
}

TEST_F(CommandLine, CheckSaysWhatSpringsDo) {
  write("scene.json", R"({"dda": 1, "materials": {"rock": {"density": 2000, "young": "1 GPa", "poisson": 0.25}},
    "joints": {"default": {"normal_stiffness": "50 GPa/m"}, "chosen": {"normal_stiffness": "auto", "law": "classical"},
               "glue": {"bonded": true}},
    "joint_pairs": [{"between": ["grid 2.1", "grid 3.1"], "joint": "chosen"},
                    {"between": ["grid 3.1", "grid 4.1"], "joint": "glue"}],
    "blocks": {"grid": {"columns": 1, "rows": 4, "block_width": 1, "block_height": 1}}, "gravity": 10,
    "supports": [{"edge": "bottom"}], "steps": {"dt": "1 ms", "duration": 1}})");
  const std::string check = call({"check", path("scene.json")}).out;
  EXPECT_TRUE(contains(check,
                       "\"default\": 50 to 50 GPa/m; adds at most 2.13 % to the compliance of the blocks; blocks "
                       "pressed in by at most 1.6e-06 of their size under 0.08 MPa"))
      << check;
  // The diameter of a square is sqrt(2) of its side; blocks that cannot give way sideways are 1/(1 - nu^2) as stiff.
  EXPECT_TRUE(contains(check, "\"chosen\": 141 to 141 GPa/m, chosen; adds at most 0.754 %")) << check;
  EXPECT_FALSE(contains(check, "springs      \"glue\"")) << check;
}

}  // namespace
}  // namespace dda
