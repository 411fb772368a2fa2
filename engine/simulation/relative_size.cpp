#include "engine/simulation/relative_size.h"

namespace dda {

bool is_below(double share, const BlockTerms& terms, const HeldUnknowns& held, std::size_t block) {
  std::size_t free = 0, larger = 0;
  for (std::size_t i = 0; i < terms.area.size(); ++i) {
    if (held.holds(static_cast<int>(i))) continue;
    ++free;
    if (share * terms.area[i] > terms.area[block]) ++larger;
  }
  return 2 * larger > free;
}

}  // namespace dda
