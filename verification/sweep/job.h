// One job: runs the bar, measures the wave, and asks the closed forms what it should be.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <vector>

#include "engine/core/counters.h"
#include "verification/sweep/parameters.h"
#include "verification/thesis/reference.h"

namespace verify {

// Errors against the wave equation, %: of the velocity over sqrt(E/rho), of the amplitude over that of the load.
struct WaveErrors {
  double velocity = 0;
  double amplitude = 0;
};

// What is read off a history of stress at the measuring point.
struct WaveReadings {
  WaveErrors errors;                     // by cross-correlation, and the least-squares fit of the delayed wave
  double half_range = 0;                 // error of (largest - smallest)/2, the amplitude of thesis Table 3.2, %
  std::optional<double> onset_velocity;  // error of the pick of thesis Table 3.3, of the cycle only, %
};

struct JobResult {
  double place = 0;  // m, where the wave was measured
  WaveReadings measured;
  std::optional<WaveErrors> predicted;       // what engine/advice says of the whole history; none: nothing arrives
  WaveErrors steady;                         // of a steady wave of the load's frequency, from the end to the place
  WaveErrors wave;                           // of its way alone, as phase speed and attenuation have it
  std::optional<WaveErrors> closed_form;     // of the same pulse in the same discrete problem
  std::optional<double> largest_difference;  // of the two histories, over the peak
  double setup_cpu_s = 0;
  double cpu_s = 0;  // of the steps
  dda::Counters counters;
};

// There is a wave, but no number that means something can be read off it.
class NotMeasurable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// `history` (Pa, tension positive) is sampled at t = i dt.
[[nodiscard]] WaveReadings read_wave(const ThesisBar& bar, Pulse pulse, const std::vector<double>& history, double dt);

// What the engine's advice expects of these readings, before anything is run.
[[nodiscard]] std::optional<WaveErrors> predict(const JobParameters& parameters);

[[nodiscard]] JobResult run_job(const JobParameters& parameters, bool closed_form);

// A flat object, the columns of the table after the parameters; what there is not is null.
[[nodiscard]] nlohmann::ordered_json to_json(const JobResult& result);

// True where they agree within 20 % of the measured error, or 0.05 percentage points.
[[nodiscard]] bool agree(double measured, double predicted);

}  // namespace verify
