// Equal 6x6 blocks kept once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <unordered_set>
#include <vector>

#include "engine/core/types.h"

namespace dda {

// Numbers blocks in the order in which they come, equal ones alike. Where the first thousands are nearly all different
// the others will be, and looking for equal ones would only take time.
class DifferentBlocks {
 public:
  explicit DifferentBlocks(std::vector<Mat6>& blocks) : blocks_(blocks), numbers_(0, Hash{blocks}, Equal{blocks}) {}

  template <typename Block>
  int number_of(const Block& block) {
    blocks_.push_back(block);
    const int number = static_cast<int>(blocks_.size()) - 1;
    if (!pays()) return number;
    ++looked_up_;
    const auto [found, is_new] = numbers_.insert(number);
    if (!is_new) blocks_.pop_back();
    return *found;
  }

 private:
  static constexpr int trial = 4096;

  struct Hash {
    const std::vector<Mat6>& blocks;
    std::size_t operator()(int number) const {
      std::array<std::uint64_t, 36> words;
      std::memcpy(words.data(), blocks[static_cast<std::size_t>(number)].data(), sizeof words);
      std::uint64_t hash = 0;
      for (const std::uint64_t word : words) hash = (hash ^ (word >> 17)) * 0x9e3779b97f4a7c15 + word;
      return hash ^ (hash >> 32);
    }
  };
  struct Equal {
    const std::vector<Mat6>& blocks;
    bool operator()(int one, int other) const {
      return std::memcmp(blocks[static_cast<std::size_t>(one)].data(), blocks[static_cast<std::size_t>(other)].data(),
                         sizeof(Mat6)) == 0;
    }
  };

  [[nodiscard]] bool pays() const {
    return looked_up_ < trial || 2 * numbers_.size() < static_cast<std::size_t>(looked_up_);
  }

  std::vector<Mat6>& blocks_;
  std::unordered_set<int, Hash, Equal> numbers_;
  int looked_up_ = 0;
};

}  // namespace dda
