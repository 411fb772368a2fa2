// Keeps CHOLMOD from starting threads of its own: on the small dense blocks of these factors they cost several times
// the work they share (README), and the order of their sums would change the bits. (The BLAS below it: blas_setup.h.)
#pragma once

namespace dda {

// OpenMP regions entered by this thread run serially while this lives (CHOLMOD of the distributions opens some). The
// setting is per thread and put back at the end, so parallel loops elsewhere are not affected.
class SingleThreadScope {
 public:
  SingleThreadScope();
  ~SingleThreadScope();
  SingleThreadScope(const SingleThreadScope&) = delete;
  SingleThreadScope& operator=(const SingleThreadScope&) = delete;

 private:
  int levels_before_ = 0;
};

}  // namespace dda
