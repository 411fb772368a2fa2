#include "engine/advice/rebound_remarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <limits>

#include "engine/model/material.h"

namespace dda {
namespace {

// A square block of Young's modulus E on the two springs of its face gives way as these do where each is E/2. Of flat
// drops with a contact_damping of 1 blocks on springs of 0.1 E kept 0.09 to 0.4 of their speed, of 0.3 E 0.2 to 0.6, of
// E 0.45 to 0.67, and no other damping got less of the last (docs/scene.md).
constexpr double stiffest = 0.5;  // of Young's modulus

double softest_young(const Model& model) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < model.blocks.size(); ++i)
    if (!model.is_held(static_cast<int>(i))) least = std::min(least, model.material_of(static_cast<int>(i)).young);
  return least;
}

// Springs that are chosen for each contact are those of the stiffest sort. A stiffness per area goes by lengths, which
// those who give one know.
bool is_too_stiff(const JointMaterial& joint, double young) {
  if (joint.normal_stiffness > 0) return false;
  if (joint.automatic_stiffness || joint.law != InterfaceLaw::classical) return true;
  if (joint.normal_spring > 0) return joint.normal_spring > stiffest * young;
  return joint.spring_over_young == 0 || joint.spring_over_young > stiffest;
}

// Static stages damp all, and in small kinematics only what touches as drawn can meet.
bool can_bounce(const Model& model) {
  return std::ranges::any_of(model.stages, [](const Stage& stage) {
    return !stage.integrator.is_static && stage.kinematics == Kinematics::finite;
  });
}

bool something_flies(const Model& model, const ContactSet& contacts) {
  std::vector<bool> touches(model.blocks.size(), false);
  for (const Interface& interface : contacts.interfaces)
    touches[static_cast<std::size_t>(interface.block_a)] = touches[static_cast<std::size_t>(interface.block_b)] = true;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const bool is_free = !model.is_held(static_cast<int>(i));
    const bool falls = !touches[i] && !model.gravity.isZero(0);
    if (is_free && (falls || !model.blocks[i].starts_at_rest())) return true;
  }
  return false;
}

}  // namespace

std::vector<std::string> rebound_remarks(const Model& model, const ContactSet& contacts) {
  std::vector<std::string> remarks;
  if (!can_bounce(model) || !something_flies(model, contacts)) return remarks;
  const double young = softest_young(model);
  for (const JointMaterial& joint : model.joints) {
    if (joint.bonded || joint.contact_damping == 0 || !is_too_stiff(joint, young)) continue;
    remarks.push_back(fmt::format(
        "joint \"{}\": its contact_damping of {:g} does not set how blocks rebound, as they are softer than its "
        "springs: they keep 0.5 to 0.9 of their speed whatever it is; for an inelastic impact take \"law\": "
        "\"classical\", a "
        "normal_spring of {:.2g} N/m (a tenth of young) and a contact_damping of 1",
        joint.name, joint.contact_damping, 0.1 * young));
  }
  return remarks;
}

}  // namespace dda
