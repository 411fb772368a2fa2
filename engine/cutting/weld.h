// One place where a drawing has two but for round-off.
//
// Who draws an opening along joints computes its corners, and gets them beside the joints' crossings by round-off. The
// grid of noding is finer than that: it keeps both, with faces between them that are as narrow and as long as the
// outline. Merged as slivers, those around a corner of the opening would leave spurs of no width. So nodes that are
// nearer than round-off become one before there are faces, and links that pass a node almost that close (0.7) go
// through it.
#pragma once

#include <vector>

#include "engine/cutting/plan_pieces.h"
#include "engine/cutting/round_off.h"

namespace dda {

// Boundary and holes stay as drawn: what is near them moves onto them. Appends to `cleaned` what moved by more than a
// step of the grid. Two rounds do; there are more only where welding brings other places together. When they are used
// up, the noding says so; its links still meet in nodes only.
Noding welded(Noding noding, const PlanPieces& pieces, const RockPlan& plan, std::vector<Cleaned>& cleaned,
              int most_rounds);

}  // namespace dda
