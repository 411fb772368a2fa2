// Which covers that the place taken now lies behind are on the outline of the entrance block.
//
// Behind the line of a cover is not yet within the other block: the line goes on past its edge, and past the far side
// of a thin block. A cover claims that the blocks overlap at its edge by as much as its gap says. The claim is true if
// the vertex lies in the other block; or if a face of the vertex that lies flat on the edge does, where the two
// overlap; or if the other block's corner lies in that face's block. And the way out through the cover is one only if
// it is still needed once the blocks have come out through the shallower covers nearby: where a corner has passed the
// end of a short face, it has left by the face, and the next edge is nothing that it met.
#pragma once

#include <vector>

#include "engine/contact/entrance_cover.h"

namespace dda {

// Takes out covers whose gap is negative but whose overlap is not real. `round_off`: m, gaps that count as none.
// Where no claim is true but the outlines cross as deep as the shallowest cover claims, because corners have passed
// each other, that cover stays.
// `pressed` is scratch.
void drop_unreal(const Outlines& outlines, double round_off, std::vector<Cover>& covers, std::vector<Cover*>& pressed);

}  // namespace dda
