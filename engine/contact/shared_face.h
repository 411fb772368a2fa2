// Faces that two blocks share: straight, whatever vertices lie within them.
//
// A vertex within a straight face is no corner. Blocks deform evenly, so the face stays straight, and a contact there
// keeps nothing apart that the contacts at the ends of what is shared do not. Without it the contacts are those of the
// same face drawn without the vertex.
#pragma once

#include <functional>
#include <vector>

#include "engine/contact/outlines.h"
#include "engine/contact/vertex_contact.h"

namespace dda {

// Takes contacts of vertices within straight faces out of `found`, where there are others of the same face on both
// sides; of those that `concerns` says it of.
void drop_within_faces(const Outlines& outlines, const std::vector<double>& size,
                       const std::function<bool(const VertexContact&)>& concerns, std::vector<VertexContact>& found);

// m, the length of the shared face for which each contact stands: half of it for that at either end, so that they add
// up to it; 0 where blocks meet in corners alone. An end where no contact is, as that of a block which stands on its
// corner, is nobody's. `size`: of each block, m.
std::vector<double> shares_of_faces(const Outlines& outlines, const std::vector<double>& size,
                                    const std::vector<VertexContact>& contacts);

// False where the two edges of a contact lean against each other by more than a block does that rocks: only its corner
// touches there, however long the edges are side by side, and what goes by the area that is closed is none.
bool edges_lie_on_each_other(const Outlines& outlines, const VertexContact& contact);

}  // namespace dda
