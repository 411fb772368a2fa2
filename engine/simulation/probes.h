// Reads a model's measurements from a simulation: what histories record.
#pragma once

#include <span>
#include <vector>

#include "dda/simulation/simulation.h"

namespace dda {

class Probes {
 public:
  // Finds the interface of every traction. Throws InputError naming the measurement when its two blocks share none
  // (of some length) at its point.
  explicit Probes(const Simulation& simulation);

  // Current values in the order of Model::measurements, SI units (see unit_of in model/quantity_names.h).
  void sample(const Simulation& simulation, std::span<double> values) const;

  [[nodiscard]] std::size_t size() const { return interfaces_.size(); }

 private:
  std::vector<int> interfaces_;  // index of the interface of each measurement, -1 where it needs none
};

}  // namespace dda
