#include "engine/core/allocation_counter.h"

#include <malloc.h>

#include <atomic>
#include <cerrno>
#include <cstddef>

namespace {

std::atomic<long> count{0};
std::atomic<std::size_t> largest{0};
std::atomic<long> in_use{0};
std::atomic<long> most_in_use{0};

void note_taken(std::size_t size) {
  const long now = in_use.fetch_add(static_cast<long>(size), std::memory_order_relaxed) + static_cast<long>(size);
  long before = most_in_use.load(std::memory_order_relaxed);
  while (now > before && !most_in_use.compare_exchange_weak(before, now, std::memory_order_relaxed)) {
  }
}

void note_given_back(std::size_t size) { in_use.fetch_sub(static_cast<long>(size), std::memory_order_relaxed); }

void note(std::size_t size) {
  count.fetch_add(1, std::memory_order_relaxed);
  std::size_t before = largest.load(std::memory_order_relaxed);
  while (size > before && !largest.compare_exchange_weak(before, size, std::memory_order_relaxed)) {
  }
}

}  // namespace

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)

// The sanitizers own malloc; they tell of each call instead.
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*)(const volatile void*, std::size_t),
                                                         void (*)(const volatile void*));
extern "C" std::size_t __sanitizer_get_allocated_size(const volatile void*);

namespace {

void on_malloc(const volatile void*, std::size_t size) {
  note(size);
  note_taken(size);
}
void on_free(const volatile void* memory) {
  if (memory != nullptr) note_given_back(__sanitizer_get_allocated_size(memory));
}
const int hooks_installed = __sanitizer_install_malloc_and_free_hooks(on_malloc, on_free);

}  // namespace

#else

namespace {

void* taken(void* memory) {
  note_taken(malloc_usable_size(memory));
  return memory;
}

}  // namespace

// Definitions in the program come before those of the C library, for the program and for every library it loads. The
// real work stays with glibc, by the names it exports for this purpose.
extern "C" {
// NOLINTBEGIN(readability-identifier-naming)
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t number, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* memory);
// NOLINTEND(readability-identifier-naming)

void* malloc(std::size_t size) {
  note(size);
  return taken(__libc_malloc(size));
}

void* calloc(std::size_t number, std::size_t size) {
  note(number * size);
  return taken(__libc_calloc(number, size));
}

void* realloc(void* memory, std::size_t size) {
  note(size);
  const std::size_t before = malloc_usable_size(memory);
  void* const moved = __libc_realloc(memory, size);
  if (moved == nullptr && size > 0) return nullptr;  // what was there stays
  note_given_back(before);
  return taken(moved);
}

void* memalign(std::size_t alignment, std::size_t size) {
  note(size);
  return taken(__libc_memalign(alignment, size));
}

void free(void* memory) {
  note_given_back(malloc_usable_size(memory));
  __libc_free(memory);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) { return memalign(alignment, size); }

int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  *memory = memalign(alignment, size);
  return *memory == nullptr ? ENOMEM : 0;
}
}

#endif

namespace dda {

long allocations_so_far() { return count.load(std::memory_order_relaxed); }

std::size_t largest_allocation() { return largest.load(std::memory_order_relaxed); }

void forget_largest_allocation() { largest.store(0, std::memory_order_relaxed); }

long bytes_in_use() { return in_use.load(std::memory_order_relaxed); }

long most_bytes_in_use() { return most_in_use.load(std::memory_order_relaxed); }

void forget_most_bytes_in_use() { most_in_use.store(bytes_in_use(), std::memory_order_relaxed); }

}  // namespace dda
