// `dda run` of bonded blocks that are drawn apart farther than contacts are looked for.
#include <nlohmann/json.hpp>
#include <string>

#include "engine/app/command_line_test_support.h"

namespace dda {
namespace {

class StretchedBond : public CommandLine {};

// A block as soft as jelly hangs from a roof, a dry wall stands beside it. It ended the program with "BlockMatrix: no
// block (1, 0)" and code 1, as the two blocks were no longer a pair of the contact search.
TEST_F(StretchedBond, IsSteppedOnHoweverFarItsBlocksAre) {
  const Outcome outcome = run_scene(R"({"dda": 1, "gravity": 10,
 "materials": {"jelly": {"density": 2000, "young": 3e4, "poisson": 0}},
 "joints": {"default": {"friction_angle": "30 deg"}, "glue": {"bonded": true}},
 "blocks": [{"polygon": {"name": "roof", "vertices": [[0, 1], [1, 1], [1, 2], [0, 2]]}},
            {"polygon": {"name": "hung", "vertices": [[0, 0], [1, 0], [1, 1], [0, 1]]}},
            {"grid": {"name": "wall", "origin": [5, 0], "columns": 1, "rows": 2, "block_width": 1, "block_height": 1}}],
 "joint_pairs": [{"between": ["roof", "hung"], "joint": "glue"}],
 "fixed": ["roof", "wall 1.1"],
 "loads": [{"edge": {"from": [0, 0], "to": [1, 0]}, "block": "hung", "traction": [0, -60000]}],
 "steps": {"dt": 2e-3, "duration": 1}})",
                                    "out");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_FALSE(contains(outcome.errors, "BlockMatrix")) << outcome.errors;
  EXPECT_NE(nlohmann::json::parse(text("out/summary.json"))["status"], "ok");
}

}  // namespace
}  // namespace dda
