// Forces that measurements add up, over a step that was taken in parts.
//
// Every part is a step of its own, with a balance of its own, so what acts at the end of the last one says nothing of
// the others: an impact may be over by then. The row of such a step has the mean over its parts, weighted by their
// lengths, so that forces times dt add up to the impulse as they do where no step was cut.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace dda {

class ForcesOfParts {
 public:
  // Before every step, whatever becomes of it.
  void clear() { length_ = 0; }

  // A part of `dt`, s, is done; then what each measurement, one after the other, says of it. Those that are of no
  // forces have no values.
  void begin_part(double dt);
  void add(std::size_t measurement, std::span<const double> values);

  // The values of a measurement for the last step; empty where that was taken as a whole, or it is of no forces.
  [[nodiscard]] std::span<const double> mean(std::size_t measurement) const;

 private:
  double length_ = 0;                       // s, of the parts so far
  double share_ = 0;                        // of the last part in them
  std::vector<std::vector<double>> means_;  // over them, one list a measurement
};

}  // namespace dda
