#include "engine/linear/single_thread.h"

#include "engine/linear/library_function.h"

namespace dda {
namespace {

struct OpenMp {
  int (*get_max_active_levels)() = library_function<int()>("omp_get_max_active_levels");
  void (*set_max_active_levels)(int) = library_function<void(int)>("omp_set_max_active_levels");
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

}  // namespace dda
