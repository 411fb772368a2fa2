#include "verification/sweep/job.h"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "engine/advice/wave_errors.h"
#include "engine/contact/make_contacts.h"
#include "verification/exact/chain_modes.h"
#include "verification/exact/finite_chain.h"
#include "verification/exact/half_chain.h"
#include "verification/exact/sharpened_load.h"
#include "verification/exact/signal.h"
#include "verification/harness/histories.h"
#include "verification/harness/recorded_run.h"
#include "verification/study/values.h"
#include "verification/sweep/sweep_bar.h"
#include "verification/thesis/closed_form.h"

namespace verify {
namespace {

constexpr double fewest_samples = 4;  // in a period
constexpr double longest_lag = 0.45;  // of a period: half a period on, a tone looks the same but for its sign

double percent(double value, double reference) { return 100 * (value / reference - 1); }

double reference_stress(const ThesisBar& bar, Pulse pulse, double t) {
  return -bar.incident_stress() * pulse_shape(pulse, bar.load_frequency, t - bar.measuring_point / bar.wave_speed());
}

std::vector<double> sampled_reference(const ThesisBar& bar, Pulse pulse, const exact::Signal& signal, double lag) {
  std::vector<double> reference(signal.values.size());
  for (std::size_t i = 0; i < reference.size(); ++i) reference[i] = reference_stress(bar, pulse, signal.time(i) - lag);
  return reference;
}

// The factor on the reference that fits the signal best.
double fitted_amplitude(const exact::Signal& signal, const std::vector<double>& reference) {
  double both = 0, square = 0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    both += signal.values[i] * reference[i];
    square += reference[i] * reference[i];
  }
  return both / square;
}

WaveErrors wave_errors(const dda::Model& model, const ThesisBar& bar, double omega) {
  const dda::Stage& stage = model.stages.front();
  const exact::ChainWave wave = exact::chain_wave(chain_of(model), time_scheme_of(stage.integrator), stage.dt, omega);
  return {percent(wave.speed, bar.wave_speed()), 100 * std::expm1(-wave.attenuation * bar.measuring_point)};
}

// What the end makes of the load and the way to the measuring point of the wave.
WaveErrors steady_errors(const dda::Model& model, const ThesisBar& bar, double omega) {
  const dda::Stage& stage = model.stages.front();
  const exact::BlockChain chain = chain_of(model);
  const double sharpening = 4 * exact::load_sharpening(chain, stage.dt) * std::pow(std::sin(omega * stage.dt / 2), 2);
  const std::complex<double> force(exact::half_chain_force(chain, time_scheme_of(stage.integrator), stage.dt, omega,
                                                           model.measurements.front().block) *
                                   exact::Real(1 + sharpening));
  const double on_time = bar.measuring_point / bar.wave_speed();
  const double lag = -std::arg(force * std::polar(1.0, omega * on_time)) / omega;
  return {percent(on_time, on_time + lag), 100 * (std::abs(force) - 1)};
}

std::vector<double> closed_form_stress(const dda::Model& model, const ThesisBar& bar, const JobParameters& parameters) {
  const exact::ChainProbe probe{exact::ChainQuantity::interface_stress, model.measurements.front().block - 1};
  const exact::BlockChain chain = chain_of(model);
  const std::vector<double> load =
      exact::sharpened(sampled_force(bar, parameters), exact::load_sharpening(chain, parameters.dt));
  return exact::finite_chain_response(chain, time_scheme_of(parameters.stage.integrator), parameters.dt, load, {probe})
      .front();
}

void expect_samples(const JobParameters& parameters) {
  if (parameters.samples_per_period() < fewest_samples)
    throw NotMeasurable(fmt::format("time steps of {:.4g} s are {:.2g} to a period of the load; {:g} are needed",
                                    parameters.dt, parameters.samples_per_period(), fewest_samples));
}

// With long time steps a history may have no change of sign before its peak.
std::optional<double> onset_error(const exact::Signal& signal, double on_time) {
  try {
    return percent(on_time, exact::onset(signal, exact::Polarity::negative));
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace

WaveReadings read_wave(const ThesisBar& bar, Pulse pulse, const std::vector<double>& history, double dt) {
  const double end = pulse_window(bar, pulse);
  const exact::Signal signal = exact::window({history, dt, 0}, 0, end);
  const double limit = longest_lag / bar.load_frequency;
  const double lag = exact::correlation_lag(
                         signal, [&](double t) { return reference_stress(bar, pulse, t); }, -limit, limit)
                         .lag;
  if (std::abs(lag) > 0.99 * limit)
    throw NotMeasurable(fmt::format("the wave is {} of a period or more off its time", longest_lag));
  const std::vector<double> reference = sampled_reference(bar, pulse, signal, lag);
  const double on_time = bar.measuring_point / bar.wave_speed();
  WaveReadings readings;
  readings.errors = {percent(on_time, on_time + lag), 100 * (fitted_amplitude(signal, reference) - 1)};
  readings.half_range = percent(exact::half_range(signal, 0, end), exact::half_range({reference, dt, 0}, 0, end));
  if (pulse == Pulse::cycle) readings.onset_velocity = onset_error(signal, on_time);
  return readings;
}

std::optional<WaveErrors> predict(const JobParameters& parameters) {
  const ThesisBar bar = bar_of(parameters);
  const dda::Model model = model_of(bar, parameters);
  const auto lattice = dda::find_lattice(model, dda::make_contacts(model), 0);
  if (!lattice) return std::nullopt;
  const dda::WaveQuestion question{*lattice, model.stages.front(), dda::WaveKind::bar, {1, 0}, bar.measuring_point};
  const auto value = [&](double t) { return pulse_shape(parameters.pulse, bar.load_frequency, t); };
  const dda::LoadHistory load{value, pulse_duration(parameters.pulse, bar.load_frequency), 1 / bar.load_frequency,
                              pulse_window(bar, parameters.pulse)};
  const auto errors = dda::total_history_errors(question, load);
  if (!errors) return std::nullopt;
  return WaveErrors{100 * errors->speed, 100 * errors->amplitude};
}

JobResult run_job(const JobParameters& parameters, bool closed_form) {
  expect_samples(parameters);
  const ThesisBar bar = bar_of(parameters);
  const dda::Model model = model_of(bar, parameters);
  const RecordedRun run = record_run(model);
  JobResult result;
  result.place = bar.measuring_point;
  result.setup_cpu_s = run.setup_cpu_s;
  result.cpu_s = run.cpu_s;
  result.counters = run.counters;
  result.measured = read_wave(bar, parameters.pulse, run.histories.front(), parameters.dt);
  const double omega = 2 * std::numbers::pi * bar.load_frequency;
  result.predicted = predict(parameters);
  result.steady = steady_errors(model, bar, omega);
  result.wave = wave_errors(model, bar, omega);
  if (!closed_form) return result;
  const std::vector<double> exact = closed_form_stress(model, bar, parameters);
  result.closed_form = read_wave(bar, parameters.pulse, exact, parameters.dt).errors;
  result.largest_difference = largest_difference(run.histories.front(), exact);
  return result;
}

nlohmann::ordered_json to_json(const JobResult& result) {
  const WaveErrors& measured = result.measured.errors;
  const auto predicted = [&](double WaveErrors::*error) {
    return or_null(result.predicted ? std::optional((*result.predicted).*error) : std::nullopt);
  };
  const auto agrees = [&](double WaveErrors::*error) {
    return result.predicted && agree(measured.*error, (*result.predicted).*error);
  };
  const auto of_form = [&](double WaveErrors::*error) {
    return or_null(result.closed_form ? std::optional((*result.closed_form).*error) : std::nullopt);
  };
  nlohmann::ordered_json json = {{"place", result.place},
                                 {"velocity_error_pct", measured.velocity},
                                 {"predicted_velocity_error_pct", predicted(&WaveErrors::velocity)},
                                 {"velocity_agrees", agrees(&WaveErrors::velocity)},
                                 {"amplitude_error_pct", measured.amplitude},
                                 {"predicted_amplitude_error_pct", predicted(&WaveErrors::amplitude)},
                                 {"amplitude_agrees", agrees(&WaveErrors::amplitude)},
                                 {"steady_velocity_error_pct", result.steady.velocity},
                                 {"steady_amplitude_error_pct", result.steady.amplitude},
                                 {"wave_velocity_error_pct", result.wave.velocity},
                                 {"wave_amplitude_error_pct", result.wave.amplitude},
                                 {"closed_form_velocity_error_pct", of_form(&WaveErrors::velocity)},
                                 {"closed_form_amplitude_error_pct", of_form(&WaveErrors::amplitude)},
                                 {"closed_form_difference", or_null(result.largest_difference)},
                                 {"half_range_error_pct", result.measured.half_range},
                                 {"onset_velocity_error_pct", or_null(result.measured.onset_velocity)},
                                 {"setup_cpu_s", result.setup_cpu_s},
                                 {"cpu_s", result.cpu_s}};
  add_counters(result.counters, json);
  return json;
}

bool agree(double measured, double predicted) {
  const double difference = std::abs(measured - predicted);
  return difference <= 0.2 * std::abs(measured) || difference <= 0.05;
}

}  // namespace verify
