#include "engine/advice/load_history.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <variant>
#include <vector>

#include "engine/advice/load_trace.h"
#include "engine/model/quantity_names.h"
#include "engine/model/stage_times.h"

namespace dda {
namespace {

constexpr double most_samples = 20000;
constexpr double quiet = 1e-3;  // of the largest value

double shortest_step(const Model& model) {
  double step = std::numeric_limits<double>::infinity();
  for (const Stage& stage : model.stages)
    if (!stage.paces_itself()) step = std::min(step, stage.dt);
  return step;
}

// Up to the last time its absolute value is above a thousandth of the largest.
double duration_of(const std::vector<double>& samples, double interval) {
  double largest = 0;
  for (const double value : samples) largest = std::max(largest, std::abs(value));
  std::size_t last = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (std::abs(samples[i]) > quiet * largest) last = i;
  return static_cast<double>(last) * interval;
}

// s, of which the steepest rise to the largest value is a quarter: what rises and stays has no frequency of its own.
// Infinite for what does not stay.
double period_of_rise(const std::vector<double>& samples, double interval) {
  double largest = 0, steepest = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    largest = std::max(largest, std::abs(samples[i]));
    if (i > 0) steepest = std::max(steepest, (std::abs(samples[i]) - std::abs(samples[i - 1])) / interval);
  }
  const bool stays = !samples.empty() && std::abs(samples.back()) > largest / 2;
  return stays && steepest > 0 ? 4 * largest / steepest : std::numeric_limits<double>::infinity();
}

// The last end of a step at or before that time, s: a run samples its loads there, so that kinks lie between samples as
// they do in the run. Of stages that pace themselves the time itself.
double step_before(const Model& model, double time) {
  double begin = 0;
  for (const Stage& stage : model.stages) {
    if (time < begin + stage.duration)
      return stage.paces_itself() ? time : begin + std::floor((time - begin) / stage.dt + 1e-9) * stage.dt;
    begin += stage.duration;
  }
  return time;
}

// From where the history begins to the end of the run; `value` of a time in the run.
template <typename Value>
LoadHistory history_of(const Model& model, const TimeFunction& function, const Value& value) {
  const double begun = start_of(function);
  const double start = begun > 0 && begun < end_of_run(model) ? step_before(model, begun) : 0;
  const double end = end_of_run(model) - start;
  const double interval = std::max(shortest_step(model), end / most_samples);
  std::vector<double> samples;
  for (double t = 0; t <= end; t += interval) samples.push_back(value(start + t));
  LoadHistory history;
  history.value = [=](double t) { return t < 0 || t > end ? 0 : value(start + t); };
  history.start = start;
  history.run = end;
  const auto* sine = std::get_if<SineCycles>(&function);
  const double last = sine != nullptr ? begun - start + sine->cycles / sine->frequency : duration_of(samples, interval);
  history.duration = std::min(last, end);
  const double slowest = history.duration > 0 ? 0.5 / history.duration : 0.5 / end;
  const double frequency = sine != nullptr ? sine->frequency : LoadSpectrum(samples, interval).main_frequency();
  history.period = frequency > slowest ? 1 / frequency : std::min(1 / slowest, period_of_rise(samples, interval));
  return history;
}

std::string description_of(const Model& model, int block, const TimeFunction& function, double period,
                           const char* what) {
  return fmt::format("on block \"{}\"{}: {}, main frequency {:.4g} Hz",
                     model.blocks[static_cast<std::size_t>(block)].name, what, words_for(function), 1 / period);
}

template <typename Load>
std::optional<SceneLoad> load_of(const Model& model, const Load& load, const Vec2& place, const Vec2& force) {
  if (std::holds_alternative<Constant>(load.history)) return std::nullopt;
  const auto value = [history = load.history](double t) { return evaluate(history, t); };
  const LoadHistory history = history_of(model, load.history, value);
  return SceneLoad{
      history,    &load.history, place,        description_of(model, load.block, load.history, history.period, ""),
      load.block, force,         Vec2::Zero(), place};
}

// A wave carries the velocity of what moves: a displacement's history is differentiated, an acceleration's integrated.
template <typename Motion>
std::optional<SceneLoad> motion_of(const Model& model, const Motion& motion, const Vec2& place) {
  if (std::holds_alternative<Constant>(motion.history) || motion.amplitude.isZero(0)) return std::nullopt;
  const auto factors = [kind = motion.kind, history = motion.history](double t) { return motion_at(kind, history, t); };
  LoadHistory history = history_of(model, motion.history, [=](double t) { return factors(t).velocity; });
  const double start = history.start;
  history.displacement = [=](double t) {
    return t < 0 ? 0 : factors(start + t).displacement - factors(start).displacement;
  };
  return SceneLoad{
      history,      &motion.history,
      place,        description_of(model, motion.block, motion.history, history.period, ", which is moved"),
      motion.block, motion.amplitude,
      Vec2::Zero(), place};
}

std::optional<SceneLoad> first_drive(const Model& model) {
  for (const EdgeLoad& load : model.edge_loads)
    if (auto found = load_of(model, load, (load.from + load.to) / 2, load.traction)) {
      const Vec2 edge = (load.to - load.from).normalized();
      const Vec2 normal(-edge.y(), edge.x());
      const Vec2 inwards = model.blocks[static_cast<std::size_t>(load.block)].moments.centroid - found->place;
      found->face = inwards.dot(normal) < 0 ? Vec2(-normal) : normal;
      return found;
    }
  for (const PointLoad& load : model.point_loads)
    if (auto found = load_of(model, load, load.point, load.force)) return found;
  for (const PointSupport& support : model.supports)
    if (auto found = motion_of(model, support, support.point)) return found;
  for (const HeldBlock& held : model.held_blocks)
    if (auto found = motion_of(model, held, model.blocks[static_cast<std::size_t>(held.block)].moments.centroid))
      return found;
  return std::nullopt;
}

}  // namespace

