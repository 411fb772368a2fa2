// `dda reaction` as from a shell.
#include <nlohmann/json.hpp>
#include <string>

#include "engine/app/command_line_test_support.h"

namespace dda {
namespace {

// A beam of two blocks under 2 MPa, and what carries it: the core of a frame of held blocks, which is taken out.
const std::string keystone = R"({"dda": 1, "gravity": 9.81,
 "materials": {"rock": {"density": 2600, "young": 1e10, "poisson": 0.2}},
 "joints": {"default": {"friction_angle": "20 deg"}},
 "blocks": [{"polygon": {"name": "floor", "vertices": [[-2, -1], [3, -1], [3, 0], [-2, 0]]}},
            {"polygon": {"name": "left", "vertices": [[-2, 0], [0, 0], [0, 1], [-0.2, 2], [-2, 2]]}},
            {"polygon": {"name": "right", "vertices": [[1, 0], [3, 0], [3, 2], [1.2, 2], [1, 1]]}},
            {"polygon": {"name": "key", "vertices": [[0, 1], [1, 1], [1.2, 2], [-0.2, 2]]}},
            {"polygon": {"name": "core", "group": "tunnel", "vertices": [[0, 0], [1, 0], [1, 1], [0, 1]]}}],
 "fixed": ["floor", "left", "right"],
 "loads": [{"edge": {"from": [-0.2, 2], "to": [1.2, 2]}, "block": "key", "traction": [0, -1e5]}],
 "steps": [{"integrator": "static"}, {"remove": ["tunnel"], "dt": 1e-3, "duration": 1}]})";

// The same with a key that is wider at its foot, which falls.
std::string falling_key() {
  std::string scene = keystone;
  const auto swap = [&scene](const std::string& from, const std::string& to) {
    for (std::size_t at = scene.find(from); at != std::string::npos; at = scene.find(from, at + to.size()))
      scene.replace(at, from.size(), to);
  };
  swap("[-0.2, 2]", "[0.2, 2]");
  swap("[1.2, 2]", "[0.8, 2]");
  return scene;
}

class ReactionCommand : public CommandLine {};

TEST_F(ReactionCommand, WritesTheCurve) {
  write("scene.json", keystone);
  const Outcome outcome =
      call({"reaction", path("scene.json"), "--opening", "tunnel", "--steps", "4", "--out", path("out")});
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_TRUE(contains(outcome.errors, "share 0.5: the wall comes in by")) << outcome.errors;
  // In situ the wall has not moved, but for round-off.
  EXPECT_TRUE(contains(outcome.out, "     1       0.05714          0          0          0          0          0\n"))
      << outcome.out;
  const nlohmann::json report = nlohmann::json::parse(text("out/reaction.json"));
  ASSERT_EQ(report["points"].size(), 5U);
  EXPECT_EQ(report["settles_down_to"], 0);
  EXPECT_TRUE(report["fails_at"].is_null());
  EXPECT_NEAR(report["wall_length"].get<double>(), 4, 1e-12);
  const nlohmann::json& last = report["points"][4]["displacement"];
  EXPECT_GT(last["crown"].get<double>(), 0);
  EXPECT_EQ(last["largest_of"], "key");
  EXPECT_EQ(last["left"], 0);  // held
  EXPECT_EQ(lines(text("out/reaction.csv")), 6);
  EXPECT_TRUE(contains(text("out/reaction.svg"), "</svg>"));
}

TEST_F(ReactionCommand, SaysFromWhereOnRockFalls) {
  write("scene.json", falling_key());
  const Outcome outcome = call({"reaction", path("scene.json"), "--opening", "tunnel", "--out", path("out")});
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_TRUE(contains(outcome.out, "does not come to rest, and the curve ends at")) << outcome.out;
  const nlohmann::json report = nlohmann::json::parse(text("out/reaction.json"));
  const nlohmann::json& last = report["points"].back();
  EXPECT_FALSE(last["settles"]);
  EXPECT_TRUE(last["displacement"].is_null());
  EXPECT_EQ(last["loose_blocks"].at(0)["block"], "key");
  EXPECT_EQ(report["fails_at"], last["share"]);
  EXPECT_GT(report["settles_down_to"], report["fails_at"]);
  EXPECT_EQ(lines(text("out/reaction.csv")), static_cast<std::ptrdiff_t>(report["points"].size()));
  EXPECT_TRUE(contains(text("out/reaction.svg"), "no rest at a share of"));
}

