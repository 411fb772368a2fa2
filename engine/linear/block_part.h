// Some of the blocks of a matrix: those that a local solution moves. The others stay where they are.
#pragma once

#include <cstddef>
#include <vector>

namespace dda {

class BlockPart {
 public:
  // Makes it empty, of a matrix of that many blocks. Allocates only where there are more than ever before.
  void clear(int blocks) {
    blocks_.clear();
    blocks_.reserve(static_cast<std::size_t>(blocks));
    places_.assign(static_cast<std::size_t>(blocks), -1);
  }
  void add(int block) {
    int& place = places_[static_cast<std::size_t>(block)];
    if (place >= 0) return;
    place = size();
    blocks_.push_back(block);
  }
  [[nodiscard]] bool contains(int block) const { return places_[static_cast<std::size_t>(block)] >= 0; }
  // Whether it was among the first `count` that were added.
  [[nodiscard]] bool among_first(int count, int block) const {
    return contains(block) && places_[static_cast<std::size_t>(block)] < count;
  }
  // In the order they were added.
  [[nodiscard]] const std::vector<int>& blocks() const { return blocks_; }
  [[nodiscard]] int size() const { return static_cast<int>(blocks_.size()); }

 private:
  std::vector<int> blocks_;
  std::vector<int> places_;  // in blocks_, of every block of the matrix; -1: not there
};

}  // namespace dda
