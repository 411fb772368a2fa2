// For tests that ask whether two runs are the same to the last bit.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/core/counters.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/snapshot.h"

namespace dda {

// All that a checkpoint holds but its counters, which stand at its end: a run that was restored has analyzed and
// factored its matrix once more.
inline std::vector<std::byte> memory_of(const Simulation& simulation) {
  std::vector<std::byte> bytes = save(simulation);
  bytes.resize(bytes.size() - sizeof(Counters));
  visit_memory(simulation.state(), [&](const void* memory, std::size_t count) {
    const auto* first = static_cast<const std::byte*>(memory);
    bytes.insert(bytes.end(), first, first + count);
  });
  return bytes;
}

}  // namespace dda
