#include "engine/simulation/rock_of_stage.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "engine/contact/inherited_state.h"
#include "engine/contact/interface_element.h"
#include "engine/contact/interface_state.h"
#include "engine/contact/join_blocks.h"
#include "engine/contact/projected_law.h"
#include "engine/contact/renew_springs.h"
#include "engine/contact/tied_sides.h"
#include "engine/model/rock_change.h"
#include "engine/simulation/linear_states.h"

namespace dda {
namespace {

// What joints add to their blocks' strains goes by the moduli too.
void renew_all_strain_rows(BlockSystem& s) {
  const auto elasticity = [&s](int block) { return s.terms.elasticity[static_cast<std::size_t>(block)]; };
  for (InterfaceElement& element : s.contacts.elements.edit())
    renew_strain_rows(elasticity(element.block_a), elasticity(element.block_b), element);
}

// The joints whose springs, or the dashpots beside them, are others than they were; these go by masses too.
std::vector<bool> other_springs(const std::vector<JointMaterial>& before, bool has_other_materials,
                                const std::vector<JointMaterial>& now) {
  std::vector<bool> others(now.size());
  for (std::size_t i = 0; i < now.size(); ++i)
    others[i] = !have_same_springs(before[i], now[i]) || (has_other_materials && now[i].contact_damping > 0);
  return others;
}

// Returns by how much what they store has grown, J per m of thickness.
double change_springs(const std::vector<bool>& others, bool gaps_are_measured, BlockSystem& s) {
  double stored = 0;
  for (std::size_t i = 0; i < s.contacts.interfaces.size(); ++i) {
    if (!others[static_cast<std::size_t>(s.contacts.interfaces[i].joint)]) continue;
    InterfaceElement& element = s.contacts.elements.edit()[i];
    if (!can_open_or_slide(element)) continue;  // has no springs
    InterfaceState own = interface_state_now(s, i);
    stored -= interface_energy(element, own);
    renew_springs(s.model, s.state, s.contacts.interfaces[i], gaps_are_measured, element, own);
    stored += interface_energy(element, own);
    if (s.plan.linear) keep_gap_at_rest(s.state, element, own);
    s.contacts.states[i] = own;
  }
  return stored;
}

// What is no longer taken off the blocks, or more of it, acts on their strains.
void renew_internal_forces(const std::vector<Vec3>& outline_before, BlockSystem& s) {
  for (std::size_t i = 0; i < outline_before.size(); ++i)
    s.forces.internal_old.segment<3>(static_cast<Eigen::Index>(6 * i + 3)) -=
        s.terms.elasticity[i] * (s.contacts.outline_strain[i] - outline_before[i]);
}

}  // namespace

double renew_weights(BlockSystem& s) {
  if (s.contacts.outline_compliance.empty()) return 0;
  const double energy_before = outline_energy(s.contacts, s.state.stress);
  const std::vector<Vec3> outline_before = s.contacts.outline_strain;
  for (std::size_t i = 0; i < s.contacts.interfaces.size(); ++i) {
    InterfaceElement& element = s.contacts.elements.edit()[i];
    if (element.law != InterfaceLaw::projected) continue;
    set_weights(s.model, s.contacts.interfaces[i], element);
    element.beside_stress_a -= traction_when_joined(element, false);
    element.beside_stress_b -= traction_when_joined(element, true);
  }
  take_off_blocks(s.model, s.contacts);
  renew_internal_forces(outline_before, s);
  return energy_before - outline_energy(s.contacts, s.state.stress);
}

void renew_strengths(bool contacts_move, BlockSystem& s) {
  for (std::size_t i = 0; i < s.contacts.interfaces.size(); ++i) {
    const Interface& interface = s.contacts.interfaces[i];
    const JointMaterial& joint = s.model.joints[static_cast<std::size_t>(interface.joint)];
    s.contacts.strengths[i] = contacts_move && interface.length == 0
                                  ? strength_of_vertex(joint, interface.closed, s.contacts.states[i])
                                  : end_strength(joint, interface.length);
  }
}

void take_rock_in_force(BlockSystem& s) {
  const std::size_t stage = s.clock.in_force();
  if (changes_joints(s.model)) s.model.joints = joints_in(s.model, stage);
  if (!changes_materials(s.model)) return;
  s.model.materials = materials_in(s.model, stage);
  set_elasticity(s.model, s.terms);
  set_masses(s.model, s.excavated.absent, s.terms);
  s.external.weigh(s.model, s.excavated.absent);
  renew_all_strain_rows(s);
}

void change_rock(bool contacts_move, BlockSystem& s) {
  const RockOfStage& rock = s.stage().rock;
  if (s.clock.stage == 0 || (rock.joints.empty() && rock.materials.empty())) return;
  const double strain = strain_energy(s.terms, s.state), kinetic = kinetic_energy(s.terms, s.state);
  const std::vector<JointMaterial> joints_before = s.model.joints;
  const std::vector<Material> materials_before = s.model.materials;
  take_rock_in_force(s);
  if (!rock.joints.empty()) renew_strengths(contacts_move, s);
  double contact =
      change_springs(other_springs(joints_before, !rock.materials.empty(), s.model.joints), contacts_move, s);
  if (!rock.materials.empty()) contact += renew_weights(s);
  s.audit.rock_changed(kinetic_energy(s.terms, s.state) - kinetic, strain_energy(s.terms, s.state) - strain, contact);
  if (!std::ranges::equal(materials_before, s.model.materials, have_same_moduli)) sum_forces_of_states(s);
}

}  // namespace dda
