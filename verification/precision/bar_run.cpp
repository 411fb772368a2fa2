#include "verification/precision/bar_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "verification/exact/signal.h"
#include "verification/harness/recorded_run.h"
#include "verification/precision/scheme_settings.h"
#include "verification/thesis/bar_scene.h"
#include "verification/yardstick/explicit_bar.h"

namespace verify {
namespace {

const ThesisBar& thesis_bar() { return thesis_reference().bar; }

int steps_of(double dt) { return static_cast<int>(std::ceil(bar_window() / dt)); }

double exact_stress(Problem problem, double t) {
  const ThesisBar& bar = thesis_bar();
  return -bar.incident_stress() * bar_pulse(problem, t - bar.measuring_point / bar.wave_speed());
}

// The factor by which the lagging exact wave fits the signal best, in least squares.
double fitted_amplitude(Problem problem, const exact::Signal& signal, double lag) {
  double both = 0, square = 0;
  for (std::size_t i = 0; i < signal.values.size(); ++i) {
    const double reference = exact_stress(problem, signal.time(i) - lag);
    both += signal.values[i] * reference;
    square += reference * reference;
  }
  return both / square;
}

double reading_error(Problem problem, const std::vector<double>& history, double dt) {
  constexpr double longest_interval = 2e-5;  // s; what lies closer tells nothing more
  const double period = 1 / thesis_bar().load_frequency;
  const auto stride = static_cast<std::size_t>(std::max(1.0, std::floor(longest_interval / dt)));
  std::vector<double> samples;
  for (std::size_t i = 0; i < history.size(); i += stride) samples.push_back(history[i]);
  const exact::Signal signal{samples, dt * static_cast<double>(stride), 0};
  if (period / dt < 8) return std::numeric_limits<double>::quiet_NaN();
  const double limit = 0.45 * period;
  const double lag = exact::correlation_lag(
                         signal, [&](double t) { return exact_stress(problem, t); }, -limit, limit)
                         .lag;
  if (std::abs(lag) > 0.99 * limit) return std::numeric_limits<double>::quiet_NaN();
  const double on_time = thesis_bar().measuring_point / thesis_bar().wave_speed();
  return std::max(std::abs(lag / (on_time + lag)), std::abs(fitted_amplitude(problem, signal, lag) - 1));
}

// Straight lines through the samples at the ends of steps; the engine looks at no other times.
dda::PiecewiseLinear load_table(const PrecisionJob& job) {
  dda::PiecewiseLinear table;
  for (int i = 0; i <= steps_of(job.dt); ++i) {
    table.times.push_back(i * job.dt);
    table.values.push_back(bar_pulse(job.problem, i * job.dt));
  }
  return table;
}

PrecisionResult run_yardstick(const PrecisionJob& job) {
  const ThesisBar& bar = thesis_bar();
  const int elements = static_cast<int>(std::lround(bar.length / job.size));
  const int steps = steps_of(job.dt);
  constexpr int repeated = 20;  // one run may take no more than the clock can tell, 1 us
  std::vector<double> history;
  history.reserve(static_cast<std::size_t>(steps) + 1);
  const double start = cpu_seconds();
  for (int n = 0; n < repeated; ++n) {
    history.clear();
    yardstick::ExplicitBar run({bar.density, bar.young, bar.height, bar.length, elements}, job.dt);
    for (int i = 0; i <= steps; ++i) {
      history.push_back(run.stress_at_node(elements / 2));
      run.step(bar.load_amplitude * bar_pulse(job.problem, i * job.dt));
    }
  }
  const double cpu_s = (cpu_seconds() - start) / repeated;
  const HistoryErrors errors = bar_errors(job.problem, history, job.dt);
  return {errors.l2, errors.reading, elements, static_cast<double>(steps), 0, 0, cpu_s};
}

}  // namespace

double bar_pulse(Problem problem, double t) {
  const double angle = 2 * std::numbers::pi * thesis_bar().load_frequency * t;
  if (t <= 0 || angle >= 2 * std::numbers::pi) return 0;
  return std::sin(angle) * (problem == Problem::bar_cycle ? 1 : (1 - std::cos(angle)) / 2);
}

double bar_window() {
  const ThesisBar& bar = thesis_bar();
  return (bar.length / bar.wave_speed()) + 0.5 / bar.load_frequency;
}

HistoryErrors bar_errors(Problem problem, const std::vector<double>& history, double dt) {
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const double exact = exact_stress(problem, static_cast<double>(i) * dt);
    difference += std::pow(history[i] - exact, 2);
    size += exact * exact;
  }
  return {std::sqrt(difference / size), reading_error(problem, history, dt)};
}

dda::Model bar_model(const PrecisionJob& job) {
  SchemeSettings scheme;
  scheme.name = job.scheme.name();
  scheme.joint = joint_of(job.scheme);
  scheme.stage = stage_of(job.scheme);
  const ThesisBar& bar = thesis_bar();
  dda::Model model = bar_scene(bar, scheme, {job.dt, job.size, bar.length, steps_of(job.dt) * job.dt});
  model.edge_loads.front().history = load_table(job);
  dda::finish_model(model);
  return model;
}

PrecisionResult run_bar(const PrecisionJob& job) {
  if (job.scheme.is_yardstick()) return run_yardstick(job);
  const dda::Model model = bar_model(job);
  const RecordedRun run = record_run(model);
  return result_of(run, model, bar_errors(job.problem, run.histories.front(), job.dt));
}

}  // namespace verify
