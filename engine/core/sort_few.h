// A stable sort of a handful of elements that needs no memory, as std::stable_sort does however few there are.
#pragma once

#include <algorithm>
#include <iterator>

namespace dda {

template <typename Elements, typename Less>
void sort_few(Elements& elements, Less less) {
  const auto first = std::begin(elements);
  for (auto each = first; each != std::end(elements); ++each)
    std::rotate(std::upper_bound(first, each, *each, less), each, std::next(each));
}

}  // namespace dda
