// What `dda check` says of scenes whose stages change the blocks and the rock.
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

}  // namespace
}  // namespace dda
