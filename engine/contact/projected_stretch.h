// Stretches of the projected law whose blocks move and turn as a whole.
//
// Such a stretch stays one as long as its blocks lie as they were drawn: its gaps follow from where they are, its rows
// and what it takes off its blocks turn with them. When an end has gone by `parting_share` of the length, along the
// joint or away from it, what touches is no longer what was drawn; vertex contacts take the place of the stretch then
// (MovingContacts), and go on with its forces and its slip.
//
// With the stretch a block loses the forces -D Q s + S^T f on its strains (projected_law.h), which would leave it with
// energy from nowhere. It gives up as much of its stress instead, s' = s - D R^T l/(2 gamma) (t - T)/A: what its own
// traction t has beyond T, which the joint carries. The forces on its strains stay, and of all that is stored
// l/(4 gamma) |t - T|^2 is lost, less what is of second order in l/(2 gamma A) and smaller by the bound on the penalty.
#pragma once

#include <algorithm>
#include <array>

#include "engine/contact/contact_set.h"
#include "engine/contact/interface.h"
#include "engine/contact/interface_frame.h"
#include "engine/contact/interface_state.h"
#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

// The share of its length that an end may go before the stretch parts. Until then the length is wrong by as much.
inline constexpr double parting_share = 0.01;

// The same of an end that gapes while the other one has stayed: by that the stretch has turned, and is where it was.
// Contacts of corners that take its place carry a force up to its edge, however wide the joint presses, and a block
// that is about to topple over stood up on them again.
inline constexpr double turning_share = 0.05;

// Whether an end of a stretch of this law gapes.
inline bool gapes(const InterfaceElement& element, const InterfaceState& state) {
  return element.law == InterfaceLaw::projected && std::ranges::count(state.status, ContactStatus::open) > 0;
}

// Whether an end has slid or gone away from the other block so far; to gape wider the blocks must not meet anew past
// the end that stays.
bool has_parted(const Model& model, const State& state, const Interface& interface);

// Whether the outline has neither a corner that points inwards, by more than half a degree, nor a hole.
bool points_outwards(const Polygon& shape);

// Whether two blocks can touch nowhere else as long as they have the stretch, but for half a degree: neither has a
// corner that points inwards, nor a hole; or the line of the stretch lies between them, as along a joint that was cut
// right through, and past an end of the stretch one of them has left it. What else there is of the blocks, the arc of
// an opening or a bench, is then nothing to the other one. No other contact is looked for between two such blocks.
bool touch_there_alone(const Model& model, const Interface& interface);

// The gaps of a stretch whose ends are so far apart, and forces to go with them. The tangential gap is what has not
// slipped; joints that are open go on as they please, which counts as slip. What small kinematics made of the gaps
// before is their seat.
void measure_projected(const Model& model, const State& state, const Interface& interface,
                       const InterfaceElement& element, const EndsApart& ends, InterfaceState& own);

// The forces of a stretch by its gaps. What is open as a whole goes on along its tangent, and an end that gapes is
// open.
void answer_gaps(const InterfaceElement& element, InterfaceState& own);

// Returns what the gaps of a stretch are where its blocks lie, whether anything presses there or not.
Vec4 gap_as_it_lies(const Model& model, const State& state, const Interface& interface, const InterfaceElement& element,
                    InterfaceState own);

// At the end of a step that moved the gaps to `gap`: what an open stretch has gone along its tangent.
void count_free_slip(const InterfaceElement& element, const Vec4& gap, InterfaceState& own);

// What that adds to the stress of either block, Pa.
struct StressLetGo {
  Vec3 of_a, of_b;
};
StressLetGo stress_let_go(const Model& model, const State& state, const InterfaceElement& element, const Vec4& force);

// The share of the length along which a stretch gapes that presses; none where it is open, as it may close again as a
// whole, and of other laws. The contacts that take its place have so much less of the residual cohesion: a block that
// slides on a part of its face would else come to rest on what it regains when the stretch parts.
double gaping_share(const InterfaceElement& element, const InterfaceState& state);

// The forces of a stretch at its ends, for contacts there that can only press. An end that gapes has none.
std::array<Vec2, 2> pressing_ends(const InterfaceElement& element, const InterfaceState& state);

}  // namespace dda