TEST_F(ReactionCommand, NamesWhatTheSameStageTakesOut) {
  nlohmann::json scene = nlohmann::json::parse(keystone);
  scene["loads"].clear();
  scene["steps"][1]["remove"] = {"tunnel", "key"};
  write("scene.json", scene.dump());
  const Outcome outcome =
      call({"reaction", path("scene.json"), "--opening", "tunnel", "--steps", "1", "--out", path("out")});
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_TRUE(contains(outcome.out, "Another block that the same stage takes out lets go to the same share."))
      << outcome.out;
  const nlohmann::json report = nlohmann::json::parse(text("out/reaction.json"));
  EXPECT_EQ(report["removed_with_it"], nlohmann::json::array({"key"}));
  EXPECT_NEAR(report["wall_length"].get<double>(), 3, 1e-12);  // without the face that is the key's
}

// A stone in the air, which nothing holds from the start, is no rock that the opening lets fall.
TEST_F(ReactionCommand, OfRockWithLooseStonesGoesOnToZero) {
  nlohmann::json scene = nlohmann::json::parse(keystone);
  scene["blocks"].push_back({{"polygon", {{"name", "stone"}, {"vertices", {{8, 20}, {9, 20}, {9, 21}, {8, 21}}}}}});
  write("scene.json", scene.dump());
  const Outcome outcome = call({"reaction", path("scene.json"), "--opening", "tunnel", "--out", path("out")});
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_TRUE(contains(outcome.out, "In situ nothing held block \"stone\" at (")) << outcome.out;
  const nlohmann::json report = nlohmann::json::parse(text("out/reaction.json"));
  EXPECT_EQ(report["settles_down_to"], 0);
  EXPECT_EQ(report["loose_in_situ"].at(0)["block"], "stone");
  EXPECT_EQ(report["points"].back()["loose_blocks"].size(), 0U);
}

// A sliver on a ramp that its friction does not hold, away from the opening: in situ joints stick whatever they carry,
// and it comes loose as soon as they have their own strength, whatever the share.
TEST_F(ReactionCommand, OfRockWithSliversThatComeLooseAtOnceGoesOnToZero) {
  nlohmann::json scene = nlohmann::json::parse(keystone);
  scene["blocks"].push_back({{"polygon", {{"name", "ramp"}, {"vertices", {{10, 0}, {11.5, 0}, {10, 1.5}}}}}});
  scene["blocks"].push_back(
      {{"polygon", {{"name", "sliver"}, {"vertices", {{10.5, 1}, {10.9, 0.6}, {11, 0.7}, {10.6, 1.1}}}}}});
  scene["fixed"].push_back("ramp");
  scene["steps"][0]["strength"] = "unlimited";
  write("scene.json", scene.dump());
  const Outcome outcome =
      call({"reaction", path("scene.json"), "--opening", "tunnel", "--steps", "4", "--out", path("out")});
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_TRUE(contains(outcome.out, "With all of its support left nothing holds block \"sliver\" at (")) << outcome.out;
  const nlohmann::json report = nlohmann::json::parse(text("out/reaction.json"));
  EXPECT_EQ(report["settles_down_to"], 0);
  EXPECT_TRUE(report["loose_in_situ"].empty());
  EXPECT_EQ(report["loose_at_full_share"].at(0)["block"], "sliver");
  // The same curve as without ramp and sliver, which touch nothing else and are no higher: springs are chosen by
  // height.
  write("scene.json", [&] {
    nlohmann::json alone = nlohmann::json::parse(keystone);
    alone["steps"][0]["strength"] = "unlimited";
    return alone.dump();
  }());
  ASSERT_EQ(call({"reaction", path("scene.json"), "--opening", "tunnel", "--steps", "4", "--out", path("alone")}).code,
            0);
  const nlohmann::json alone = nlohmann::json::parse(text("alone/reaction.json"));
  ASSERT_EQ(alone["points"].size(), report["points"].size());
  const double whole = alone["points"].back()["displacement"]["mean"];
  for (std::size_t i = 0; i < alone["points"].size(); ++i)
    // Friction remembers its way, and static steps are others while a sliver slides: by at most 0.3 % (ADR 65), here
    // 3e-5.
    EXPECT_NEAR(report["points"][i]["displacement"]["mean"].get<double>() / whole,
                alone["points"][i]["displacement"]["mean"].get<double>() / whole, 3e-3);
}

// Nothing is computed for a folder that cannot be written to: no share is spoken of.
TEST_F(ReactionCommand, FindsOutBeforeItComputesWhereNothingCanBeWritten) {
  write("scene.json", keystone);
  const auto refused = [&](const std::string& folder, std::string_view part) {
    const Outcome outcome = call({"reaction", path("scene.json"), "--opening", "tunnel", "--out", folder});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_TRUE(contains(outcome.errors, part)) << outcome.errors;
    EXPECT_FALSE(contains(outcome.errors, "share ")) << outcome.errors;
    EXPECT_EQ(lines(outcome.errors), 1);
  };
  refused(path("scene.json") + "/out", "which cannot be made");
  refused("/proc/out", "which cannot be made");
  std::filesystem::create_directories(path("taken/reaction.csv"));
  refused(path("taken"), "where reaction.csv is a directory, expected a folder that can be written to");
  EXPECT_EQ(files_below(".").size(), 1U);
}

