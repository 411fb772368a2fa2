// What a scene says of joints with the projected law, as docs/scene.md has it.
#include <gtest/gtest.h>

#include <string>

#include "engine/core/error.h"
#include "engine/scene/scene.h"

namespace dda {
namespace {

// A block on a base, with these entries beside the law of the joint between them, stepped as `step` says.
Model resting(const std::string& joint, const std::string& step) {
  return parse_scene(R"({"dda": 1, "materials": {"rock": {"density": 2650, "young": 5e10, "poisson": 0.25}},
    "joints": {"default": {"law": "projected", "friction_angle": "35 deg", )" +
                         joint + R"(}},
    "blocks": [{"polygon": {"name": "base", "vertices": [[0, 0], [2, 0], [2, 1], [0, 1]]}},
               {"polygon": {"vertices": [[0, 1], [2, 1], [2, 2], [0, 2]]}}],
    "fixed": ["base"], "steps": {"dt": 1e-3, "duration": 1e-2, )" +
                         step + "}}",
                     "scene.json");
}

TEST(ProjectedJointScene, TakesDashpots) {
  for (const std::string kinematics : {"small", "finite"}) {
    const Model model = resting(R"("contact_damping": 0.3)", R"("kinematics": ")" + kinematics + '"');
    EXPECT_EQ(model.joints[0].law, InterfaceLaw::projected);
    EXPECT_EQ(model.joints[0].contact_damping, 0.3);
  }
}

TEST(ProjectedJointScene, TakesNoDashpotsBesideIntegratorsThatDampNothing) {
  const std::string conserving = R"("kinematics": "small", "integrator": "energy_conserving")";
  EXPECT_NO_THROW((void)resting(R"("contact_damping": 0)", conserving));
  try {
    (void)resting(R"("contact_damping": 0.3)", conserving);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("contact damping"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace dda
