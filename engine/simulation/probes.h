// Reads a model's measurements from a simulation: what histories record.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/simulation/shared_edge.h"
#include "engine/simulation/simulation.h"

namespace dda {

class Probes {
 public:
  // Finds the interface of every traction, or the edge where blocks can move along each other. Throws InputError naming
  // the measurement when its two blocks share none (of some length) at its point.
  explicit Probes(const Simulation& simulation);

  // Current values in the order of Model::measurements, SI units (see unit_of in model/quantity_names.h).
  void sample(const Simulation& simulation, std::span<double> values) const;

  [[nodiscard]] std::size_t size() const { return places_.size(); }

 private:
  struct Place {
    int interface = -1;              // index, where interfaces stay
    std::optional<SharedEdge> edge;  // where they do not
  };
  std::vector<Place> places_;  // of tractions; empty for other measurements
};

}  // namespace dda
