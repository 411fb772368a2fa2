#include "engine/advice/wave_errors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "engine/advice/closed_joints.h"
#include "engine/advice/half_row.h"
#include "engine/advice/load_trace.h"

namespace dda {
namespace {

constexpr double most_samples = 2048;  // of a trace

// Joints that are springs where blocks move have the law of springs in the lattice.
bool has_springs(const Lattice& lattice) { return one_gives_way_closed(lattice.joints, Kinematics::small); }

Lattice lattice_of(const WaveQuestion& question, Causes causes) {
  return causes == Causes::blocks && has_springs(question.lattice) ? with_consistent_joints(question.lattice)
                                                                   : question.lattice;
}

std::optional<TotalErrors> steady(const WaveQuestion& question, double omega, Causes causes) {
  const WaveSolver solver(lattice_of(question, causes), stage_of(question.stage, causes), question.kind,
                          question.direction);
  const auto wave = solver.steady(time_of(question.stage, causes), omega);
  if (!wave) return std::nullopt;
  const double exact = omega / continuum_speed(question.lattice.material, question.kind);
  return TotalErrors{exact / wave->wavenumber.real() - 1, std::expm1(wave->wavenumber.imag() * question.distance)};
}

// Follows a wave from frequency to frequency; above the highest that the blocks carry, nothing arrives.
class Path {
 public:
  Path(const WaveQuestion& question, Causes causes)
      : solver_(lattice_of(question, causes), stage_of(question.stage, causes), question.kind, question.direction),
        time_(time_of(question.stage, causes)),
        distance_(question.distance),
        slowness_(Complex(0, -1) / continuum_speed(question.lattice.material, question.kind)) {}

  Complex operator()(Complex s) {
    if (ended_) return 0;
    PlaneWave guess = last_ ? *last_ : solver_.long_wave(s);
    if (last_) guess.wavenumber += slowness_ * (s - last_s_);
    const auto found = solver_.near(guess, time_.square(s));
    // Above that frequency blocks a layer apart move against each other; waves of other shapes follow, which a load on
    // many blocks does not make.
    const bool lost = !found || found->wavenumber.imag() > 0 || found->wavenumber.real() > solver_.largest_wavenumber();
    if (lost) {
      ended_ = true;
      return 0;
    }
    last_ = found;
    last_s_ = s;
    return std::exp(Complex(0, -distance_) * found->wavenumber);
  }

 private:
  WaveSolver solver_;
  TimeSteps time_;
  double distance_;
  Complex slowness_;
  std::optional<PlaneWave> last_;
  Complex last_s_ = 0;
  bool ended_ = false;
};

// What is looked at: a joint of the row, or a place on the way where there are no flat layers.
struct Place {
  double distance = 0;
  int joint = 0;
  bool with_end = false;
};

Place place_of(const WaveQuestion& question) {
  const auto row = HalfRow::make(question.lattice, question.stage, question.kind, question.direction);
  if (!row) return {question.distance, 0, false};
  const int joint = std::max(1, static_cast<int>(std::lround(question.distance / row->step())));
  return {joint * row->step(), joint, true};
}

// s, by which waves of low frequency and those of the load's own run late (or early, below 0), their phases and their
// group: where joints are soft that is many periods.
Lags lags_of(const WaveQuestion& question, double distance, double period) {
  const WaveSolver solver(question.lattice, question.stage, question.kind, question.direction);
  const double on_time = distance / continuum_speed(question.lattice.material, question.kind);
  const double omega = 2 * std::numbers::pi / period;
  const auto delay = [&](double frequency) -> std::optional<double> {
    const auto wave = solver.steady({}, frequency);
    return wave ? std::optional(distance * wave->wavenumber.real()) : std::nullopt;
  };
  Lags lags;
  const auto low = delay(0.05 * omega), below = delay(0.95 * omega), above = delay(1.05 * omega);
  if (low) lags.include(*low / (0.05 * omega) - on_time);
  if (below) lags.include(*below / (0.95 * omega) - on_time);
  if (below && above) lags.include((*above - *below) / (0.1 * omega) - on_time);
  return lags;
}

double on_time(const WaveQuestion& question, const Place& place) {
  return place.distance / continuum_speed(question.lattice.material, question.kind);
}

double window_at(const WaveQuestion& question, const LoadHistory& load, const Place& place) {
  return window_of(load, on_time(question, place), lags_of(question, place.distance, load.period));
}

// `filter`: of the load, as a run applies it.
LoadSpectrum spectrum_of(const WaveQuestion& question, const LoadHistory& load, const Place& place,
                         const LoadFilter& filter) {
  const double window = window_at(question, load, place);
  const double stride = std::max(1.0, std::ceil(window / question.stage.dt / most_samples));
  const double interval = stride * question.stage.dt;
  std::vector<double> samples(static_cast<std::size_t>(std::floor(window / interval + 1e-6)) + 1);
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] = filtered(filter, load, static_cast<double>(i) * interval);
  return {samples, interval};
}

struct Trace {
  std::vector<double> values;
  double interval = 0;  // s
};

Trace trace_of(const WaveQuestion& question, const LoadHistory& load, const Place& place, Causes causes) {
  if (!place.with_end) {
    const LoadSpectrum spectrum = spectrum_of(question, load, place, {});
    return {spectrum.through(Path(question, causes)), spectrum.interval()};
  }
  const auto row =
      HalfRow::make(lattice_of(question, causes), stage_of(question.stage, causes), question.kind, question.direction);
  const TimeSteps time = time_of(question.stage, causes);
  const LoadSpectrum spectrum = spectrum_of(question, load, place, row->load_filter());
  const auto transfer = [&](Complex s) { return time.elastic_share(s) * row->traction(time.square(s), place.joint); };
  return {spectrum.through(transfer), spectrum.interval()};
}

class Reader {
 public:
  Reader(const WaveQuestion& question, const LoadHistory& load)
      : question_(question), load_(load), place_(place_of(question)) {}

