#include "engine/linear/blas_setup.h"

#include <cstdlib>

#include "engine/linear/library_function.h"

namespace dda {
namespace {

bool has_avx2() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }

void use_one_thread() {
  auto* set_threads = library_function<void(int)>("openblas_set_num_threads");
  if (set_threads != nullptr) set_threads(1);
}

// OpenBLAS reads its choice from the environment when it is loaded, and again when it is told to begin anew. Builds for
// a single processor have no such functions.
void use_kernels_for_avx2() {
  constexpr const char* choice = "OPENBLAS_CORETYPE";
  auto* forget = library_function<void()>("gotoblas_dynamic_quit");
  auto* choose = library_function<void()>("gotoblas_dynamic_init");
  if (forget == nullptr || choose == nullptr || std::getenv(choice) != nullptr || !has_avx2()) return;
  setenv(choice, "Haswell", 0);
  forget();
  choose();
  unsetenv(choice);
}

}  // namespace

void set_up_blas() {
  static const bool done = [] {
    use_one_thread();
    use_kernels_for_avx2();
    return true;
  }();
  static_cast<void>(done);
}

}  // namespace dda
