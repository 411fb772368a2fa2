#include "engine/simulation/rock_of_stage.h"

#include <cstddef>

#include "engine/contact/interface_element.h"
#include "engine/contact/interface_state.h"
#include "engine/model/rock_change.h"

namespace dda {
namespace {

// What joints add to their blocks' strains goes by the moduli too.
void renew_strain_rows(BlockSystem& s) {
  const auto elasticity = [&s](int block) { return s.terms.elasticity[static_cast<std::size_t>(block)]; };
  for (InterfaceElement& element : s.contacts.elements) {
    if (!has_stress_rows(element)) continue;
    element.strain_rows_a = element.stress_rows_a * elasticity(element.block_a);
    element.strain_rows_b = element.stress_rows_b * elasticity(element.block_b);
  }
}

}  // namespace

void renew_strengths(bool contacts_move, BlockSystem& s) {
  for (std::size_t i = 0; i < s.contacts.interfaces.size(); ++i) {
    const Interface& interface = s.contacts.interfaces[i];
    const JointMaterial& joint = s.model.joints[static_cast<std::size_t>(interface.joint)];
    s.contacts.strengths[i] = contacts_move && interface.length == 0 ? unbonded_strength(joint, interface.share)
                                                                     : end_strength(joint, interface.length);
  }
}

void take_rock_in_force(BlockSystem& s) {
  const std::size_t stage = s.clock.in_force();
  if (changes_joints(s.model)) s.model.joints = joints_in(s.model, stage);
  if (!changes_materials(s.model)) return;
  s.model.materials = materials_in(s.model, stage);
  set_elasticity(s.model, s.terms);
  renew_strain_rows(s);
}

void change_rock(bool contacts_move, BlockSystem& s) {
  const RockOfStage& rock = s.stage().rock;
  if (s.clock.stage == 0 || (rock.joints.empty() && rock.materials.empty())) return;
  const double strain = strain_energy(s.terms, s.state);
  take_rock_in_force(s);
  if (!rock.joints.empty()) renew_strengths(contacts_move, s);
  if (rock.materials.empty()) return;
  s.audit.elasticity_changed(strain_energy(s.terms, s.state) - strain);
  if (!s.plan.linear) s.sum_internal_forces(s.forces.internal_old);
}

}  // namespace dda
