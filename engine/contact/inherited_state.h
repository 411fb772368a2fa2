// With which state a vertex contact goes on after a search, so that no choice of contacts brings energy or loses a
// load.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/contact/interface_element.h"
#include "engine/contact/interface_state.h"
#include "engine/contact/vertex_contact.h"
#include "engine/model/model.h"

namespace dda {

// Where corners that face each other were two contacts and one has `ended` (-1: none), the one that goes on takes the
// load of the one that presses more, which would be lost otherwise. Loads do not add up: one spring that carries both
// stores more than the two did. Indices are of known contacts, whose states begin with the `first` of `states`.
std::ptrdiff_t heavier(std::ptrdiff_t earlier, std::ptrdiff_t ended, std::size_t first,
                       const std::vector<InterfaceState>& states);

// The state of a contact that goes on from a known one, `before`, which had the state `earlier` and springs of that
// stiffness, normal and shear. `element`: what it is now.
InterfaceState continued_state(const InterfaceState& earlier, const VertexContact& before, const VertexContact& contact,
                               const Vec2& stiffness_before, const InterfaceElement& element);

// The state of a contact at `distance` (m) that goes on from none. `from_stretch`: what ends of stretches leave to it,
// or null. They come with a force of their own, and with the depth of another contact the springs would have that one's
// as well. `beside`: the state of the contact that the face is pressed in by already, or null.
InterfaceState first_state(const JointMaterial& joint, const InterfaceElement& element, double distance,
                           const InterfaceState* from_stretch, const InterfaceState* beside);

// The strength of a vertex contact that has `closed` (m) of its joint and has come to this state.
EndStrength strength_of_vertex(const JointMaterial& joint, double closed, const InterfaceState& state);

// Gap, status and forces at that distance. A spring that opens has lost what it was seated with, but for a depth that
// it has not yet come out of.
void measure(const InterfaceElement& element, double distance, InterfaceState& state);

}  // namespace dda
