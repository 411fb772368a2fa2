// Presets: what a scene's joints and steps leave unsaid.
#pragma once

#include "engine/model/material.h"
#include "engine/model/settings.h"

namespace dda {

enum class SchemeName {
  accurate,  // cubic joints (consistent where they cannot be), generalized-alpha without its period error
  thesis,    // classical springs of 10 E and Eq. 5, as in Zelig (2015)
};

struct Scheme {
  SchemeName name = SchemeName::accurate;
};

// A joint that says nothing.
JointMaterial preset_joint(const Scheme& scheme);

// A stage that says nothing but its kinematics; `all_bonded`: no joint of the model can open or slide.
Stage preset_stage(const Scheme& scheme, Kinematics kinematics, bool all_bonded);

}  // namespace dda
