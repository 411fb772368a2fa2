// For tests and benchmarks: counts the heap allocations of the whole process, to show that a warm path makes none.
#pragma once

namespace dda {

// Calls of malloc, calloc, realloc and their aligned kin since the process began, by any thread and by any library in
// it; operator new counts through malloc. Take the difference of two calls. Link dda_allocation_counter.
[[nodiscard]] long allocations_so_far();

}  // namespace dda
