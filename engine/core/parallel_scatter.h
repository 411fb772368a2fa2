// Things that add to what others have, two of these each, done by all threads: forces of contacts on blocks.
#pragma once

#include <cstddef>
#include <utility>

#include "engine/core/parallel.h"

namespace dda {

// add(i, to_first, to_second) for every thing i below `things`: it adds to the first and to the second of pair_of(i),
// or to one of them alone. Every thread adds to some of the `owners`, and looks at all things for that. An owner gets
// what it gets in the order of the things, so that its sum has the same bits whoever takes it. Fewer than twice `grain`
// things are not shared.
template <typename PairOf, typename Add>
void parallel_scatter(std::size_t things, std::size_t owners, std::size_t grain, const PairOf& pair_of,
                      const Add& add) {
  if (things < 2 * grain || threads_in_use() == 1) {
    for (std::size_t i = 0; i < things; ++i) add(i, true, true);
    return;
  }
  const Pieces pieces{owners, static_cast<std::size_t>(threads_in_use())};
  for_each_piece(pieces, [&](std::size_t, std::size_t first_owner, std::size_t last_owner) {
    const auto is_here = [=](int owner) {
      return static_cast<std::size_t>(owner) >= first_owner && static_cast<std::size_t>(owner) < last_owner;
    };
    for (std::size_t i = 0; i < things; ++i) {
      const std::pair<int, int> pair = pair_of(i);
      const bool to_first = is_here(pair.first), to_second = is_here(pair.second);
      if (to_first || to_second) add(i, to_first, to_second);
    }
  });
}

}  // namespace dda
