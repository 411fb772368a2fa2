// Response spectra: how far a motion of the ground makes oscillators of all periods swing.
#pragma once

#include <cstddef>
#include <vector>

namespace dda {

enum class GroundMotion { displacement, velocity, acceleration };

// The ground's motion as it was sampled, straight lines between the samples. Times do not fall; where two are the same
// the motion jumps.
struct MotionRecord {
  GroundMotion kind = GroundMotion::acceleration;
  std::vector<double> times;   // s
  std::vector<double> values;  // m, m/s or m/s2
};

// The largest displacement (m) against the ground of an oscillator with this period (s) and this share of critical
// damping (below 1), over the time of the record. It stands still against the ground at first, as does the ground under
// a record of displacement.
double spectral_displacement(const MotionRecord& record, double period, double damping_ratio);

// s: from ten of the longest interval of the record, of whose motions straight lines between samples keep 97 %, to the
// whole of it.
struct PeriodRange {
  double shortest = 0, longest = 0;
};
PeriodRange resolved_periods(const std::vector<double>& times);

// `count` periods from the shortest to the longest, each the same multiple of the one before.
std::vector<double> spaced_evenly_in_logarithm(const PeriodRange& range, std::size_t count);

}  // namespace dda
