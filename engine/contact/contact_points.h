// Contacts as points with a force and a status, for display: an interface of some length is shown by its two ends, of
// which one may stand where it presses; together they carry its forces and its moment.
#pragma once

#include <vector>

#include "engine/contact/interface.h"
#include "engine/contact/interface_element.h"
#include "engine/contact/interface_state.h"
#include "engine/core/types.h"
#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

struct ContactPoint {
  int block_a = 0;
  int block_b = 0;
  Vec2 reference;           // m, the material point of block b
  Vec2 point;               // m, where that is now
  Vec2 normal;              // unit, from block a into block b
  double normal_force = 0;  // N per m of thickness, tension positive
  double shear_force = 0;   // the same, along the tangent (counter-clockwise from the normal)
  ContactStatus status = ContactStatus::open;

  // What block a exerts on block b, N per m of thickness.
  [[nodiscard]] Vec2 force() const { return -normal_force * normal - shear_force * Vec2(-normal.y(), normal.x()); }
};

// Appends the points of one interface: one when its vertex touches an edge, else two. `state` is that of the interface.
void append_contact_points(const Model& model, const State& blocks, const Interface& interface,
                           const InterfaceElement& element, const InterfaceState& state,
                           std::vector<ContactPoint>& points);

}  // namespace dda
