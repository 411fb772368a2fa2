// What the stiffness of joints does to the result, before anything is run.
#pragma once

#include <optional>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/contact/joint_stiffness.h"
#include "engine/model/model.h"

namespace dda {

// Over all drawn stretches of a joint that give way by springs, or by a stiffness of the joint's own.
struct JointSurvey {
  double softest = 0, stiffest = 0;  // normal stiffness per area, Pa/m
  StiffnessErrors worst;
};

// One entry a joint; none where it has no such stretch: springs follow the classical law, and finite kinematics where
// blocks are neither bonded nor joined with cohesion or tensile strength; a projected joint has a stiffness of its own
// where it was given one.
std::vector<std::optional<JointSurvey>> survey_joints(const Model& model);

// The penalty of a projected joint, over all of its drawn stretches.
struct PenaltySurvey {
  double least = 0, most = 0;        // of the blocks beside it, in units of plane modulus over width
  double softest = 0, stiffest = 0;  // normal stiffness of its contacts per area, Pa/m
};

// One entry a joint; none where it has no stretch of the projected law.
std::vector<std::optional<PenaltySurvey>> survey_penalties(const Model& model, const ContactSet& contacts);

}  // namespace dda
