// Loads of a scene that stay square to their faces.
#include <gtest/gtest.h>

#include <string>

#include "engine/core/error.h"
#include "engine/scene/scene.h"

namespace dda {
namespace {

// A block under this load, in two stages, the first of which has small kinematics.
Model loaded(const std::string& load) {
  return parse_scene(R"({"dda": 1, "materials": {"rock": {"density": 2650, "young": 5e10, "poisson": 0.25}},
    "blocks": {"polygon": {"vertices": [[0, 0], [2, 0], [2, 1], [0, 1]]}}, "loads": [)" +
                         load + R"(],
    "steps": [{"name": "rest", "dt": 1e-3, "duration": 1e-2, "kinematics": "small"},
              {"name": "flight", "dt": 1e-3, "duration": 1e-2}]})",
                     "scene.json");
}

std::string refusal_of(const std::string& load) {
  try {
    (void)loaded(load);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Loads, PressureFollowsFacesWhereItIsAsked) {
  EXPECT_FALSE(loaded(R"({"edge": "left", "pressure": 1e5})").edge_loads.at(0).follows);
  EXPECT_FALSE(loaded(R"({"edge": "left", "pressure": 1e5, "follows": false})").edge_loads.at(0).follows);
  const Model model = loaded(R"({"edge": "left", "pressure": {"surface": 1, "gradient": 1e4}, "follows": true})");
  ASSERT_EQ(model.edge_loads.size(), 1U);
  EXPECT_TRUE(model.edge_loads[0].follows);
  EXPECT_EQ(model.edge_loads[0].traction, Vec2(5e3, 0));
  EXPECT_NEAR(model.edge_loads[0].rise.norm(), 5e3, 1e-9);
}

TEST(Loads, NothingElseFollowsFaces) {
  EXPECT_EQ(refusal_of(R"({"edge": "left", "pressure": 1, "follows": true, "from_stage": "flight"})"), "accepted");
  for (const char* load : {R"({"edge": "left", "traction": [1, 0], "follows": true})",
                           R"({"edge": "left", "force": [1, 0], "follows": true})",
                           R"({"point": [0, 0.5], "force": [1, 0], "follows": true})",
                           R"({"edge": "left", "pressure": 1, "follows": true, "until_stage": "rest"})"}) {
    const std::string sentence = refusal_of(load);
    EXPECT_NE(sentence.find("loads[0].follows is true"), std::string::npos) << sentence;
  }
  EXPECT_NE(
      refusal_of(R"({"edge": "left", "pressure": 1, "follows": true, "until_stage": "rest"})").find("small kinematics"),
      std::string::npos);
}

}  // namespace
}  // namespace dda