// What a load does before it begins says nothing of its wave, and would be counted as
// a part of it: after a static stage that may be the longest part by far.
double start_of(const TimeFunction& function) {
  if (const auto* sine = std::get_if<SineCycles>(&function)) return sine->start;
  if (const auto* decay = std::get_if<ExponentialDecay>(&function)) return decay->start;
  if (const auto* record = std::get_if<Recorded>(&function)) return record->start;
  const auto* table = std::get_if<PiecewiseLinear>(&function);
  if (table == nullptr) return 0;
  const auto first = std::ranges::find_if(table->values, [](double value) { return value != 0; });
  if (first == table->values.begin() || first == table->values.end()) return 0;
  return table->times[static_cast<std::size_t>(first - table->values.begin()) - 1];
}

std::string words_for(const TimeFunction& history) {
  if (const auto* sine = std::get_if<SineCycles>(&history))
    return std::isfinite(sine->cycles) ? fmt::format("sine of {:.6g} Hz, cycles: {:.6g}", sine->frequency, sine->cycles)
                                       : fmt::format("a sine of {:.6g} Hz without end", sine->frequency);
  if (const auto* table = std::get_if<PiecewiseLinear>(&history))
    return fmt::format("a table of {} points", table->times.size());
  if (const auto* decay = std::get_if<ExponentialDecay>(&history))
    return fmt::format("a pulse that decays in {:.6g} s", decay->decay_time);
  return std::holds_alternative<Constant>(history) ? "constant" : "a record";
}

Vec2 way_of(const SceneLoad& load) {
  if (!load.face.isZero(0)) return load.face;
  const Vec2 way = load.looked_at - load.place;
  return way.isZero(0) ? way : Vec2(way.normalized());
}

std::optional<SceneLoad> scene_load(const Model& model) {
  auto load = first_drive(model);
  if (!load) return std::nullopt;
  for (const Measurement& measurement : model.measurements)
    if (is_at_point(measurement) && (measurement.point - load->place).norm() > (load->looked_at - load->place).norm())
      load->looked_at = measurement.point;
  return load;
}

std::optional<double> highest_sine_frequency(const Model& model) {
  std::optional<double> highest;
  const auto visit = [&](const TimeFunction& history) {
    if (const auto* sine = std::get_if<SineCycles>(&history)) highest = std::max(highest.value_or(0), sine->frequency);
  };
  for (const PointLoad& load : model.point_loads) visit(load.history);
  for (const EdgeLoad& load : model.edge_loads) visit(load.history);
  for (const PointSupport& support : model.supports) visit(support.history);
  for (const HeldBlock& held : model.held_blocks) visit(held.history);
  return highest;
}

}  // namespace dda
