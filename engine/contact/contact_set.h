// All interfaces of a scene in contiguous arrays: constant description, element, strength and state of each.
#pragma once

#include <array>
#include <vector>

#include "engine/contact/interface.h"
#include "engine/contact/interface_element.h"
#include "engine/contact/interface_elements.h"
#include "engine/contact/interface_state.h"
#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

struct ContactSet {
  std::vector<Interface> interfaces;
  InterfaceElements elements;
  std::vector<EndStrength> strengths;
  std::vector<InterfaceState> states;
  bool can_change = false;  // some joint can open, slide or break
  // What projected stretches take off each block (TakenOff, projected_law.h); empty without any.
  std::vector<Mat3> outline_compliance;
  std::vector<Vec3> outline_strain;
  std::vector<double> outline_constant;

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [interfaces, elements, strengths, states, can_change, outline_compliance, outline_strain, outline_constant] =
        self;
    archive(interfaces, elements, strengths, states);
    archive.of_blocks(outline_compliance);
    archive.of_blocks(outline_strain);
    archive.of_blocks(outline_constant);
    // Whether something can change is the drawing's.
    archive.expect(elements.size() == interfaces.size() && strengths.size() == interfaces.size() &&
                   states.size() == interfaces.size() && outline_strain.size() == outline_compliance.size() &&
                   outline_constant.size() == outline_compliance.size());
  }
};

// The state of a bonded interface whose geometry stays, from the blocks' total displacements and current stresses
// instead of step by step; `gap_at_rest` is its gap at zero displacement.
InterfaceState linear_state(const InterfaceElement& element, const Vec4& gap_at_rest, const Vec6& displacement_a,
                            const Vec6& displacement_b, const Vec3& stress_a, const Vec3& stress_b);

// Normal and shear force of all ends together, of what `force` has for each row.
Vec2 carried_force(const InterfaceElement& element, const Vec4& force);

// Mean normal and shear traction over the interface, Pa, tension positive; the cubic law's normal value is the one its
// reconstruction has at the interface. Zero where blocks touch in a point.
Vec2 mean_traction(const Model& model, const Interface& interface, const InterfaceElement& element,
                   const InterfaceState& state);

// So many blocks of which nothing is taken off.
void take_off_nothing(std::size_t blocks, ContactSet& contacts);

// What projected stretches, with the normals that they have now, take off each of so many blocks.
void take_off_blocks(std::size_t blocks, ContactSet& contacts);

// Takes out the interfaces of blocks that are absent, `absent` saying so of each block. fit_to_neighbours() is to
// follow.
void leave_out(const std::vector<bool>& absent, ContactSet& contacts);

// Forces of interfaces that carry their blocks' stresses, anew after stresses or normals have turned.
void refresh_tractions(const State& state, ContactSet& contacts);

// Adds the internal forces of all interfaces to `force` (6 entries a block).
void add_contact_force(const ContactSet& contacts, Eigen::VectorXd& force);

// Adds the internal force of one interface that carries `interface_force` at `gap`.
void add_interface_force(const InterfaceElement& element, const Vec4& interface_force, const Vec4& gap,
                         Eigen::VectorXd& force);

// The change of the gaps by the displacement increments `d` (6 entries a block).
Vec4 gap_increment(const InterfaceElement& element, const Eigen::VectorXd& d);

// Stiffness of an interface whose rows with mask 0 carry no stiffness; `coupling` as in InterfaceTrial.
InterfaceMatrices stiffness_of(const InterfaceElement& element, const Vec4& mask, double coupling = 0);

// The part of a block's stiffness by strain, force by stress and strain energy that projected joints have taken over,
// to be taken off what the block has by itself.
Mat3 outline_stiffness(const ContactSet& contacts, std::size_t block, const Mat3& elasticity);
Vec3 outline_force(const ContactSet& contacts, std::size_t block, const Mat3& elasticity, const Vec3& stress);
double outline_energy(const ContactSet& contacts, const std::vector<Vec3>& stress);

// Elastic energy of the interface, J per m of thickness.
double interface_energy(const InterfaceElement& element, const InterfaceState& state);

}  // namespace dda
