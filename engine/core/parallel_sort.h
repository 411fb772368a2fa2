// Sorting by all threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "engine/core/parallel.h"

namespace dda {

// As std::sort; elements that compare equal must be the same, or their order would be that of chance. Parts are sorted
// and then merged two by two.
template <typename Element, typename Less>
void parallel_sort(std::vector<Element>& elements, const Less& less) {
  constexpr std::size_t parts = 8;
  constexpr std::size_t worth_sharing = 50'000;
  if (elements.size() < worth_sharing || threads_in_use() == 1) {
    std::sort(elements.begin(), elements.end(), less);
    return;
  }
  const auto begin_of = [](auto& list, std::size_t part) {
    return list.begin() + static_cast<std::ptrdiff_t>(part * list.size() / parts);
  };
  parallel_for_each(parts, 1,
                    [&](std::size_t part) { std::sort(begin_of(elements, part), begin_of(elements, part + 1), less); });
  std::vector<Element> merged(elements.size());
  for (std::size_t width = 1; width < parts; width *= 2) {
    parallel_for_each(parts / (2 * width), 1, [&](std::size_t i) {
      const std::size_t first = 2 * width * i;
      std::merge(begin_of(elements, first), begin_of(elements, first + width), begin_of(elements, first + width),
                 begin_of(elements, first + 2 * width), begin_of(merged, first), less);
    });
    elements.swap(merged);
  }
}

template <typename Element>
void parallel_sort(std::vector<Element>& elements) {
  parallel_sort(elements, [](const Element& a, const Element& b) { return a < b; });
}

// The same of elements most of which are in order: the others are sorted, and merged with them from the last one on.
template <typename Element, typename Less>
void sort_others(std::vector<Element>& elements, const Less& less) {
  std::vector<Element> others;
  std::size_t in_order = std::min<std::size_t>(1, elements.size());
  for (std::size_t i = 1; i < elements.size(); ++i) {
    if (less(elements[i], elements[in_order - 1]))
      others.push_back(elements[i]);
    else
      elements[in_order++] = elements[i];
  }
  parallel_sort(others, less);
  for (std::size_t to = elements.size(); !others.empty(); --to) {
    if (in_order > 0 && less(others.back(), elements[in_order - 1])) {
      elements[to - 1] = elements[--in_order];
    } else {
      elements[to - 1] = others.back();
      others.pop_back();
    }
  }
}

template <typename Element>
void sort_others(std::vector<Element>& elements) {
  sort_others(elements, [](const Element& a, const Element& b) { return a < b; });
}

}  // namespace dda
