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
  constexpr std::array keys = {"law",           "penalty",           "stabilisation",
                               "normal_spring", "spring_over_young", "contact_damping"};
  return std::ranges::any_of(keys, [&](const char* key) { return joint.has(key); });
}

// A stiffness per area is what the joint itself gives way by, whatever the law.
bool has_stiffness_of_its_own(const JointMaterial& joint) { return joint.normal_stiffness > 0; }

// Only "auto" is a stiffness that is given and is none per area.
bool names_springs(const Field& given, const JointMaterial& joint) {
  return !has_stiffness_of_its_own(joint) && (given.has("normal_stiffness") || given.has("shear_to_normal"));
}

bool is_left_open(const Field& scene, const JointMaterial& joint) {
  const auto joints = scene.find("joints");
  if (!joints || !joints->has(joint.name)) return true;
  const Field given = joints->at(joint.name);
  return !names_law(given) && !names_springs(given, joint);
}

// A joint that has a stiffness of its own can have another one in a stage; no other projected joint has springs.
bool springs_suit(const JointMaterial& before, const JointMaterial& now) {
  const bool both_have_their_own = has_stiffness_of_its_own(before) && has_stiffness_of_its_own(now);
  return have_same_springs(before, now) || (both_have_their_own && now.contact_damping == before.contact_damping);
}

// What a projected joint takes off its blocks goes by their moduli at the start.
bool allow_the_law(const Model& model, std::size_t joint) {
  const auto keeps_moduli = [&](const Stage& stage) {
    return stage.rock.materials.empty() || std::ranges::equal(stage.rock.materials, model.materials, have_same_moduli);
  };
  const auto keeps_springs = [&](const Stage& stage) {
    return stage.rock.joints.empty() || springs_suit(model.joints[joint], stage.rock.joints[joint]);
  };
  return std::ranges::all_of(model.stages, keeps_moduli) && std::ranges::all_of(model.stages, keeps_springs);
}

// At once, or once they have broken. Joints of a thesis scene have its springs throughout.
bool would_be_springs(const JointMaterial& joint, const Scheme& scheme) {
  return scheme.name != SchemeName::thesis && !joint.bonded && joint.dilation_angle == 0;
}

// As if the scene had named it: springs that were chosen for when the joint has broken go with the law they were for.
void make_projected(JointMaterial& joint) {
  joint.law = InterfaceLaw::projected;
  joint.automatic_stiffness = false;
}

void make_projected(std::size_t joint, Model& model) {
  make_projected(model.joints[joint]);
  for (Stage& stage : model.stages)
    if (!stage.rock.joints.empty()) make_projected(stage.rock.joints[joint]);
}

}  // namespace

void choose_laws(const Field& scene, const Scheme& scheme, Model& model) {
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const JointMaterial& joint = model.joints[i];
    if (would_be_springs(joint, scheme) && is_left_open(scene, joint) && allow_the_law(model, i))
      make_projected(i, model);
  }
}

}  // namespace dda
