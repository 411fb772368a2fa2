// Which of many things have a property, asked by all threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "engine/core/parallel.h"

namespace dda {

// By number below `count` whether `holds` says so: 1 or 0.
template <typename Condition>
std::vector<char> flags_where(std::size_t count, const Condition& holds) {
  constexpr std::size_t worth_sharing = 256;
  constexpr std::size_t at_once = 20'000;  // threads that others had may be free by the next ones
  std::vector<char> flags(count);
  for (std::size_t first = 0; first < count; first += at_once)
    parallel_for_each(std::min(at_once, count - first), worth_sharing,
                      [&](std::size_t i) { flags[first + i] = holds(first + i) ? 1 : 0; });
  return flags;
}

// Those numbers, in their order.
template <typename Condition>
std::vector<std::size_t> numbers_where(std::size_t count, const Condition& holds) {
  const std::vector<char> flags = flags_where(count, holds);
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < count; ++i)
    if (flags[i] != 0) numbers.push_back(i);
  return numbers;
}

}  // namespace dda
