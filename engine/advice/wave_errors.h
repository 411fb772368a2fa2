// Errors of a wave in a lattice before anything is run, split by cause: of a steady wave, and of a load history, which
// is as good as the whole of its spectrum.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "engine/advice/arrival.h"
#include "engine/advice/lattice.h"
#include "engine/advice/plane_wave.h"
#include "engine/advice/time_steps.h"

namespace dda {

struct WaveQuestion {
  Lattice lattice;
  Stage stage;  // integrator, dt, inertia
  WaveKind kind = WaveKind::bar;
  Vec2 direction = Vec2::UnitX();
  double distance = 0;  // m, that the wave has run when it is looked at
};

// What each cause adds to a relative error, in this order: `blocks` is the error in continuous time with the accurate
// law of the joints, or their own when it is not springs; `interfaces` what springs add; `time` what time steps add;
// `damping` what damping of the material and of velocities adds; `sides` what those of a mesh add that are near.
struct ErrorTerms {
  double blocks = 0, interfaces = 0, time = 0, damping = 0, sides = 0;

  [[nodiscard]] double total() const { return blocks + interfaces + time + damping + sides; }
};

struct SteadyErrors {
  ErrorTerms speed;      // of the phase
  ErrorTerms amplitude;  // at the distance
};

// Nothing where the blocks carry no such wave or fewer than two steps make a period.
std::optional<SteadyErrors> steady_errors(const WaveQuestion& question, double frequency);

// Causes in the order in which they are added.
enum class Causes { blocks, space, time, all };
inline bool has_steps(Causes causes) { return causes == Causes::time || causes == Causes::all; }

// The time steps, and the corrections for them, that a stage has as far as these causes go.
TimeSteps time_of(const Stage& stage, Causes causes);
Stage stage_of(Stage stage, Causes causes);

// Errors of speed and amplitude with one cause after the other.
template <typename Reading>
struct ByCause {
  Reading blocks, space, time, all;

  [[nodiscard]] ErrorTerms speed() const { return terms(&Reading::speed); }
  [[nodiscard]] ErrorTerms amplitude() const { return terms(&Reading::amplitude); }

 private:
  [[nodiscard]] ErrorTerms terms(double Reading::*error) const {
    return {blocks.*error, space.*error - blocks.*error, time.*error - space.*error, all.*error - time.*error, 0};
  }
};

// Takes the readings of all causes by `read`, each only where it differs from the next. Nothing where one has none.
template <typename Read>
auto read_by_cause(const Stage& stage, bool has_springs, const Read& read) {
  using Reading = typename decltype(read(Causes::all))::value_type;
  std::optional<ByCause<Reading>> readings;
  const auto all = read(Causes::all);
  if (!all) return readings;
  const auto time = is_damped(stage) ? read(Causes::time) : all;
  const auto space = read(Causes::space);
  const auto blocks = has_springs ? read(Causes::blocks) : space;
  if (time && space && blocks) readings = {*blocks, *space, *time, *all};
  return readings;
}

// What blocks, interfaces and time steps make together, for a fifth of the work or less.
struct TotalErrors {
  double speed = 0, amplitude = 0;
};
std::optional<TotalErrors> total_steady_errors(const WaveQuestion& question, double frequency);

struct LoadHistory {
  std::function<double(double)> value;  // dimensionless, of s since the load began; 0 before
  double duration = 0;                  // s, that matters
  double period = 0;                    // s, of its main frequency
  double window = 0;                    // s, that is looked at; 0: until the wave has passed
  double start = 0;                     // s, in the run
  double run = 0;                       // s, that the run goes on after that
  // Where something is moved: `value` is its velocity and this its displacement, over one amplitude. Else empty.
  std::function<double(double)> displacement = {};

  // s, the end of the run where that is known.
  [[nodiscard]] double seen_until() const { return run > 0 ? run : std::numeric_limits<double>::infinity(); }
};

// The load as a run puts it on, at s since it began.
double filtered(const LoadFilter& filter, const LoadHistory& load, double time);

// Whether the run goes on until half of the load has come, or any of one that stays on.
bool is_seen(const LoadHistory& load, double on_time, const Lags& lags);

// s, that a trace has to last: until the wave has passed, however late, or the run is over that shows it.
double window_of(const LoadHistory& load, double on_time, const Lags& lags);

// When a wave comes to where it is looked at, and how long it is looked at, s from its load's begin on.
struct WaveTiming {
  double front = 0, window = 0;
};

struct HistoryErrors {
  ErrorTerms speed, amplitude;  // by cross-correlation and fit
  ArrivalErrors arrival;        // all readings of all causes together
  double place = 0;             // m, of the joint where the wave is looked at
  bool with_end = false;        // counts what the loaded end does; else the way alone

  // The same with the readings of a mesh whose sides count as well.
  [[nodiscard]] HistoryErrors with_sides(const ArrivalErrors& readings) const;
};

// Nothing where what arrives does not resemble the load (see read_arrival). Stress at the joint nearest to the distance
// where the mesh has flat layers across the direction, loaded along the wave's motion on the face of the first of them.
std::optional<HistoryErrors> history_errors(const WaveQuestion& question, const LoadHistory& load);

std::optional<TotalErrors> total_history_errors(const WaveQuestion& question, const LoadHistory& load);

// The same readings of another trace of that stress, at 0, interval, ... (s), and when it comes.
std::optional<ArrivalErrors> read_other(const WaveQuestion& question, const LoadHistory& load,
                                        const std::vector<double>& trace, double interval);
WaveTiming timing_of(const WaveQuestion& question, const LoadHistory& load);

// The stress there that the blocks, interfaces and time steps make of the load, over the load's amplitude.
struct PredictedTrace {
  std::vector<double> values;
  double interval = 0;  // s: the time step, or a multiple where that gives thousands of samples
  double place = 0;     // m
  bool with_end = false;
};
PredictedTrace predict_trace(const WaveQuestion& question, const LoadHistory& load);

}  // namespace dda
