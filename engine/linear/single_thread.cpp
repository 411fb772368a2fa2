#include "engine/linear/single_thread.h"

#include <dlfcn.h>

namespace dda {
namespace {

template <typename Function>
Function* find(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

struct OpenMp {
  int (*get_max_active_levels)() = find<int()>("omp_get_max_active_levels");
  void (*set_max_active_levels)(int) = find<void(int)>("omp_set_max_active_levels");
};

const OpenMp& open_mp() {
  static const OpenMp library;
  return library;
}

}  // namespace

SingleThreadScope::SingleThreadScope() {
  if (open_mp().set_max_active_levels == nullptr) return;
  levels_before_ = open_mp().get_max_active_levels();
  open_mp().set_max_active_levels(0);
}

SingleThreadScope::~SingleThreadScope() {
  if (open_mp().set_max_active_levels != nullptr) open_mp().set_max_active_levels(levels_before_);
}

void use_one_blas_thread() {
  static const bool done = [] {
    auto* set_threads = find<void(int)>("openblas_set_num_threads");
    if (set_threads != nullptr) set_threads(1);
    return true;
  }();
  static_cast<void>(done);
}

}  // namespace dda
