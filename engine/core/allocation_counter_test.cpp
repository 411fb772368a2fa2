#include "engine/core/allocation_counter.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>

namespace dda {
namespace {

// Keeps the compiler from leaving out an allocation that nobody looks at.
void* volatile seen = nullptr;

TEST(AllocationCounter, SeesMallocAndNewAndNothingElse) {
  const long before = allocations_so_far();
  const long idle = allocations_so_far();
  void* memory = std::malloc(100);
  seen = memory;
  const long after_malloc = allocations_so_far();
  const auto number = std::make_unique<int>(3);
  seen = number.get();
  const long after_new = allocations_so_far();
  std::free(memory);
  const long after_free = allocations_so_far();

  EXPECT_EQ(idle, before);
  EXPECT_EQ(after_malloc, before + 1);
  EXPECT_EQ(after_new, before + 2);
  EXPECT_EQ(after_free, before + 2);
}

TEST(AllocationCounter, SeesAlignedMemory) {
  const long before = allocations_so_far();
  void* memory = std::aligned_alloc(64, 128);
  seen = memory;
  const long after = allocations_so_far();
  std::free(memory);
  EXPECT_EQ(after, before + 1);
}

// malloc hands out up to some dozens of bytes more than it is asked for.
TEST(AllocationCounter, CountsBytesUntilTheyAreGivenBack) {
  const long before = bytes_in_use();
  forget_most_bytes_in_use();
  void* memory = std::malloc(1'000'000);
  seen = memory;
  const long taken = bytes_in_use() - before;
  memory = std::realloc(memory, 3'000'000);
  seen = memory;
  const long grown = bytes_in_use() - before;
  std::free(memory);
  EXPECT_NEAR(static_cast<double>(taken), 1e6, 1e4);
  EXPECT_NEAR(static_cast<double>(grown), 3e6, 1e4);
  EXPECT_EQ(bytes_in_use(), before);
  EXPECT_NEAR(static_cast<double>(most_bytes_in_use() - before), 3e6, 1e6 + 1e4);  // both, while it is moved
}

}  // namespace
}  // namespace dda