  [[nodiscard]] const Place& place() const { return place_; }

  [[nodiscard]] std::optional<ArrivalErrors> read(Causes causes) const {
    return read(causes, trace_of(question_, load_, place_, causes));
  }

  // `causes`: that have made the trace.
  [[nodiscard]] std::optional<ArrivalErrors> read(Causes causes, const Trace& trace,
                                                  OtherParts others = OtherParts::ignored) const {
    const double due = on_time(question_, place_);
    const auto exact = [&](double t) { return t > due ? load_.value(t - due) : 0.0; };
    return read_arrival(trace.values, trace.interval, exact, due, load_.period,
                        lags_of(changed(causes), place_.distance, load_.period), load_.seen_until(), others);
  }

 private:
  [[nodiscard]] WaveQuestion changed(Causes causes) const {
    WaveQuestion question = question_;
    question.lattice = lattice_of(question_, causes);
    return question;
  }

  const WaveQuestion& question_;
  const LoadHistory& load_;
  Place place_;
};

}  // namespace

// A run knows its own time, at the start of which there is nothing to sharpen.
double filtered(const LoadFilter& filter, const LoadHistory& load, double time) {
  return filter([&](double t) { return load.value(t - load.start); }, load.start + time);
}

bool is_seen(const LoadHistory& load, double on_time, const Lags& lags) {
  constexpr double as_long = 0.98;  // of the run: it stays on, and has no half
  const double needed = load.duration < as_long * load.run ? load.duration / 2 : 0;
  return load.run > on_time + lags.latest + needed;
}

double window_of(const LoadHistory& load, double on_time, const Lags& lags) {
  if (load.window > 0) return load.window;
  const double late = std::max(0.2 * on_time, lags.latest);
  const double passed = on_time + late + load.duration + load.period;
  return is_seen(load, on_time, lags) ? std::min(passed, load.run) : passed;
}

TimeSteps time_of(const Stage& stage, Causes causes) {
  if (!has_steps(causes)) return {};
  if (causes == Causes::time) return {stage.integrator, stage.dt};
  return {stage.integrator, stage.dt, stage.material_damping, kept_in_step(stage)};
}

Stage stage_of(Stage stage, Causes causes) {
  if (!has_steps(causes)) stage.correct_time_dispersion = false;
  return stage;
}

std::optional<SteadyErrors> steady_errors(const WaveQuestion& question, double frequency) {
  const double omega = 2 * std::numbers::pi * frequency;
  if (omega * question.stage.dt >= std::numbers::pi) return std::nullopt;
  const auto read = [&](Causes causes) { return steady(question, omega, causes); };
  const auto readings = read_by_cause(question.stage, has_springs(question.lattice), read);
  if (!readings) return std::nullopt;
  return SteadyErrors{readings->speed(), readings->amplitude()};
}

PredictedTrace predict_trace(const WaveQuestion& question, const LoadHistory& load) {
  const Place place = place_of(question);
  Trace trace = trace_of(question, load, place, Causes::all);
  return {std::move(trace.values), trace.interval, place.distance, place.with_end};
}

std::optional<TotalErrors> total_steady_errors(const WaveQuestion& question, double frequency) {
  const double omega = 2 * std::numbers::pi * frequency;
  if (omega * question.stage.dt >= std::numbers::pi) return std::nullopt;
  return steady(question, omega, Causes::time);
}

std::optional<TotalErrors> total_history_errors(const WaveQuestion& question, const LoadHistory& load) {
  const auto read = Reader(question, load).read(Causes::time);
  if (!read) return std::nullopt;
  return TotalErrors{read->speed, read->amplitude};
}

std::optional<ArrivalErrors> read_other(const WaveQuestion& question, const LoadHistory& load,
                                        const std::vector<double>& trace, double interval) {
  return Reader(question, load).read(Causes::all, {trace, interval}, OtherParts::compared);
}

WaveTiming timing_of(const WaveQuestion& question, const LoadHistory& load) {
  const Place place = place_of(question);
  const Lags lags = lags_of(question, place.distance, load.period);
  return {on_time(question, place) + lags.latest, window_at(question, load, place)};
}

HistoryErrors HistoryErrors::with_sides(const ArrivalErrors& readings) const {
  HistoryErrors errors = *this;
  errors.speed.sides = readings.speed - speed.total();
  errors.amplitude.sides = readings.amplitude - amplitude.total();
  errors.arrival = readings;
  return errors;
}

std::optional<HistoryErrors> history_errors(const WaveQuestion& question, const LoadHistory& load) {
  const Reader reader(question, load);
  const auto readings =
      read_by_cause(question.stage, has_springs(question.lattice), [&](Causes causes) { return reader.read(causes); });
  if (!readings) return std::nullopt;
  return HistoryErrors{readings->speed(), readings->amplitude(), readings->all, reader.place().distance,
                       reader.place().with_end};
}

}  // namespace dda
