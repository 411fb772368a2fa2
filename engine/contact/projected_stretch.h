// Stretches of the projected law whose blocks move and turn as a whole.
//
// Such a stretch stays one as long as its blocks lie as they were drawn: its gaps follow from where they are, its rows
// and what it takes off its blocks turn with them. When an end has gone by `parting_share` of the length, along the
// joint or away from it, what touches is no longer what was drawn; vertex contacts take the place of the stretch then
// (MovingContacts), and go on with its forces and its slip.
#pragma once

#include <array>

#include "engine/contact/contact_set.h"
#include "engine/contact/interface.h"
#include "engine/contact/interface_state.h"
#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

// Of the length of a stretch. Until then its length is wrong by as much.
inline constexpr double parting_share = 0.01;

// Whether an end has gone so far.
bool has_parted(const Model& model, const State& state, const Interface& interface);

// The gaps of a stretch whose ends are so far apart, and forces to go with them. The tangential gap is what has not
// slipped; joints that are open go on as they please, which counts as slip.
void measure_projected(const Model& model, const State& state, const Interface& interface,
                       const InterfaceElement& element, const EndsApart& ends, InterfaceState& own);

// At the end of a step that moved the gaps to `gap`: what an open stretch has gone along its tangent.
void count_free_slip(const InterfaceElement& element, const Vec4& gap, InterfaceState& own);

// The forces of a stretch at its ends, for contacts there that can only press.
std::array<Vec2, 2> pressing_ends(const InterfaceElement& element, const Vec4& force);

}  // namespace dda
