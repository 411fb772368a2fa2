#include "engine/advice/joint_remarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>

#include "engine/contact/make_contacts.h"
#include "engine/model/moving_stages.h"

namespace dda {
namespace {

using Remarks = std::vector<std::string>;

void remark_on_brittleness(const JointMaterial& joint, Remarks& remarks) {
  if (joint.cohesion == 0 || joint.residual_cohesion > 0) return;
  remarks.push_back(fmt::format(
      "joint \"{}\" is brittle: residual_cohesion is 0 or left out, so a contact that fails loses all of its {:g} Pa",
      joint.name, joint.cohesion));
}

// Coulomb's line of strength ends on the side of tension where it meets the axis, at cohesion / tan(friction angle).
void remark_on_apex(const JointMaterial& joint, Remarks& remarks) {
  constexpr double round_off = 1e-12;
  const double slope = std::tan(joint.friction_angle);
  if (joint.tensile_strength * slope <= joint.cohesion * (1 + round_off)) return;
  remarks.push_back(
      fmt::format("joint \"{}\": tensile_strength is {:g} Pa, but from cohesion / tan(friction_angle) = {:.3g} Pa of "
                  "tension on it has no shear strength, and the least shear breaks it",
                  joint.name, joint.tensile_strength, joint.cohesion / slope));
}

// A stiffness in GPa/m or MPa/mm that is read in Pa/m.
void remark_on_softness(const JointMaterial& joint, Remarks& remarks) {
  constexpr double softest = 1e5;  // Pa/m: joints filled with clay have 1e8
  if (joint.normal_stiffness == 0 || joint.normal_stiffness >= softest) return;
  remarks.push_back(fmt::format("joint \"{}\": normal_stiffness is {:g} Pa/m; joints of rock have 1e8 to 1e12 Pa/m",
                                joint.name, joint.normal_stiffness));
}

// Springs without shear stiffness never reach the strength at which a joint would slide or break.
void remark_on_shear(const JointMaterial& joint, Remarks& remarks) {
  const bool slides_freely = !joint.bonded && joint.friction_angle == 0 && joint.cohesion == 0;
  if (joint.shear_to_normal > 0 || joint.shear_stiffness > 0 || slides_freely) return;
  remarks.push_back(
      fmt::format("joint \"{}\": shear_to_normal is 0, so it never resists shear while it is elastic, and what it has "
                  "of friction or cohesion does not act then",
                  joint.name));
}

// Where a joint has a strength to lose, springs are meant for when it is lost.
void remark_on_springs_to_come(const JointMaterial& joint, Remarks& remarks) {
  const bool names_springs = joint.normal_spring > 0 || joint.spring_over_young != JointMaterial{}.spring_over_young;
  if (joint.bonded || !is_dry(joint) || !names_springs) return;
  remarks.push_back(fmt::format(
      "joint \"{}\": its springs act where it has slipped or opened, and not before: until then it passes on "
      "the stress of its blocks; with \"law\": \"classical\" they act from the start",
      joint.name));
}

struct Joints {
  std::set<std::size_t> all, with_springs;
};

void add_joints_in_use(const Model& model, const ContactSet& contacts, Joints& found) {
  const bool moves = has_finite_kinematics(model);
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    const auto joint = static_cast<std::size_t>(contacts.interfaces[i].joint);
    const InterfaceLaw law = contacts.elements.but_for_blocks(i).law;
    const bool has_springs = law == InterfaceLaw::classical || law == InterfaceLaw::projected;
    found.all.insert(joint);
    if (has_springs || (moves && is_dry(model.joints[joint]))) found.with_springs.insert(joint);
  }
}

// Those of blocks that are added later as well, as they are drawn.
Joints joints_in_use(const Model& model, const ContactSet& contacts) {
  Joints found;
  add_joints_in_use(model, contacts, found);
  if (model.adds_blocks()) add_joints_in_use(model, make_contacts(model), found);
  return found;
}

}  // namespace

std::vector<std::string> joint_remarks(const Model& model, const ContactSet& contacts) {
  const Joints in_use = joints_in_use(model, contacts);
  Remarks remarks;
  for (const std::size_t joint : in_use.with_springs) remark_on_shear(model.joints[joint], remarks);
  for (const std::size_t joint : in_use.all) {
    remark_on_softness(model.joints[joint], remarks);
    if (!in_use.with_springs.contains(joint)) remark_on_springs_to_come(model.joints[joint], remarks);
    if (model.joints[joint].bonded) continue;
    remark_on_brittleness(model.joints[joint], remarks);
    remark_on_apex(model.joints[joint], remarks);
  }
  return remarks;
}

}  // namespace dda
