#include "engine/advice/chain_errors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/advice/load_trace.h"

namespace dda {
namespace {

constexpr double most_samples = 2048;  // of a trace
// Samples of what should come in one of what comes, and at least in a period: kinks of a load are rounded over a
// sample, and layers put them anywhere between two.
constexpr int finer = 8, finest = 1600;
// Growth of motion in a radian in which a wave comes as it would in endless layers, and in which it is as good as
// steady.
constexpr double straight = 0.1, steady_enough = 0.01;

// A history that runs straight from sample to sample and is zero outside of them.
class Sampled {
 public:
  Sampled(std::vector<double> values, double interval) : values_(std::move(values)), interval_(interval) {}
  double operator()(double t) const {
    const double place = t / interval_;
    if (place < 0 || place >= static_cast<double>(values_.size() - 1)) return 0;
    const auto i = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(i);
    return (1 - share) * values_[i] + share * values_[i + 1];
  }

 private:
  std::vector<double> values_;
  double interval_;
};

template <typename Value>
std::vector<double> sampled(const Value& value, double window, double interval) {
  std::vector<double> samples(static_cast<std::size_t>(std::floor(window / interval + 1e-6)) + 1);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = value(static_cast<double>(i) * interval);
  return samples;
}

}  // namespace

ChainQuestion::ChainQuestion(const Model& model, const ChainPath& path, const Stage& stage, double distance)
    : model_(&model), path_(path), stage_(stage), joint_(path.joint_near(distance)) {}

ChainQuestion ChainQuestion::with_dt(double dt) const {
  ChainQuestion question = *this;
  question.stage_.dt = dt;
  question.chains_ = {};
  return question;
}

const Chain& ChainQuestion::chain(Causes causes) const {
  auto& chain = chains_[static_cast<std::size_t>(std::min(causes, Causes::time))];  // damping changes no matrix
  if (chain) return *chain;
  chain = std::make_shared<const Chain>(*model_, path_, stage_of(stage_, causes), causes == Causes::blocks);
  return *chain;
}

// What comes back from farther layers is too late for the window.
int ChainQuestion::layers_for(double window) const {
  const double reach = (path_.distance_of(joint_) + fastest() * window) / 2 + path_.layers.front().thickness;
  const int layers = path_.layers_within(std::max(reach, 1.2 * path_.distance_of(joint_)));
  return std::min(std::max(layers, joint_ + 2), static_cast<int>(path_.layers.size()));
}

// Divides the force that comes by the one that should, in motion that grows by that share of itself in a radian: what
// has run to and fro between layers is older than what comes straight, and counts the less the faster motion grows.
Complex ChainQuestion::ratio(Causes causes, double omega, double growth, int layers) const {
  const Complex s(growth * omega, omega);
  return force(causes, s, layers) / exact_force(path_, s, joint_, layers);
}

// A place that is moved moves on whatever damping makes of the forces that it takes.
Complex ChainQuestion::force(Causes causes, Complex s, int layers) const {
  const TimeSteps time = time_of(stage_, causes);
  const Complex force = chain(causes).force(time.square(s), joint_, layers);
  return path_.is_moved ? force : time.elastic_share(s) * force;
}

// The phase is followed from low frequencies on, as it may be late by many turns. What comes straight is followed:
// where layers send back so much that hardly anything comes, the phase of all turns by half a turn within no frequency,
// which is no delay of anything. Steady motion then has the nearest turn.
ChainQuestion::Phase ChainQuestion::phase(Causes causes, double omega) const {
  const double due = path_.time_to(joint_);
  const int layers = layers_for(3 * due + 6 * std::numbers::pi / omega);
  const int rounds = 8 + static_cast<int>(std::ceil(4 * omega * due));
  Phase phase;
  Complex last(1, 0);
  for (int i = 1; i <= rounds; ++i) {
    const double frequency = omega * i / rounds;
    const Complex now = ratio(causes, frequency, straight, layers);
    const double change = -std::arg(now / last);
    phase.angle += change;
    phase.lags.include(phase.angle / frequency);
    if (i > rounds / 2) phase.lags.include(change / (omega / rounds));  // of the group
    last = now;
  }
  phase.lags.earliest = std::max(phase.lags.earliest, -0.9 * due);
  const Complex all = ratio(causes, omega, steady_enough, layers);
  phase.angle -= std::arg(all / last);
  phase.amplitude = std::abs(all);
  return phase;
}

std::optional<TotalErrors> ChainQuestion::steady(Causes causes, double frequency) const {
  const double omega = 2 * std::numbers::pi * frequency;
  if (has_steps(causes) && omega * stage_.dt >= std::numbers::pi) return std::nullopt;
  const double due = path_.time_to(joint_);
  const Phase found = phase(causes, omega);
  const double late = found.angle / omega;
  if (!std::isfinite(late) || !(due + late > 0)) return std::nullopt;
  return TotalErrors{due / (due + late) - 1, found.amplitude - 1};
}

std::optional<TotalErrors> ChainQuestion::total_steady_errors(double frequency) const {
  return steady(Causes::time, frequency);
}

std::optional<SteadyErrors> ChainQuestion::steady_errors(double frequency) const {
  const auto readings = read_by_cause(stage_, true, [&](Causes causes) { return steady(causes, frequency); });
  if (!readings) return std::nullopt;
  return SteadyErrors{readings->speed(), readings->amplitude()};
}

// What comes at the joint, and what should.
struct ChainQuestion::Traces {
  std::vector<double> found;
  double interval = 0;  // s
  std::function<double(double)> exact;
};

// Returns how long histories are compared, s: as long as the run, as what runs to and fro between layers comes late,
// but not until anything comes back from the far end of the way.
double ChainQuestion::window_for(const LoadHistory& load, const Lags& lags) const {
  const double needed = window_of(load, path_.time_to(joint_), lags);
  if (!is_seen(load, path_.time_to(joint_), lags)) return needed;
  const double echo = 2 * path_.time_to(static_cast<int>(path_.layers.size())) - path_.time_to(joint_);
  return std::min(load.run, std::max(needed, echo));
}

double ChainQuestion::fastest() const {
  double fastest = 0;
  for (const ChainLayer& layer : path_.layers) fastest = std::max(fastest, layer.speed);
  return fastest;
}

// s, between samples of what comes.
double ChainQuestion::interval_for(double window) const {
  return std::max(1.0, std::ceil(window / stage_.dt / most_samples)) * stage_.dt;
}

// s: a wave that is early is compared with what should come after the window.
double ChainQuestion::beyond(const LoadHistory& load, const Lags& lags) const {
  return load.period / 2 - lags.earliest;
}

ChainQuestion::Traces ChainQuestion::traces(Causes causes, const LoadHistory& load, const Lags& lags) const {
  const double window = window_for(load, lags);
  const double interval = interval_for(window);
  const int layers = layers_for(window + beyond(load, lags));
  const LoadSpectrum spectrum(sampled(drive(causes, load), window, interval), interval);
  Traces traces;
  traces.interval = interval;
  traces.found = spectrum.through([&](Complex s) { return integral(causes, s) * force(causes, s, layers); });
  traces.exact = exact(load, lags);
  return traces;
}

// What should come.
std::function<double(double)> ChainQuestion::exact(const LoadHistory& load, const Lags& lags) const {
  const double window = window_for(load, lags);
  const int layers = layers_for(window + beyond(load, lags));
  if (path_.is_of_one_rock(layers)) {
    // Tables of displacements have velocities that jump: their mean over a quarter of a step.
    return [&load, due = path_.time_to(joint_), wide = stage_.dt / 8, moved = path_.is_moved](double t) {
      if (t <= due) return 0.0;
      if (!moved) return load.value(t - due);
      return (load.displacement(t - due + wide) - load.displacement(t - due - wide)) / (2 * wide);
    };
  }
  const double fine = std::min(interval_for(window) / finer, load.period / finest);
  const LoadSpectrum spectrum(sampled(load.value, window + beyond(load, lags), fine), fine);
  return Sampled(spectrum.through([&](Complex s) {
    return (path_.is_moved ? 1.0 / s : 1.0) * exact_force(path_, s, joint_, layers);
  }),
                 fine);
}

// What the run is driven by: the load as it filters it; the velocity of what moves, under steps that of the whole step.
std::function<double(double)> ChainQuestion::drive(Causes causes, const LoadHistory& load) const {
  if (!path_.is_moved) {
    const LoadFilter filter = chain(causes).load_filter();
    return [=, &load](double t) { return filtered(filter, load, t); };
  }
  if (!has_steps(causes)) return load.value;
  return [&load, dt = stage_.dt](double t) { return (load.displacement(t) - load.displacement(t - dt)) / dt; };
}

// The factor that leads from the velocity that drive() gives to the displacement.
Complex ChainQuestion::integral(Causes causes, Complex s) const {
  if (!path_.is_moved) return 1;
  if (!has_steps(causes)) return 1.0 / s;
  return stage_.dt / (1.0 - std::exp(-s * stage_.dt));
}

std::optional<ArrivalErrors> ChainQuestion::read(Causes causes, const LoadHistory& load) const {
  const Lags between = lags(causes, load);
  const Traces found = traces(causes, load, between);
  return read_arrival(found.found, found.interval, found.exact, path_.time_to(joint_), load.period, between,
                      load.seen_until());
}

Lags ChainQuestion::lags(Causes causes, const LoadHistory& load) const {
  return phase(causes, 2 * std::numbers::pi / load.period).lags;
}

ChainQuestion::OtherTrace ChainQuestion::other_trace(const LoadHistory& load) const {
  const Lags between = lags(Causes::all, load);
  const WaveTiming timing{path_.time_to(joint_) + between.latest, window_for(load, between)};
  return {timing, [this, &load, between](const std::vector<double>& trace) {
            return read_arrival(trace, stage_.dt, exact(load, between), path_.time_to(joint_), load.period, between,
                                load.seen_until(), OtherParts::compared);
          }};
}

std::optional<TotalErrors> ChainQuestion::total_history_errors(const LoadHistory& load) const {
  const auto all = read(Causes::time, load);
  if (!all) return std::nullopt;
  return TotalErrors{all->speed, all->amplitude};
}

std::optional<HistoryErrors> ChainQuestion::history_errors(const LoadHistory& load) const {
  const auto readings = read_by_cause(stage_, true, [&](Causes causes) { return read(causes, load); });
  if (!readings) return std::nullopt;
  return HistoryErrors{readings->speed(), readings->amplitude(), readings->all, place(), true};
}

}  // namespace dda
