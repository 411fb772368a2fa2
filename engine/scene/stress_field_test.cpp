// Remarks on the stress that the ground has before anything is done to it.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "engine/scene/scene_parts.h"

namespace dda {
namespace {

// Four blocks of 1 m on top of each other, from y = 0 up.
std::vector<std::string> remarks_on(const std::string& field, const std::string& more = "") {
  return parse_scene_parts(
             R"({"dda": 1, "materials": {"m": {"density": 1, "young": 1, "poisson": 0}}, "blocks": [{"grid":
    {"name": "wall", "columns": 1, "rows": 4, "block_width": 1, "block_height": 1}}], "steps": {"dt": 1, "duration": 1}, )" +
                 more + R"("stress_field": )" + field + "}",
             "scene.json")
      .remarks;
}

TEST(StressFieldRemarks, OnASurfaceBelowAllBlocks) {
  for (const char* field :
       {R"({"surface": -300, "gradient": 1})", R"({"surface": 0.4, "layers": [{"gradient": 1}]})"}) {
    const std::vector<std::string> remarks = remarks_on(field);
    ASSERT_EQ(remarks.size(), 1U) << field;
    EXPECT_NE(remarks[0].find("lies below the middles of all blocks"), std::string::npos);
  }
}

TEST(StressFieldRemarks, OnNoOther) {
  EXPECT_TRUE(remarks_on(R"({"surface": 300, "gradient": 1})").empty());
  EXPECT_TRUE(remarks_on(R"({"surface": 0.6, "gradient": 1})").empty());  // a hill
  EXPECT_TRUE(remarks_on(R"({"xx": 1})").empty());
  const std::string of_their_own = R"("initial_fields": [{"x": [0], "y": [0, 4], "stress_yy": [[-1], [-1]]}], )";
  EXPECT_TRUE(remarks_on(R"({"surface": -300, "gradient": 1})", of_their_own).empty());
}

}  // namespace
}  // namespace dda
