// Reads a model's measurements from a simulation: what histories record.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "engine/simulation/measured_forces.h"
#include "engine/simulation/shared_edge.h"
#include "engine/simulation/simulation.h"

namespace dda {

class Probes {
 public:
  // Finds the interface of every traction, or the edge where blocks can move along each other, and the contacts of
  // every force. Throws InputError naming the measurement where there are none.
  explicit Probes(const Simulation& simulation);

  // Current values in the order of Model::measurements, those of each as histories_of() lists them
  // (model/quantity_names.h); SI units.
  void sample(const Simulation& simulation, std::span<double> values) const;

  // The number of values.
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  struct Place {
    int interface = -1;              // of a traction, where interfaces stay
    std::optional<SharedEdge> edge;  // of a traction, where they do not
    Cut cut;                         // of a contact force or a resultant
  };

  static Place place_of(const Simulation& simulation, const Measurement& measurement);
  static void write(const Simulation& simulation, const Measurement& measurement, const Place& place,
                    std::span<double> values);

  std::vector<Place> places_;  // one a measurement; empty for those that need none
  std::size_t size_ = 0;
};

}  // namespace dda
