#include "engine/scene/choose_laws.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "engine/model/moving_stages.h"
#include "engine/model/rock_change.h"

namespace dda {
namespace {

// Whoever gives one of these has a law in mind.
bool names_law(const Field& joint) {
  constexpr std::array keys = {"law",
                               "penalty",
                               "stabilisation",
                               "normal_spring",
                               "spring_over_young",
                               "shear_to_normal",
                               "normal_stiffness",
                               "shear_stiffness",
                               "contact_damping"};
  return std::ranges::any_of(keys, [&](const char* key) { return joint.has(key); });
}

bool is_left_open(const Field& scene, const JointMaterial& joint) {
  const auto joints = scene.find("joints");
  return !joints || !joints->has(joint.name) || !names_law(joints->at(joint.name));
}

// What a projected joint takes off its blocks goes by their moduli at the start, and it has no springs that could
// change.
bool allow_the_law(const Model& model, std::size_t joint) {
  const auto keeps_moduli = [&](const Stage& stage) {
    return stage.rock.materials.empty() || std::ranges::equal(stage.rock.materials, model.materials, have_same_moduli);
  };
  const auto keeps_springs = [&](const Stage& stage) {
    return stage.rock.joints.empty() || have_same_springs(stage.rock.joints[joint], model.joints[joint]);
  };
  return std::ranges::all_of(model.stages, keeps_moduli) && std::ranges::all_of(model.stages, keeps_springs);
}

void make_projected(std::size_t joint, Model& model) {
  model.joints[joint].law = InterfaceLaw::projected;
  for (Stage& stage : model.stages)
    if (!stage.rock.joints.empty()) stage.rock.joints[joint].law = InterfaceLaw::projected;
}

}  // namespace

void choose_laws(const Field& scene, Model& model) {
  if (!has_finite_kinematics(model)) return;
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const JointMaterial& joint = model.joints[i];
    const bool would_be_springs = joint.law != InterfaceLaw::classical && is_dry(joint) && joint.dilation_angle == 0;
    if (would_be_springs && is_left_open(scene, joint) && allow_the_law(model, i)) make_projected(i, model);
  }
}

}  // namespace dda
