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

}  // namespace
}  // namespace dda
