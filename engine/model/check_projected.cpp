#include <fmt/format.h>

#include <cstddef>
#include <string>

#include "engine/model/check_parts.h"
#include "engine/model/checks.h"

namespace dda::model_checks {
namespace {

void check_law(const Item& item, const JointMaterial& joint) {
  if (joint.dilation_angle > 0) item.fail("law", "projected, with dilation", "a joint that does not dilate");
  if (joint.normal_stiffness > 0 && joint.shear_stiffness == 0 && joint.shear_to_normal == 0)
    item.fail("shear stiffness", "0", "a positive number with the projected law");
}

// Dashpots and the mean of what a bed answers on its way have no convex potential together that never pulls.
void check_stages_of(const Item& item, const Model& model, const JointMaterial& joint) {
  if (joint.contact_damping == 0) return;
  for (const Stage& stage : model.stages) {
    if (!with_contacts(stage.integrator).conserves_contact_energy) continue;
    item.fail(
        "law",
        fmt::format("projected, with contact damping and an integrator that damps nothing in stage \"{}\"", stage.name),
        "an integrator that damps, or the classical law");
  }
}

}  // namespace

void check_projected_joints(const Model& model) {
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    if (model.joints[i].law != InterfaceLaw::projected || model.joints[i].bonded) continue;  // never opens: linear
    const Item item("joints", i, model.joints[i].name);
    check_law(item, model.joints[i]);
    check_stages_of(item, model, model.joints[i]);
  }
}

}  // namespace dda::model_checks
