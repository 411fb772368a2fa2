// A picture (SVG) of a ground reaction curve: support pressure over the inward displacement of the wall.
#pragma once

#include <string>

#include "engine/reaction/ground_reaction.h"

namespace dda {

[[nodiscard]] std::string reaction_picture(const ReactionCurve& curve);

}  // namespace dda
