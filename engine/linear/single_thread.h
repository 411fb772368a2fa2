// Keeps the libraries under CHOLMOD from starting threads of their own: on the small dense blocks of these factors they
// cost several times the work they share (README), and the order of their sums would change the bits.
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

// Sets OpenBLAS, where that is the BLAS of this process, to one thread, for the whole process and for good: it knows no
// setting per thread. Done once; both libraries are looked up at run time, so that neither is linked.
void use_one_blas_thread();

}  // namespace dda
