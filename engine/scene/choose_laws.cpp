#include "engine/scene/choose_laws.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>

#include "engine/model/moving_stages.h"
#include "engine/model/rock_change.h"

namespace dda {
namespace {

bool has_any(const Field& joint, std::initializer_list<const char*> keys) {
  return std::ranges::any_of(keys, [&](const char* key) { return joint.has(key); });
}

// Whoever gives one of these has a law in mind.
bool names_law(const Field& joint) {
  return has_any(joint, {"law", "penalty", "stabilisation", "normal_spring", "spring_over_young"});
}

// Dashpots are given for impacts, which springs answer as documented. Where nothing moves from where it was drawn
// blocks hit nothing, and without springs from the start the other law would have joints that get them as they slip.
bool dashpots_ask_for_springs(const Model& model) {
  return has_finite_kinematics(model) || std::ranges::any_of(model.stages, [](const Stage& stage) {
           return with_contacts(stage.integrator).conserves_contact_energy;
         });
}

// A stiffness per area is what the joint itself gives way by, whatever the law.
bool has_stiffness_of_its_own(const JointMaterial& joint) { return joint.normal_stiffness > 0; }

// Only "auto" is a stiffness that is given and is none per area.
bool names_springs(const Field& given, const JointMaterial& joint) {
  return !has_stiffness_of_its_own(joint) && (given.has("normal_stiffness") || given.has("shear_to_normal"));
}

bool is_left_open(const Field& scene, const Model& model, const JointMaterial& joint) {
  if (joint.contact_damping > 0 && dashpots_ask_for_springs(model)) return false;
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

bool stages_keep_springs(const Model& model, std::size_t joint,
                         bool (*suit)(const JointMaterial& before, const JointMaterial& now)) {
  return std::ranges::all_of(model.stages, [&](const Stage& stage) {
    return stage.rock.joints.empty() || suit(model.joints[joint], stage.rock.joints[joint]);
  });
}

// What a projected joint takes off its blocks goes by their moduli at the start.
bool allow_the_law(const Model& model, std::size_t joint) {
  const auto keeps_moduli = [&](const Stage& stage) {
    return stage.rock.materials.empty() || std::ranges::equal(stage.rock.materials, model.materials, have_same_moduli);
  };
  return std::ranges::all_of(model.stages, keeps_moduli) && stages_keep_springs(model, joint, springs_suit);
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

// In the model and in stages that change joints.
void everywhere(Model& model, std::size_t joint, void (*make)(JointMaterial&)) {
  make(model.joints[joint]);
  for (Stage& stage : model.stages)
    if (!stage.rock.joints.empty()) make(stage.rock.joints[joint]);
}

// A dry joint that passes the stress of its blocks on gets springs as it slips, with the whole of its force, and what
// these store of it nothing has brought: 5 % of what its blocks store with springs of ten times Young's modulus. (One
// with strength has them when it is read; whether dry ones have springs from the start the stages tell.)
bool gets_springs_as_it_slips(const Field& scene, const Model& model, std::size_t index) {
  const JointMaterial& joint = model.joints[index];
  if (has_finite_kinematics(model) || joint.bonded || !passes_stress(joint.law)) return false;
  if (!stages_keep_springs(model, index, have_same_springs)) return false;
  const auto joints = scene.find("joints");
  return !joints || !joints->has(joint.name) ||
         !has_any(joints->at(joint.name), {"normal_spring", "spring_over_young"});
}

}  // namespace

void choose_laws(const Field& scene, const Scheme& scheme, Model& model) {
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const JointMaterial& joint = model.joints[i];
    if (would_be_springs(joint, scheme) && is_left_open(scene, model, joint) && allow_the_law(model, i))
      everywhere(model, i, make_projected);
    if (gets_springs_as_it_slips(scene, model, i))
      everywhere(model, i, [](JointMaterial& each) { each.automatic_stiffness = true; });
  }
}

}  // namespace dda
