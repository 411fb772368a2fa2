// Numbers too small to be kept with all their digits.
#pragma once

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace dda {

// While it lives, what falls below the least normal number (1e-38 in single precision) is zero on this thread.
// Processors take a hundred times as long over such numbers as over others, and ahead of a front, or far from what is
// pushed, whole blocks have nothing else. Where there is no such mode nothing changes but the time.
class TinyIsZero {
 public:
  TinyIsZero(const TinyIsZero&) = delete;
  TinyIsZero& operator=(const TinyIsZero&) = delete;
#if defined(__SSE__)
  TinyIsZero() : before_(_mm_getcsr()) { _mm_setcsr(before_ | results_are_zero | operands_are_zero); }
  ~TinyIsZero() { _mm_setcsr(before_); }

 private:
  static constexpr unsigned results_are_zero = 0x8000, operands_are_zero = 0x0040;
  unsigned before_;
#else
  TinyIsZero() = default;
  ~TinyIsZero() = default;
#endif
};

}  // namespace dda
