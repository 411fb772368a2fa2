// Whether a step would go the same way however it is cut.
//
// Where contacts only close, open and carry, what a step comes to is the least of a convex energy: one answer, however
// loads came to be what they are. Friction that gives way, and joints that break, remember the way, and blocks that
// turn far meet other forces on it. A static stage whose loads come at once therefore tries one long step first, and
// believes it where next to nothing slips: in a short one inertia holds back what lies behind the blocks that loads and
// supports touch, these slip against each other before anything presses them together, and that slip stays (ADR 95).
#pragma once

#include <span>

#include "engine/simulation/block_system.h"
#include "engine/solve/contact_solver.h"

namespace dda {

// Asked of a step that was solved, before it is accepted. `bonded`: joints outside of the problem, some of which may
// break.
bool hardly_slips(const BlockSystem& system, const ContactSolver& solved, const StepSolution& solution,
                  std::span<const int> bonded);

}  // namespace dda
