// Where a block or a contact lies, as sentences say it.
#pragma once

#include <string>

#include "engine/core/types.h"

namespace dda {

// "(1.234, -20.5) m": four digits are enough to find a block in a picture. Coordinates of a survey, thousands of metres
// and more, have eight, and so a tenth of a metre.
std::string place_in_words(const Vec2& place);

}  // namespace dda
