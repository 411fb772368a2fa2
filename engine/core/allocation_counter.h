// For tests and benchmarks: counts the heap allocations of the whole process, to show that a warm path makes none, and
// that no input makes one without bound.
#pragma once

#include <cstddef>

namespace dda {

// Calls of malloc, calloc, realloc and their aligned kin since the process began, by any thread and by any library in
// it; operator new counts through malloc. Take the difference of two calls. Link dda_allocation_counter.
[[nodiscard]] long allocations_so_far();

// Bytes of the largest of these calls since the process began or it was forgotten, whether or not it was granted.
[[nodiscard]] std::size_t largest_allocation();
void forget_largest_allocation();

// Bytes that are allocated now, and the most that were at a time since the process began or it was forgotten.
[[nodiscard]] long bytes_in_use();
[[nodiscard]] long most_bytes_in_use();
void forget_most_bytes_in_use();

}  // namespace dda
