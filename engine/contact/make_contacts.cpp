#include "engine/contact/make_contacts.h"

#include <cstddef>
#include <vector>

#include "engine/contact/cubic_law.h"
#include "engine/contact/in_situ_force.h"
#include "engine/contact/make_element.h"
#include "engine/contact/row_bending.h"
#include "engine/contact/tied_sides.h"

namespace dda {
namespace {

InterfaceLaw usable_law(const Model& model, const Interface& interface, bool can_be_cubic) {
  const InterfaceLaw wanted = model.joints[static_cast<std::size_t>(interface.joint)].law;
  if (interface.length == 0) return InterfaceLaw::classical;
  const bool both_held = model.is_held(interface.block_a) && model.is_held(interface.block_b);
  if (wanted == InterfaceLaw::projected && both_held) return InterfaceLaw::classical;
  return wanted == InterfaceLaw::cubic && !can_be_cubic ? InterfaceLaw::consistent : wanted;
}

// What is dry has no bond to lose, so that it opens in stages of unlimited strength, and dashpots act beside its
// springs.
bool answers_as_broken(const InterfaceElement& element, const JointMaterial& joint) {
  const bool by_ends = element.law == InterfaceLaw::projected || element.law == InterfaceLaw::classical;
  return by_ends && is_dry(joint);
}

}  // namespace

ContactSet make_contacts(const Model& model) {
  ContactSet contacts;
  contacts.interfaces = find_interfaces(model);
  contacts.states.resize(contacts.interfaces.size());
  std::vector<InterfaceElement>& elements = contacts.elements.edit();
  elements.reserve(contacts.interfaces.size());  // a kilobyte each
  contacts.strengths.reserve(contacts.interfaces.size());
  const std::vector<bool> cubic = cubic_candidates(model, contacts.interfaces);
  const bool cubic_allowed =
      model.stays_linear() && !model.removes_blocks() && !model.adds_blocks() && !changes_materials(model);
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    const Interface& interface = contacts.interfaces[i];
    const JointMaterial& joint = model.joints[static_cast<std::size_t>(interface.joint)];
    InterfaceElement element = make_element(model, interface, usable_law(model, interface, cubic_allowed && cubic[i]));
    set_geometry(model, reference_frame(model, interface), element);
    const Vec3& stress_a = model.blocks[static_cast<std::size_t>(interface.block_a)].initial_stress;
    const Vec3& stress_b = model.blocks[static_cast<std::size_t>(interface.block_b)].initial_stress;
    elements.push_back(element);
    contacts.strengths.push_back(end_strength(joint, interface.length));
    if (has_stress_rows(element)) {
      contacts.states[i].force = elastic_force(element, contacts.states[i].gap, stress_a, stress_b);
    } else {
      contacts.states[i].force = in_situ_force(model, interface);
      for (Eigen::Index row = 0; row < 4; ++row)
        contacts.states[i].gap(row) = elastic_gap(contacts.states[i].force(row), element.stiffness(row), 0);
    }
    if (answers_as_broken(element, joint)) contacts.states[i].broken = {true, true};
    contacts.can_change = contacts.can_change || !joint.bonded;
  }
  fit_to_neighbours(model, contacts);
  return contacts;
}

void fit_to_neighbours(const Model& model, ContactSet& contacts) {
  stiffen_rows(model, contacts);
  take_off_blocks(model, contacts);
}

}  // namespace dda
