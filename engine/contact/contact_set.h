// All interfaces of a scene in contiguous arrays: constant description, element, strength and state of each.
#pragma once

#include <array>
#include <vector>

#include "engine/contact/interface.h"
#include "engine/contact/interface_element.h"
#include "engine/contact/interface_state.h"
#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

struct ContactSet {
  std::vector<Interface> interfaces;
  std::vector<InterfaceElement> elements;
  std::vector<EndStrength> strengths;
  std::vector<InterfaceState> states;
  bool can_change = false;  // some joint can open, slide or break
  // What projected stretches take off each block (traction_compliance), m3/N per m of thickness; empty without any.
  std::vector<Mat3> outline_compliance;

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [interfaces, elements, strengths, states, can_change, outline_compliance] = self;
    archive(interfaces, elements, strengths, states);
    archive.of_blocks(outline_compliance);
    // Whether something can change is the drawing's.
    archive.expect(elements.size() == interfaces.size() && strengths.size() == interfaces.size() &&
                   states.size() == interfaces.size());
  }
};

// Cubic joints become consistent ones unless all joints are bonded, all stages have small kinematics, no block is ever
// removed, no material changes and there are no bolts: only then is the inertia between blocks constant.
ContactSet make_contacts(const Model& model);

// Normal and shear force at either end of an interface under the mean of its blocks' initial stresses, as far as a dry
// joint carries them. Springs carry these from the start.
Vec4 in_situ_force(const Model& model, const Interface& interface);

// The state of a bonded interface whose geometry stays, from the blocks' total displacements and current stresses
// instead of step by step; `gap_at_rest` is its gap at zero displacement.
InterfaceState linear_state(const InterfaceElement& element, const Vec4& gap_at_rest, const Vec6& displacement_a,
                            const Vec6& displacement_b, const Vec3& stress_a, const Vec3& stress_b);

// Mean normal and shear traction over the interface, Pa, tension positive; the cubic law's normal value is the one its
// reconstruction has at the interface. Zero where blocks touch in a point.
Vec2 mean_traction(const Model& model, const Interface& interface, const InterfaceElement& element,
                   const InterfaceState& state);

// What follows from all interfaces of a block together: rows of blocks that bend, and what projected stretches take off
// their blocks. Anew whenever interfaces have been left out.
void fit_to_neighbours(const Model& model, ContactSet& contacts);

// The latter alone: what projected stretches, with the normals that they have now, take off each of so many blocks.
void take_off_blocks(std::size_t blocks, ContactSet& contacts);

// Takes out the interfaces of blocks that are absent, `absent` saying so of each block. fit_to_neighbours() is to
// follow.
void leave_out(const std::vector<bool>& absent, ContactSet& contacts);

// Where an interface is now: its ends follow their blocks, its normal turns with the mean of the two edges.
InterfaceFrame current_frame(const Model& model, const State& state, const Interface& interface);

// How far block b has gone from block a at the ends of a stretch: along its normal and its tangent, m.
struct EndsApart {
  Vec2 from, to;
};
EndsApart ends_apart(const Model& model, const State& state, const Interface& interface);

// The gap of a consistent interface follows from where its blocks are and not from the way there, or rock that was
// deformed and is left alone would keep stresses. Increments along rows that turn would miss a share of it, the strain
// of the blocks times the gap. So does that of a projected one (projected_stretch.h). For an element whose rows are
// those of now.
void measure_gap(const Model& model, const State& state, const Interface& interface, const InterfaceElement& element,
                 InterfaceState& own);

// The same for the forces of a stretch. Those of consistent and projected joints act on both blocks halfway between
// them, so that they have no moment together, and a rotation of both blocks that leaves their gap as it is changes no
// row of it. Springs act on each block where they are tied to it.
InterfaceFrame acting_frame(const Model& model, const State& state, const Interface& interface, InterfaceLaw law);

// Finite kinematics: moves the elements to where forces act, the geometry of `acting`, and measures the gaps of
// consistent and projected interfaces in `state`.
void update_geometry(const Model& model, const State& state, const State& acting, ContactSet& contacts);

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
