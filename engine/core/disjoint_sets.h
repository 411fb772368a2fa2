// Which of many things are one, by union and find: a forest of representatives.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace dda {

// The smallest number of a set stands for it.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t things) : parent_(things) { std::iota(parent_.begin(), parent_.end(), 0); }

  int root(int thing) {
    while (parent_of(thing) != thing) thing = parent_of(thing) = parent_of(parent_of(thing));
    return thing;
  }

  void join(int a, int b) {
    const auto [first, second] = std::minmax({root(a), root(b)});
    parent_of(second) = first;
  }

 private:
  int& parent_of(int thing) { return parent_[static_cast<std::size_t>(thing)]; }

  std::vector<int> parent_;
};

}  // namespace dda
