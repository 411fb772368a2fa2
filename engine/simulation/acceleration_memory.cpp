#include "engine/simulation/acceleration_memory.h"

#include <cstddef>

namespace dda {

void AccelerationMemory::halve(std::vector<Vec6>& acceleration) const {
  for (std::size_t i = 0; i < acceleration.size(); ++i) acceleration[i] = (acceleration[i] + start_[i]) / 2;
}

}  // namespace dda
