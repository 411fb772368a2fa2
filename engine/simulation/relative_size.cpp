#include "engine/simulation/relative_size.h"

#include <algorithm>
#include <cstddef>
#include <functional>

namespace dda {

double area_of_most(const BlockTerms& terms, const HeldUnknowns& held, std::vector<double>& room) {
  room.clear();
  for (std::size_t i = 0; i < terms.area.size(); ++i)
    if (!held.holds(static_cast<int>(i))) room.push_back(terms.area[i]);
  if (room.empty()) return 0;
  const auto last_of_most = room.begin() + static_cast<std::ptrdiff_t>(room.size() / 2);
  std::ranges::nth_element(room, last_of_most, std::greater());
  return *last_of_most;
}

}  // namespace dda
