#include "verification/sweep/sweep_bar.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/thesis/bar_scene.h"
#include "verification/thesis/schemes.h"

namespace verify {
namespace {

constexpr double tone_cycles = 6;
constexpr double tone_bar_length = 200;  // m: the tone is 261 m long, and goes there and back from 50 m on

int steps_of(const ThesisBar& bar, const JobParameters& parameters) {
  return static_cast<int>(std::ceil(pulse_window(bar, parameters.pulse) / parameters.dt));
}

SchemeSettings scheme_of(const JobParameters& parameters) {
  SchemeSettings scheme;
  scheme.name = "sweep";
  scheme.joint = parameters.joint;
  scheme.stage = parameters.stage;
  return scheme;
}

// Straight lines through the samples; the engine looks at no other times.
dda::PiecewiseLinear table_of(const std::vector<double>& force, double amplitude, double dt) {
  dda::PiecewiseLinear table;
  for (std::size_t i = 0; i < force.size(); ++i) {
    table.times.push_back(static_cast<double>(i) * dt);
    table.values.push_back(force[i] / amplitude);
  }
  return table;
}

}  // namespace

ThesisBar bar_of(const JobParameters& parameters) {
  ThesisBar bar = thesis_reference().bar;
  const double length = parameters.block_length;
  const double wanted = parameters.pulse == Pulse::cycle ? bar.length : tone_bar_length;
  bar.poisson = parameters.poisson;
  bar.measuring_point = std::max(1.0, std::round(bar.measuring_point / length)) * length;
  bar.length = std::ceil(wanted / length - 1e-9) * length;
  return bar;
}

double pulse_duration(Pulse pulse, double frequency) { return (pulse == Pulse::cycle ? 1 : tone_cycles) / frequency; }

double pulse_shape(Pulse pulse, double frequency, double t) {
  const double duration = pulse_duration(pulse, frequency);
  if (t <= 0 || t >= duration) return 0;
  const double envelope = pulse == Pulse::cycle ? 1 : std::pow(std::sin(std::numbers::pi * t / duration), 2);
  return envelope * std::sin(2 * std::numbers::pi * frequency * t);
}

double pulse_window(const ThesisBar& bar, Pulse pulse) {
  const double passed = bar.measuring_point / bar.wave_speed() + pulse_duration(pulse, bar.load_frequency);
  return (passed + (2 * bar.length - bar.measuring_point) / bar.wave_speed()) / 2;
}

std::vector<double> sampled_force(const ThesisBar& bar, const JobParameters& parameters) {
  std::vector<double> force(static_cast<std::size_t>(steps_of(bar, parameters)) + 1);
  for (std::size_t i = 0; i < force.size(); ++i)
    force[i] =
        bar.load_amplitude * pulse_shape(parameters.pulse, bar.load_frequency, static_cast<double>(i) * parameters.dt);
  return force;
}

dda::Model model_of(const ThesisBar& bar, const JobParameters& parameters) {
  const double duration = steps_of(bar, parameters) * parameters.dt;
  dda::Model model =
      bar_scene(bar, scheme_of(parameters), {parameters.dt, parameters.block_length, bar.length, duration});
  model.edge_loads.front().history = table_of(sampled_force(bar, parameters), bar.load_amplitude, parameters.dt);
  dda::finish_model(model);
  return model;
}

}  // namespace verify
