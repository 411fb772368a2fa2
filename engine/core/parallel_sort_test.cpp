#include "engine/core/parallel_sort.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>

namespace dda {
namespace {

TEST(ParallelSort, IsAsWithOneThread) {
  std::mt19937 random(5);
  for (const std::size_t count : {0U, 1U, 1000U, 50'000U, 100'003U}) {
    std::vector<std::pair<unsigned, std::size_t>> numbers;
    for (std::size_t i = 0; i < count; ++i) numbers.emplace_back(random() % 1000, i);
    auto sorted = numbers;
    std::sort(sorted.begin(), sorted.end());
    for (const int threads : {1, 2, 4}) {
      const ThreadsInUse in_use(threads);
      auto shared = numbers;
      parallel_sort(shared);
      EXPECT_EQ(shared, sorted) << count << " with " << threads;
    }
  }
}

TEST(ParallelSort, OfOthersIsThatOfAll) {
  std::mt19937 random(7);
  for (const std::size_t count : {0U, 1U, 2U, 1000U, 60'000U}) {
    for (const unsigned one_in : {1U, 2U, 100U, 10'000'000U}) {
      std::vector<std::mt19937::result_type> numbers;
      for (unsigned i = 0; i < count; ++i) numbers.push_back(random() % one_in == 0 ? random() % 100'000 : i / 3);
      auto sorted = numbers;
      std::sort(sorted.begin(), sorted.end());
      sort_others(numbers);
      EXPECT_EQ(numbers, sorted) << count << " of which one in " << one_in << " is none in order";
    }
  }
}

}  // namespace
}  // namespace dda
