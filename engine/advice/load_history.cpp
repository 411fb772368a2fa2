#include "engine/advice/load_history.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>
#include <vector>

#include "engine/advice/load_trace.h"

namespace dda {
namespace {

constexpr double most_samples = 20000;
constexpr double quiet = 1e-3;  // of the largest value

double end_of_run(const Model& model) {
  double end = 0;
  for (const Stage& stage : model.stages) end += stage.duration;
  return end;
}

double shortest_step(const Model& model) {
  double step = model.stages.front().dt;
  for (const Stage& stage : model.stages) step = std::min(step, stage.dt);
  return step;
}

std::string words_for(const TimeFunction& history) {
  if (const auto* sine = std::get_if<SineCycles>(&history))
    return std::isfinite(sine->cycles) ? fmt::format("sine of {:.6g} Hz, cycles: {:.6g}", sine->frequency, sine->cycles)
                                       : fmt::format("a sine of {:.6g} Hz without end", sine->frequency);
  if (const auto* table = std::get_if<PiecewiseLinear>(&history))
    return fmt::format("a table of {} points", table->times.size());
  if (const auto* decay = std::get_if<ExponentialDecay>(&history))
    return fmt::format("a pulse that decays in {:.6g} s", decay->decay_time);
  return "a record";
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

// s, up to which a history is zero. What a load does before it begins says nothing of its wave, and would be counted as
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

LoadHistory history_of(const Model& model, const TimeFunction& function) {
  const double begun = start_of(function);
  const double start = begun > 0 && begun < end_of_run(model) ? begun : 0;
  const double end = end_of_run(model) - start;
  const double interval = std::max(shortest_step(model), end / most_samples);
  std::vector<double> samples;
  for (double t = 0; t <= end; t += interval) samples.push_back(evaluate(function, start + t));
  LoadHistory history;
  history.value = [=](double t) { return t < 0 || t > end ? 0 : evaluate(function, start + t); };
  const auto* sine = std::get_if<SineCycles>(&function);
  const double last = sine != nullptr ? sine->cycles / sine->frequency : duration_of(samples, interval);
  history.duration = std::min(last, end);
  const double slowest = history.duration > 0 ? 0.5 / history.duration : 0.5 / end;
  history.period =
      1 / (sine != nullptr ? sine->frequency : std::max(LoadSpectrum(samples, interval).main_frequency(), slowest));
  return history;
}

template <typename Load>
std::optional<SceneLoad> load_of(const Model& model, const Load& load, const Vec2& place) {
  if (std::holds_alternative<Constant>(load.history)) return std::nullopt;
  const LoadHistory history = history_of(model, load.history);
  const std::string& block = model.blocks[static_cast<std::size_t>(load.block)].name;
  return SceneLoad{
      history, place,
      fmt::format("on block \"{}\": {}, main frequency {:.4g} Hz", block, words_for(load.history), 1 / history.period)};
}

}  // namespace

std::optional<SceneLoad> scene_load(const Model& model) {
  for (const EdgeLoad& load : model.edge_loads)
    if (auto found = load_of(model, load, (load.from + load.to) / 2)) return found;
  for (const PointLoad& load : model.point_loads)
    if (auto found = load_of(model, load, load.point)) return found;
  return std::nullopt;
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