TEST_F(ReactionCommand, WritesTheSameEveryTime) {
  write("scene.json", falling_key());
  for (const char* folder : {"one", "two"})
    ASSERT_EQ(call({"reaction", path("scene.json"), "--opening", "tunnel", "--out", path(folder)}).code, 0);
  EXPECT_EQ(files_below("one"), files_below("two"));
}

TEST_F(ReactionCommand, TakesSharesOfItsOwn) {
  write("scene.json", keystone);
  ASSERT_EQ(call({"reaction", path("scene.json"), "--opening", "core", "--out", path("no")}).code, 2);
  ASSERT_EQ(
      call({"reaction", path("scene.json"), "--opening", "tunnel", "--shares", "0.6,0.25", "--out", path("out")}).code,
      0);
  const nlohmann::json report = nlohmann::json::parse(text("out/reaction.json"));
  ASSERT_EQ(report["points"].size(), 2U);
  EXPECT_EQ(report["points"][1]["share"], 0.25);
}

// Crown and invert were looked for from a centroid in the rock between the two.
TEST_F(ReactionCommand, RefusesAGroupInTwoPlaces) {
  nlohmann::json scene = nlohmann::json::parse(keystone);
  scene["blocks"].push_back(
      {{"polygon", {{"name", "far"}, {"group", "tunnel"}, {"vertices", {{3, 0}, {4, 0}, {4, 1}, {3, 1}}}}}});
  write("scene.json", scene.dump());
  expect_refusal(
      {"reaction", path("scene.json"), "--opening", "tunnel", "--out", path("out")},
      "--opening is \"tunnel\", whose blocks lie in 2 places, at \"core\" and \"far\", expected an opening with "
      "one wall");
  EXPECT_FALSE(exists("out"));
}

// Rock that falls before anything is taken out has no curve.
TEST_F(ReactionCommand, OfRockThatDoesNotSettleInSituEndsEarly) {
  nlohmann::json scene = nlohmann::json::parse(keystone);
  scene["steps"] =
      nlohmann::json::parse(R"([{"integrator": "static", "dt": 1e-5, "duration": 1e-5, "equilibrium": 1e-9}])");
  write("scene.json", scene.dump());
  const Outcome outcome = call({"reaction", path("scene.json"), "--opening", "tunnel", "--out", path("out")});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_TRUE(contains(outcome.errors, "does not settle before \"tunnel\" is taken out: static stage"))
      << outcome.errors;
  EXPECT_FALSE(exists("out"));
}

TEST_F(ReactionCommand, RefusesWhatIsWrongBeforeItWritesAnything) {
  write("scene.json", keystone);
  const auto refused = [&](const std::vector<std::string>& more, std::string_view part) {
    std::vector<std::string> arguments{"reaction", path("scene.json"), "--out", path("out")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_refusal(arguments, part);
  };
  refused({}, "--opening is required");
  refused({"--opening", "tunel"},
          "--opening is \"tunel\", expected the name of an opening or of a group of blocks (\"tunnel\"?)");
  refused({"--opening", "left"}, "which is held");
  refused({"--opening", "tunnel", "--steps", "0"}, "--steps is 0, expected a whole number from 1 to 1000");
  refused({"--opening", "tunnel", "--shares", "0.5,0.5"}, "--shares is 0.5 in place 2, expected numbers from 1 to 0");
  refused({"--opening", "tunnel", "--shares", "1.1"}, "--shares is 1.1 in place 1");
  refused({"--opening", "tunnel", "--shares", "nan"}, "--shares is nan in place 1");
  refused({"--opening", "tunnel", "--shares", "1,,0"}, "--shares is \"\" in place 2, expected numbers from 1 to 0");
  refused({"--opening", "tunnel", "--shares", "1,0,"}, "--shares is \"\" in place 3");
  refused({"--opening", "tunnel", "--shares", ",1"}, "--shares is \"\" in place 1");
  refused({"--opening", "tunnel", "--shares", "1,half"}, "--shares is \"half\" in place 2");
  refused({"--opening", "tunnel", "--shares", "1,0", "--steps", "3"}, "--steps");
  expect_refusal({"reaction", path("scene.json"), "--opening", "tunnel", "--out", path("scene.json")},
                 "which is a file");
  EXPECT_EQ(files_below(".").size(), 1U);
}

}  // namespace
}  // namespace dda
