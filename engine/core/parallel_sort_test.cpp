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

}  // namespace
}  // namespace dda
