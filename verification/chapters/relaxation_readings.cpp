// Readings of section 6.1: the first, and what differs from it in the others.
#include "verification/chapters/strain_relaxation.h"

namespace verify {
namespace {

RelaxationReading first_reading() {
  RelaxationReading reading;
  reading.name = "accurate";
  reading.difference =
      "joints at 60 and 120 deg, 3 m apart, a square of 60 m, this engine's default integrator, steps of 0.1 ms, no "
      "kinetic damping, 0.1 s";
  return reading;
}

template <class Change>
RelaxationReading with(const char* name, const char* difference, const Change& change) {
  RelaxationReading reading = first_reading();
  reading.name = name;
  reading.difference = difference;
  change(reading);
  return reading;
}

using Changed = RelaxationReading&;

}  // namespace

std::vector<RelaxationReading> relaxation_readings() {
  return {
      first_reading(),
      with("thesis", "the thesis' scheme: Eq. 5, 1 % kinetic damping a step of 0.1 ms",
           [](Changed r) { r.scheme = "thesis", r.velocity_factor = 0.99; }),
      with("thesis-undamped", "Eq. 5 without kinetic damping", [](Changed r) { r.scheme = "thesis"; }),
      with("damped", "the default integrator with 1 % kinetic damping a step",
           [](Changed r) { r.velocity_factor = 0.99; }),
      with("spacing-4", "joints 4 m apart",
           [](Changed r) { r.spacing = 4, r.first.shift = 5.0 / 6, r.second.shift = 0; }),
      with("second-150", "the second joints at 150 deg, square to the first",
           [](Changed r) {
             r.first.shift = 0.5, r.second = {150, 0.5};
           }),
      with("shifted", "all joints moved", [](Changed r) { r.first.shift = 1.0 / 6, r.second.shift = 4.0 / 6; }),
      with("sides-free", "the sides are not held while the rock settles under its weight",
           [](Changed r) { r.sides_held = false; }),
      with("steps-0.2ms", "steps of 0.2 ms", [](Changed r) { r.dt = 2e-4; }),
      with("steps-0.05ms", "steps of 0.05 ms", [](Changed r) { r.dt = 5e-5; }),
      with("thesis-0.01ms", "the thesis' scheme with the steps of chapter 3, 0.01 ms; 1 % damping a step",
           [](Changed r) { r.scheme = "thesis", r.velocity_factor = 0.99, r.dt = 1e-5; }),
      with("domain-80", "a square of 80 m", [](Changed r) { r.half_width = 40; }),
      with("spacing-2", "joints 2 m apart",
           [](Changed r) { r.spacing = 2, r.first.shift = 4.0 / 6, r.second.shift = 2.0 / 6; }),
  };
}

std::vector<RelaxationReading> quick_relaxation_readings() {
  const auto small = [](Changed r) { r.half_width = 14, r.spacing = 4, r.first.shift = 5.0 / 6, r.second.shift = 0; };
  return {with("small", "joints 4 m apart, a square of 28 m, 0.03 s", [&](Changed r) { small(r), r.duration = 0.03; })};
}

}  // namespace verify
