// Which law joints have for which a scene names none.
#include <gtest/gtest.h>

#include <string>

#include "engine/scene/scene.h"

namespace dda {
namespace {

Model squares(const std::string& joints, const std::string& steps, const std::string& more = "") {
  return parse_scene(R"({"dda": 1, "materials": {"rock": {"density": 2600, "young": 1e10, "poisson": 0.2}}, )" + more +
                         R"("joints": {)" + joints +
                         R"(}, "blocks": [{"grid": {"columns": 2, "rows": 2, "block_width": 1, "block_height": 1}}],
      "steps": [)" + steps +
                         "]}",
                     "scene.json");
}

const std::string moving = R"({"dt": 1e-3, "duration": 1})";
const std::string as_drawn = R"({"dt": 1e-3, "duration": 1, "kinematics": "small"})";

InterfaceLaw law_of(const std::string& joint, const std::string& steps = moving, const std::string& more = "") {
  return squares("\"default\": {" + joint + "}", steps, more).joints[0].law;
}

TEST(ChooseLaws, DryJointsThatNameNoLawAreProjected) {
  EXPECT_EQ(law_of(""), InterfaceLaw::projected);
  EXPECT_EQ(law_of(R"("friction_angle": 0.5, "residual_friction_angle": 0.4)"), InterfaceLaw::projected);
  EXPECT_EQ(law_of("", as_drawn + ", " + moving), InterfaceLaw::projected);
  EXPECT_EQ(law_of("", R"({"integrator": "trapezoidal", "dt": 1e-3, "duration": 1})"), InterfaceLaw::projected);
  EXPECT_EQ(law_of("", as_drawn), InterfaceLaw::projected);
}

// They break where beams and limit equilibrium say, which joints of other laws do not, and pass waves on as well.
TEST(ChooseLaws, JointsWithStrengthThatNameNoLawAreProjected) {
  for (const char* joint :
       {R"("cohesion": 1e5)", R"("tensile_strength": 1e5)", R"("normal_stiffness": 1e11, "cohesion": 1e5)"}) {
    EXPECT_EQ(law_of(joint), InterfaceLaw::projected) << joint;
    EXPECT_EQ(law_of(joint, as_drawn), InterfaceLaw::projected) << joint;
    EXPECT_EQ(law_of(joint, moving, R"("scheme": "thesis", )"), InterfaceLaw::classical) << joint;
  }
  for (const std::string& steps : {moving, as_drawn}) {
    const Model left_open = squares(R"("default": {"cohesion": 1e5})", steps);
    const Model named = squares(R"("default": {"cohesion": 1e5, "law": "projected"})", steps);
    EXPECT_EQ(left_open.joints[0].automatic_stiffness, named.joints[0].automatic_stiffness);
  }
}

TEST(ChooseLaws, WhatNamesALawOrSpringsKeepsItsOwn) {
  for (const char* joint :
       {R"("bonded": true)", R"("law": "classical")", R"("law": "consistent", "cohesion": 1e5)",
        R"("law": "consistent")", R"("normal_stiffness": "auto")", R"("normal_stiffness": "auto", "cohesion": 1e5)",
        R"("cohesion": 1e5, "spring_over_young": 10)", R"("normal_stiffness": 1e11, "contact_damping": 0.2)",
        R"("normal_spring": 1e10)", R"("spring_over_young": 10)", R"("shear_to_normal": 0.4)",
        R"("contact_damping": 0.2)", R"("penalty": 4)", R"("stabilisation": 0.1)",
        R"("friction_angle": 0.5, "dilation_angle": 0.1)"})
    EXPECT_NE(law_of(joint), InterfaceLaw::projected) << joint;
  EXPECT_EQ(law_of("", moving, R"("scheme": "thesis", )"), InterfaceLaw::classical);
}

// Dashpots are for impacts on springs. Where nothing moves from where it was drawn there are none, and joints of the
// other law got springs as they slipped, with 5 % of the energy of their blocks from nowhere.
TEST(ChooseLaws, DashpotsAskForSpringsWhereBlocksMove) {
  const std::string damped = R"("friction_angle": 0.5, "contact_damping": 0.2)";
  EXPECT_EQ(law_of(damped, as_drawn), InterfaceLaw::projected);
  EXPECT_NE(law_of(damped, moving), InterfaceLaw::projected);
  EXPECT_NE(law_of(damped, as_drawn + ", " + moving), InterfaceLaw::projected);
  EXPECT_NE(law_of(damped, R"({"integrator": "trapezoidal", "dt": 1e-3, "duration": 1, "kinematics": "small"})"),
            InterfaceLaw::projected);
}

TEST(ChooseLaws, DryJointsThatPassStressOnGetStiffSpringsAsTheySlip) {
  const auto are_chosen = [](const std::string& joint, const std::string& steps) {
    return squares("\"default\": {" + joint + "}", steps).joints[0].automatic_stiffness;
  };
  EXPECT_TRUE(are_chosen(R"("law": "consistent")", as_drawn));
  EXPECT_FALSE(are_chosen(R"("law": "consistent", "spring_over_young": 10)", as_drawn));
  EXPECT_TRUE(are_chosen(R"("penalty": 4)", as_drawn));  // of the scheme's law
  EXPECT_FALSE(are_chosen(R"("law": "consistent", "normal_spring": 1e10)", as_drawn));
  EXPECT_FALSE(are_chosen(R"("law": "consistent")", moving));  // springs from the start, as documented
  EXPECT_FALSE(are_chosen(R"("law": "classical")", as_drawn));
  EXPECT_FALSE(are_chosen(R"("bonded": true)", as_drawn));
  // Springs that a stage names would not act beside chosen ones.
  EXPECT_FALSE(are_chosen(R"("law": "consistent")", as_drawn + R"(, {"dt": 1e-3, "duration": 1, "kinematics": "small",
                                         "joints": {"default": {"spring_over_young": 20}}})"));
}

// It is what the joint gives way by, and no choice of springs; the law has it in series with that of the blocks.
TEST(ChooseLaws, StiffnessPerAreaNamesNoLaw) {
  EXPECT_EQ(law_of(R"("normal_stiffness": 1e11)"), InterfaceLaw::projected);
  EXPECT_EQ(law_of(R"("normal_stiffness": 1e11, "shear_stiffness": 1e10)"), InterfaceLaw::projected);
  EXPECT_EQ(law_of(R"("normal_stiffness": 1e11, "shear_to_normal": 0.2)"), InterfaceLaw::projected);
  EXPECT_EQ(law_of(R"("normal_stiffness": 1e11)", as_drawn), InterfaceLaw::projected);
  EXPECT_EQ(law_of(R"("normal_stiffness": 1e11)", moving, R"("scheme": "thesis", )"), InterfaceLaw::classical);
}

// Stages can change it, but not for springs or dashpots.
TEST(ChooseLaws, StagesMayChangeAStiffnessPerArea) {
  const auto then = [](const std::string& change) {
    return law_of(
        R"("normal_stiffness": 1e11)",
        R"({"name": "first", "dt": 1e-3, "duration": 1}, {"dt": 1e-3, "duration": 1, "joints": {"default": {)" +
            change + "}}}");
  };
  EXPECT_EQ(then(R"("normal_stiffness": 5e10)"), InterfaceLaw::projected);
  EXPECT_EQ(then(R"("shear_stiffness": 5e10)"), InterfaceLaw::projected);
  EXPECT_EQ(then(R"("normal_stiffness": "auto")"), InterfaceLaw::classical);
  EXPECT_EQ(then(R"("contact_damping": 0.1)"), InterfaceLaw::classical);
}

// A stage that changes what the law cannot: moduli, or springs that it does not have.
TEST(ChooseLaws, StagesThatChangeModuliOrSpringsHaveSprings) {
  const auto then = [](const std::string& change) {
    return law_of("", R"({"name": "first", "dt": 1e-3, "duration": 1}, {"dt": 1e-3, "duration": 1, )" + change + "}");
  };
  EXPECT_NE(then(R"("materials": {"rock": {"young": 8e9}})"), InterfaceLaw::projected);
  EXPECT_NE(then(R"("joints": {"default": {"spring_over_young": 5}})"), InterfaceLaw::projected);
  EXPECT_EQ(then(R"("materials": {"rock": {"density": 2700}})"), InterfaceLaw::projected);
  EXPECT_EQ(then(R"("joints": {"default": {"friction_angle": 0.3}})"), InterfaceLaw::projected);
}

TEST(ChooseLaws, StagesMayChangeAStrength) {
  EXPECT_EQ(law_of(R"("cohesion": 1e5, "tensile_strength": 1e4)",
                   R"({"name": "first", "dt": 1e-3, "duration": 1}, {"dt": 1e-3, "duration": 1,
                       "joints": {"default": {"cohesion": 5e4}}})"),
            InterfaceLaw::projected);
}

TEST(ChooseLaws, EachJointHasItsOwn) {
  const Model model = squares(R"("default": {}, "weak": {"law": "classical"})", moving,
                              R"("joint_lines": [{"points": [[0, 1], [2, 1]], "joint": "weak"}], )");
  EXPECT_EQ(model.joints[0].law, InterfaceLaw::projected);
  EXPECT_EQ(model.joints[1].law, InterfaceLaw::classical);
}

}  // namespace
}  // namespace dda
