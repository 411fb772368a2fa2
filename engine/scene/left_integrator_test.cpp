// Which stages of a scene leave their integrator to the engine. What it then chooses: integrator_choice_test.
#include <gtest/gtest.h>

#include <string>

#include "engine/scene/scene.h"

namespace dda {
namespace {

bool is_left(const std::string& integrator, const std::string& scheme = "accurate") {
  const std::string scene = R"({"dda": 1, "materials": {"rock": {"density": 2500, "young": "40 GPa", "poisson": 0.25}},
    "blocks": {"bar": {"length": 4, "height": 1, "block_length": 2}}, "scheme": ")" +
                            scheme + R"(", "steps": {"dt": 1e-4, "duration": 0.01)" + integrator + "}}";
  return parse_scene(scene, "scene.json").stages[0].chosen.integrator.automatic;
}

TEST(LeftIntegrator, IsOneThatIsNotNamed) {
  EXPECT_TRUE(is_left(""));
  EXPECT_TRUE(is_left(R"(, "integrator": "auto")"));
  EXPECT_FALSE(is_left(R"(, "integrator": {"generalized_alpha": 0.85})"));
  EXPECT_FALSE(is_left(R"(, "integrator": "trapezoidal")"));
  EXPECT_FALSE(is_left(R"(, "integrator": "static")"));
}

TEST(LeftIntegrator, IsNoneInTheSchemeOfTheThesis) {
  EXPECT_FALSE(is_left("", "thesis"));
  EXPECT_FALSE(is_left(R"(, "integrator": "auto")", "thesis"));
}

}  // namespace
}  // namespace dda
