#include "engine/core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>
#include <utility>
#include <vector>

#include "engine/core/allocation_counter.h"
#include "engine/core/at_once.h"
#include "engine/core/parallel_scatter.h"

namespace dda {
namespace {

// Numbers whose sum depends on the order in which they are added.
std::vector<double> numbers(std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = std::sin(1.0 + static_cast<double>(i)) * 1e3;
  return values;
}

double sum_of(const std::vector<double>& values) {
  return parallel_sum(values.size(), 100, [&](std::size_t first, std::size_t last) {
    double sum = 0;
    for (std::size_t i = first; i < last; ++i) sum += values[i];
    return sum;
  });
}

TEST(Parallel, EveryElementIsVisitedOnce) {
  for (const int threads : {1, 2, 4}) {
    const ThreadsInUse in_use(threads);
    for (const std::size_t count : {0U, 1U, 19U, 20U, 21U, 1000U, 1003U}) {
      std::vector<std::atomic<int>> visits(count);
      for (int repeat = 0; repeat < 50; ++repeat)
        parallel_for(count, 10, [&](std::size_t first, std::size_t last) {
          EXPECT_TRUE(last - first >= 10 || last - first == count);
          for (std::size_t i = first; i < last; ++i) ++visits[i];
        });
      for (const auto& visited : visits) EXPECT_EQ(visited, 50);
    }
  }
}

TEST(Parallel, SumsDoNotDependOnTheNumberOfThreads) {
  const std::vector<double> values = numbers(12'345);
  const double alone = sum_of(values);
  for (const int threads : {2, 3, 4}) {
    const ThreadsInUse in_use(threads);
    for (int repeat = 0; repeat < 100; ++repeat) EXPECT_EQ(sum_of(values), alone);
  }
}

TEST(Parallel, TwoThingsAreBothDone) {
  for (const int threads : {1, 2, 4}) {
    const ThreadsInUse in_use(threads);
    for (int repeat = 0; repeat < 100; ++repeat) {
      double one = 0;
      std::vector<int> other;
      at_once([&] { one = sum_of(numbers(1000)); }, [&] { other.assign(10, 3); });
      EXPECT_EQ(one, sum_of(numbers(1000)));
      EXPECT_EQ(other, std::vector<int>(10, 3));
    }
  }
}

TEST(Parallel, SmallSumsAreThoseOfALoop) {
  const std::vector<double> values = numbers(199);
  double loop = 0;
  for (const double value : values) loop += value;
  const ThreadsInUse in_use(4);
  EXPECT_EQ(sum_of(values), loop);
}

TEST(Parallel, SumsThatGoOnHaveTheSameBitsHoweverManyThreads) {
  const auto sum_after = [](std::size_t count, int threads) {
    const ThreadsInUse in_use(threads);
    const std::vector<double> values = numbers(count);
    double sum = 0.1;
    parallel_add(count, 100, sum, [&](std::size_t first, std::size_t last, double& into) {
      for (std::size_t i = first; i < last; ++i) into += values[i];
    });
    return sum;
  };
  double loop = 0.1;
  for (const double value : numbers(199)) loop += value;
  EXPECT_EQ(sum_after(199, 4), loop);
  EXPECT_EQ(sum_after(12'345, 4), sum_after(12'345, 1));
}

// Numbers given to two of many, an odd one out of order: every sum is that of a plain loop, bit for bit.
TEST(Parallel, WhatIsScatteredComesInTheOrderOfTheThings) {
  constexpr std::size_t owners = 37, things = 5'000;
  const std::vector<double> values = numbers(things);
  const auto pair_of = [](std::size_t i) {
    return std::pair(static_cast<int>(i * 7 % owners), static_cast<int>((i * i + 3) % owners));
  };
  std::vector<double> expected(owners, 0);
  for (std::size_t i = 0; i < things; ++i) {
    expected[static_cast<std::size_t>(pair_of(i).first)] += values[i];
    expected[static_cast<std::size_t>(pair_of(i).second)] -= values[i] / 3;
  }
  for (const int threads : {1, 2, 5}) {
    const ThreadsInUse in_use(threads);
    std::vector<double> sums(owners, 0);
    parallel_scatter(things, owners, 100, pair_of, [&](std::size_t i, bool to_first, bool to_second) {
      if (to_first) sums[static_cast<std::size_t>(pair_of(i).first)] += values[i];
      if (to_second) sums[static_cast<std::size_t>(pair_of(i).second)] -= values[i] / 3;
    });
    EXPECT_EQ(sums, expected) << threads << " threads";
  }
}

TEST(Parallel, WorkIsSharedByThreads) {
  const ThreadsInUse in_use(2);
  std::atomic<int> arrived = 0;
  // Each piece waits for another: one thread alone would never end the first.
  for_each_piece({2, 2}, [&](std::size_t, std::size_t, std::size_t) {
    ++arrived;
    while (arrived < 2) std::this_thread::yield();
  });
  EXPECT_EQ(arrived, 2);
}

TEST(Parallel, WorkWithinWorkAndOfOtherThreadsIsDoneToo) {
  const ThreadsInUse in_use(4);
  const auto count_all = [] {
    std::atomic<int> visits = 0;
    parallel_for(100, 10, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        parallel_for(100, 10, [&](std::size_t from, std::size_t to) { visits += static_cast<int>(to - from); });
    });
    return visits.load();
  };
  int of_other = 0;
  std::thread other([&] { of_other = count_all(); });
  EXPECT_EQ(count_all(), 10'000);
  other.join();
  EXPECT_EQ(of_other, 10'000);
}

TEST(Parallel, NothingIsAllocatedOnceTheThreadsRun) {
  const ThreadsInUse in_use(2);
  const std::vector<double> values = numbers(12'345);
  EXPECT_NE(sum_of(values), 0);
  const long before = allocations_so_far();
  EXPECT_NE(sum_of(values), 0);
  EXPECT_EQ(allocations_so_far(), before);
}

TEST(Parallel, ThreadsInUseAreThoseOfBeforeAgain) {
  EXPECT_EQ(threads_in_use(), 1);
  {
    const ThreadsInUse two(2);
    const ThreadsInUse four(4);
    EXPECT_EQ(threads_in_use(), 4);
  }
  EXPECT_EQ(threads_in_use(), 1);
  EXPECT_GE(cores(), 1);
}

}  // namespace
}  // namespace dda
