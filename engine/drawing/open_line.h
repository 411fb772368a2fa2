// Lines of a drawing that are to close, and what keeps them from it.
#pragma once

#include <string>
#include <vector>

#include "engine/core/types.h"

namespace dda {

struct OpenLine {
  std::vector<Vec2> points;
  std::string origin;
};

// What keeps lines from closing, as the parts of a sentence.
struct Gap {
  std::string origin;  // of the line that ends there
  std::string value;
  std::string expected;
};

}  // namespace dda
