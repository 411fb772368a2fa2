// What `dda check` says of scenes whose stages change the blocks and the rock, and of what acts where it is at odds
// with something else.
#include <gtest/gtest.h>

#include "engine/app/command_line_test_support.h"

namespace dda {
namespace {

// Bonded squares of two materials, of which a dynamic stage brings one in. What waves do is foretold of a block and its
// neighbours as a scene of their own, which knows nothing of the stage's blocks and materials.
TEST_F(CommandLine, ChecksDynamicStagesThatAddBlocks) {
  write("scene.json", R"({"dda": 1,
    "materials": {"rock": {"density": 2600, "young": "20 GPa", "poisson": 0.2},
                  "fill": {"density": 2000, "young": "5 GPa", "poisson": 0.2}},
    "joints": {"default": {"bonded": true}},
    "blocks": [{"polygon": {"name": "a", "material": "rock", "vertices": [[0, 0], [1, 0], [1, 1], [0, 1]]}},
               {"polygon": {"name": "b", "material": "rock", "vertices": [[1, 0], [2, 0], [2, 1], [1, 1]]}},
               {"polygon": {"name": "c", "material": "fill", "vertices": [[2, 0], [3, 0], [3, 1], [2, 1]]}}],
    "fixed": ["a"],
    "loads": [{"edge": "top", "block": "b", "pressure": 1000, "history": {"sine": {"frequency": 400}}}],
    "steps": [{"name": "one", "kinematics": "small", "dt": "20 us", "duration": "1 ms"},
              {"name": "two", "kinematics": "small", "dt": "20 us", "duration": "1 ms", "add": ["c"],
               "materials": {"fill": {"density": 2300}}}]})");
  const Outcome outcome = call({"check", path("scene.json")});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_TRUE(contains(outcome.out, "other density of materials: \"fill\"")) << outcome.out;
}

// Three squares in a row, the last of which may go before the second stage.
std::string row(const std::string& acts, const std::string& stages) {
  return R"({"dda": 1, "materials": {"rock": {"density": 2600, "young": "20 GPa", "poisson": 0.2}},
    "joints": {"default": {"friction_angle": "30 deg"}},
    "blocks": [{"polygon": {"name": "a", "vertices": [[0, 0], [1, 0], [1, 1], [0, 1]]}},
               {"polygon": {"name": "b", "vertices": [[1, 0], [2, 0], [2, 1], [1, 1]]}},
               {"polygon": {"name": "c", "vertices": [[2, 0], [3, 0], [3, 1], [2, 1]]}}],
    "fixed": ["a"], )" +
         acts + R"(, "steps": [{"name": "one", "dt": "1 ms", "duration": "5 ms"}, {"name": "two", "dt": "1 ms", )" +
         stages + R"("duration": "5 ms"}]})";
}

// Which law the joints have that come in with blocks, and the remark on springs that lock.
TEST_F(CommandLine, ListsTheJointsOfBlocksThatAStageAdds) {
  std::string joints = R"("default": {"friction_angle": "30 deg"})";
  const auto report = [&] {
    write("scene.json", R"({"dda": 1, "materials": {"rock": {"density": 2600, "young": "20 GPa", "poisson": 0.2}},
      "joints": {)" + joints +
                            R"(},
      "blocks": [{"polygon": {"name": "a", "vertices": [[0, 0], [2, 0], [2, 1], [0, 1]]}},
                 {"grid": {"name": "b", "columns": 2, "rows": 2, "block_width": 1, "block_height": 1, "origin": [0, 1]}}],
      "fixed": ["a"],
      "steps": [{"name": "one", "integrator": "static"}, {"name": "two", "integrator": "static", "add": ["b"]}]})");
    const Outcome outcome = call({"check", path("scene.json")});
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    return outcome.out;
  };
  std::string out = report();
  EXPECT_TRUE(contains(out, "adds 4 blocks with joints: 6 projected of \"default\"")) << out;
  EXPECT_FALSE(contains(out, "lock blocks")) << out;
  joints = R"("default": {"friction_angle": "30 deg", "law": "classical"})";
  out = report();
  EXPECT_TRUE(contains(out, "adds 4 blocks with joints: 6 classical of \"default\"")) << out;
  EXPECT_TRUE(contains(out, "lock blocks")) << out;
}

TEST_F(CommandLine, RemarksOnSupportsThatMoveAPointInTwoWays) {
  const auto says_so = [&](const std::string& supports, const char* place = "") {
    write("scene.json", row("\"supports\": [" + supports + "]", ""));
    const Outcome outcome = call({"check", path("scene.json")});
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    return contains(outcome.out, "move it differently") && contains(outcome.out, place);
  };
  const std::string at = R"({"point": [3, 1], )";
  EXPECT_TRUE(says_so(at + R"("velocity": [1, 0]}, )" + at + R"("velocity": [2, 0]})",
                      "two supports hold block \"c\" at (3, 1) m and move"));
  EXPECT_TRUE(says_so(at + R"("displacement": [0, 0.01], "history": {"sine": {"frequency": 200}}}, )" + at +
                      R"("hold": "y"})"));
  EXPECT_TRUE(says_so(R"({"edge": "right", "velocity": [1, 0]}, {"edge": "right"})", "m and 1 more and move"));
  // The same motion, said in two ways; other directions; and the corner of two sides that are clamped.
  EXPECT_FALSE(says_so(at + R"("velocity": [1, 0]}, )" + at +
                       R"("displacement": [1, 0], "history": {"table": [[0, 0], [1, 1]]}})"));
  EXPECT_FALSE(says_so(at + R"("hold": "x", "velocity": [1, 0]}, )" + at + R"("hold": "y", "velocity": [0, 2]})"));
  EXPECT_FALSE(says_so(R"({"edge": "right", "velocity": [1, 0]}, {"edge": "bottom", "block": "c"})"));
}

TEST_F(CommandLine, RemarksOnViscousBoundariesOnJoints) {
  const auto says_so = [&](const std::string& boundary, const std::string& stages) {
    write("scene.json", row(R"("viscous_boundaries": [{)" + boundary + "}]", stages));
    const Outcome outcome = call({"check", path("scene.json")});
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    return contains(outcome.out, "of block \"b\" at (2, 0.5) m on its joint with block \"c\"");
  };
  const std::string joint = R"("edge": {"from": [2, 0], "to": [2, 1]}, "block": "b")";
  EXPECT_TRUE(says_so(joint, ""));
  EXPECT_TRUE(says_so(joint, R"("remove": ["c"], )")) << "it is there in the first stage";
  EXPECT_FALSE(says_so(joint + R"(, "from_stage": "two")", R"("remove": ["c"], )"));
  EXPECT_FALSE(says_so(R"("edge": "right")", ""));
}

}  // namespace
}  // namespace dda
