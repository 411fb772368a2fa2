#include "engine/advice/unseen_loads.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <variant>

#include "engine/advice/history_span.h"
#include "engine/advice/load_history.h"

namespace dda {
namespace {

constexpr double too_much = 0.3;      // unseen: a sine with three steps in a period
constexpr double little = 0.1;        // six steps in a period
constexpr int most_steps = 4000;      // that are looked at, spread over the whole
constexpr int points = 8;             // in each, never twice at the same share of a step, and in all that is shorter
constexpr int most_points = 1000000;  // in a step

std::string name_of(const Model& model, int block) { return model.blocks[static_cast<std::size_t>(block)].name; }

class Findings {
 public:
  explicit Findings(const Model& model) : model_(model) {}

  template <typename Load>
  void add_load(const Load& load) {
    if (std::holds_alternative<Constant>(load.history)) return;
    add(load.history,
        fmt::format("the load on block \"{}\", {},", name_of(model_, load.block), words_for(load.history)),
        changing(load.history), [&](double t) { return evaluate(load.history, t); });
  }
  template <typename Motion>
  void add_motion(const Motion& motion) {
    if (std::holds_alternative<Constant>(motion.history) || motion.amplitude.isZero(0)) return;
    add(motion.history,
        fmt::format("the motion of block \"{}\", {},", name_of(model_, motion.block), words_for(motion.history)),
        changing(motion.history), [&](double t) { return motion_at(motion.kind, motion.history, t).displacement; });
  }
  [[nodiscard]] std::vector<LoadFinding> take() { return std::move(findings_); }

 private:
  template <typename Value>
  void add(const TimeFunction& history, const std::string& what, const HistorySpan& changes, const Value& value) {
    double begin = 0;
    for (std::size_t i = 0; i < model_.stages.size(); ++i) {
      const Stage& stage = model_.stages[i];
      const double from = std::max(changes.from, begin), to = std::min(changes.to, begin + stage.duration);
      // Whole steps of the stage: what lies beside the history is seen with it.
      if (!stage.integrator.is_static && from < to)
        add({static_cast<int>(i), &history, what}, to - from, value,
            begin + std::floor((from - begin) / stage.dt) * stage.dt,
            begin + std::ceil((to - begin) / stage.dt) * stage.dt);
      begin += stage.duration;
    }
  }

  // Edges of many blocks have one history, which is looked at once.
  template <typename Value>
  bool is_new(const Value& value, double from, double to) {
    std::array<double, 16> print{from, to};
    for (std::size_t i = 2; i < print.size(); ++i)
      print[i] = value(from + (to - from) * std::fmod(0.6180339887498949 * static_cast<double>(i), 1.0));
    return seen_.insert(print).second;
  }

  // `finding`: what is looked at, in place of its sentence.
  template <typename Value>
  void add(const LoadFinding& finding, double shortest, const Value& value, double from, double to) {
    const Stage& stage = model_.stages[static_cast<std::size_t>(finding.stage)];
    if (!is_new(value, from, to)) return;
    const double share = unseen_share(value, from, to, stage.dt, shortest);
    if (!(share > too_much)) return;
    double dt = stage.dt;
    for (int i = 0; i < 40 && unseen_share(value, from, to, dt, shortest) > little; ++i) dt /= 2;
    findings_.push_back(
        {finding.stage, finding.history,
         fmt::format("stage \"{}\": {} changes faster than steps of {:g} s can see: they miss {:.0f} % of it; dt of "
                     "{:.2g} s sees it",
                     stage.name, finding.sentence, stage.dt, std::min(100.0, 100 * share), dt)});
  }

  const Model& model_;
  std::set<std::array<double, 16>> seen_;
  std::vector<LoadFinding> findings_;
};

}  // namespace

double unseen_share(const std::function<double(double)>& history, double from, double to, double dt, double shortest) {
  const auto steps = static_cast<std::int64_t>(std::llround((to - from) / dt));
  const std::int64_t stride = std::max<std::int64_t>(1, steps / most_steps);
  const double in_a_step = points * std::max(1.0, dt / shortest);
  double missed = 0, whole = 0, place = 0;
  for (std::int64_t step = 0; step < steps; step += stride) {
    const double start = from + static_cast<double>(step) * dt;
    const double first = history(start), last = history(start + dt);
    for (int i = 0; i < std::min<double>(in_a_step, most_points); ++i) {
      place = std::fmod(place + 0.6180339887498949, 1.0);
      const double value = history(start + place * dt);
      missed += std::pow(value - first - place * (last - first), 2);
      whole += value * value;
    }
  }
  return whole > 0 ? std::sqrt(missed / whole) : 0;
}

std::vector<LoadFinding> unseen_load_findings(const Model& model) {
  Findings findings(model);
  for (const EdgeLoad& load : model.edge_loads) findings.add_load(load);
  for (const PointLoad& load : model.point_loads) findings.add_load(load);
  for (const PointSupport& support : model.supports) findings.add_motion(support);
  for (const HeldBlock& held : model.held_blocks) findings.add_motion(held);
  return findings.take();
}

std::vector<std::string> unseen_loads(const Model& model) {
  std::vector<std::string> sentences;
  for (LoadFinding& finding : unseen_load_findings(model)) sentences.push_back(std::move(finding.sentence));
  return sentences;
}

}  // namespace dda
