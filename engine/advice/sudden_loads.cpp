#include "engine/advice/sudden_loads.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "engine/advice/block_named.h"
#include "engine/advice/load_history.h"
#include "engine/model/stage_times.h"

namespace dda {
namespace {

// Shares of the largest value, and of a step within which they come. Half of it within a quarter of a step is a jump
// for these steps; a sine does that with three steps in a period, which unseen_loads is there for.
struct Threshold {
  double change, time;
};
constexpr std::array<Threshold, 2> jumps{{{0.1, 0.01}, {0.5, 0.25}}};
// Tables of displacements have velocities like stairs: ten points in the period of a sine make steps of 0.63.
constexpr std::array<Threshold, 2> turns{{{0.9, 0.01}, {0.9, 0.25}}};

// Times at which a history has kinks or jumps, and the first of its largest values, s.
std::vector<double> corners_of(const TimeFunction& history) {
  std::vector<double> times{0};
  if (const auto* table = std::get_if<PiecewiseLinear>(&history))
    times.insert(times.end(), table->times.begin(), table->times.end());
  if (const auto* sine = std::get_if<SineCycles>(&history))
    times.insert(times.end(),
                 {sine->start, sine->start + 0.25 / sine->frequency, sine->start + sine->cycles / sine->frequency});
  if (const auto* decay = std::get_if<ExponentialDecay>(&history))
    times.insert(times.end(), {decay->start, decay->start + decay->rise});
  if (const auto* record = std::get_if<Recorded>(&history))
    for (const double time : record->recording->times()) times.push_back(record->start + time);
  std::ranges::sort(times);
  return times;
}

std::size_t mark_of(const std::vector<double>& numbers) {
  return std::hash<std::string_view>{}(
      {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double)});
}

// Differs where tables or recordings do, which may have the same words and values at the same few times.
std::size_t mark_of(const TimeFunction& history) {
  constexpr std::size_t odd = 31;
  if (const auto* table = std::get_if<PiecewiseLinear>(&history))
    return odd * mark_of(table->times) + mark_of(table->values);
  if (const auto* record = std::get_if<Recorded>(&history))
    return std::hash<const void*>{}(record->recording.get()) + odd * std::hash<double>{}(record->start);
  return 0;
}

struct Drive {
  const char* what = "the load";
  ActingPlace place = {};
  Vec2 amplitude = Vec2::Zero();
  const TimeFunction* history = nullptr;
  std::function<double(double)> value;  // that a wave carries, of s in the run; 0 before it
  const std::array<Threshold, 2>* thresholds = &jumps;
  bool leaves_figures = false;
  StageSpan stages = {};
};

// Whether the edge load is what keeps the block's own stress, of before the run, in balance.
bool balances_stress(const Model& model, const EdgeLoad& load) {
  const Vec2 needed = traction_at_start(model, load);
  return !needed.isZero(0) &&
         (evaluate(load.history, 0) * load.traction - needed).norm() <= jumps[0].change * needed.norm();
}

class Search {
 public:
  explicit Search(const Model& model) : model_(model), end_(end_of_run(model)) {}

  // Many blocks have one drive, whose samples are looked at once; the others are counted.
  void add(const Drive& drive) {
    const auto [known, is_new] = known_.try_emplace(print_of(drive));
    if (is_new)
      known->second = groups_of(drive);
    else
      for (const std::size_t group : known->second) groups_[group].places.push_back(drive.place);
  }

  [[nodiscard]] std::vector<LoadFinding> take() {
    std::vector<LoadFinding> findings;
    for (const Group& group : groups_)
      findings.push_back(
          {group.stage, group.first.history, sentence_of(group), group.first.leaves_figures, group.time, group.places});
    return findings;
  }

 private:
  struct Group {  // of drives that are the same on several blocks
    Drive first;
    int stage = 0;
    double time = 0;  // s, of the first jump
    std::vector<ActingPlace> places;
  };

  // Amplitude, values at times that no period of a history falls in with, what it is, and which table or recording.
  using Print = std::tuple<std::array<double, 18>, std::string, std::size_t>;

  [[nodiscard]] Print print_of(const Drive& drive) const {
    std::array<double, 18> numbers{drive.amplitude.x(), drive.amplitude.y()};
    for (std::size_t i = 2; i < numbers.size(); ++i) {
      const double value = drive.value(end_ * std::fmod(0.6180339887498949 * static_cast<double>(i), 1.0));
      numbers[i] = std::isfinite(value) ? value : 0;
    }
    return {numbers, drive.what + words_for(*drive.history), mark_of(*drive.history)};
  }

  [[nodiscard]] std::vector<std::size_t> groups_of(const Drive& drive) {
    const std::vector<double> corners = corners_of(*drive.history);
    std::vector<std::size_t> groups;
    double begin = 0;
    bool goes_on = true;  // what a static stage ends with is no jump in the next one
    for (std::size_t i = 0; i < model_.stages.size(); ++i) {
      const Stage& stage = model_.stages[i];
      const bool moves = !stage.integrator.is_static && !stage.paces_itself() && drive.stages.has(i);
      const auto inside = [&](double t) { return t < begin + stage.duration && (goes_on ? t >= begin : t > begin); };
      std::optional<double> jump;
      if (moves && stage.velocity_factor == 1) jump = first_jump(drive, stage.dt, corners, inside);
      if (comes_or_goes_at_once(drive, i, begin, corners)) jump = begin;
      if (jump) {
        groups.push_back(groups_.size());
        groups_.push_back({drive, static_cast<int>(i), *jump, {drive.place}});
      }
      begin += stage.duration;
      goes_on = moves;
    }
    return groups;
  }

  // Acts from the start of this stage on, or to that of the one before, whatever its history does then.
  [[nodiscard]] bool comes_or_goes_at_once(const Drive& drive, std::size_t index, double begin,
                                           const std::vector<double>& corners) const {
    const Stage& stage = model_.stages[index];
    if (index == 0 || drive.stages.has(index) == drive.stages.has(index - 1)) return false;
    if (stage.integrator.is_static || stage.paces_itself() || stage.velocity_factor != 1) return false;
    return std::abs(drive.value(begin)) > jumps[0].change * largest_of(drive, stage.dt, corners);
  }

  [[nodiscard]] static double largest_of(const Drive& drive, double dt, const std::vector<double>& corners) {
    double largest = 0;
    for (const double t : corners)
      for (const double side : {-1, 1}) {
        const double value = drive.value(t + side * (*drive.thresholds)[0].time * dt / 2);
        if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
      }
    return largest;
  }

  template <typename Inside>
  [[nodiscard]] static std::optional<double> first_jump(const Drive& drive, double dt,
                                                        const std::vector<double>& corners, const Inside& inside) {
    const double largest = largest_of(drive, dt, corners);
    const auto jumps_at = [&](double t) {
      return inside(t) && std::ranges::any_of(*drive.thresholds, [&](const Threshold& threshold) {
               const double half = threshold.time * dt / 2;
               return std::abs(drive.value(t + half) - drive.value(t - half)) > threshold.change * largest;
             });
    };
    const auto found = std::ranges::find_if(corners, jumps_at);
    return found == corners.end() ? std::nullopt : std::optional(*found);
  }

  [[nodiscard]] std::string sentence_of(const Group& group) const {
    return fmt::format(
        "stage \"{}\": {} on {}{}, {}, jumps at {:g} s: a jump holds all frequencies, which no mesh and dt "
        "carry without overshoot and ringing; let it rise while the wave crosses several blocks",
        model_.stages[static_cast<std::size_t>(group.stage)].name, group.first.what,
        block_named(model_, group.first.place.block), and_more(group.places.size() - 1),
        words_for(*group.first.history), group.time);
  }

  const Model& model_;
  double end_ = 0;  // s, of the last stage
  std::vector<Group> groups_;
  std::map<Print, std::vector<std::size_t>> known_;
};

template <typename Load>
Drive load_on(const Load& load, const Vec2& amplitude) {
  Drive drive{"the load", place_of(load), amplitude, &load.history,
              [history = load.history](double t) { return t < 0 ? 0 : evaluate(history, t); }};
  drive.stages = load.stages;
  return drive;
}

// Where the place itself jumps its velocity is that of the jump, which motion_at leaves out.
template <typename Motion>
std::vector<Drive> motions_of(const Motion& motion) {
  if (motion.amplitude.isZero(0) || motion.kind == MotionKind::acceleration) return {};
  const auto drive = [&](const char* what, double MotionFactors::*value, const std::array<Threshold, 2>& thresholds) {
    return Drive{what,
                 place_of(motion),
                 motion.amplitude,
                 &motion.history,
                 [kind = motion.kind, history = motion.history, value](double t) {
                   return t < 0 ? 0 : motion_at(kind, history, t).*value;
                 },
                 &thresholds,
                 motion.kind != MotionKind::velocity && value == &MotionFactors::velocity};
  };
  if (motion.kind == MotionKind::velocity)
    return {drive("the velocity of the motion", &MotionFactors::velocity, jumps)};
  return {drive("the motion", &MotionFactors::displacement, jumps),
          drive("the velocity of the motion", &MotionFactors::velocity, turns)};
}

// A velocity between its jumps, of s since it began.
double square_mean(const LoadHistory& history) {
  constexpr int samples = 4000;
  double sum = 0;
  for (int i = 0; i < samples; ++i) sum += std::pow(history.value((i + 0.5) / samples * history.run), 2);
  return sum / samples;
}

}  // namespace

double share_of_jumps(const SceneLoad& load, double dt) {
  constexpr double stairs = 0.3;  // of the largest velocity: 20 points in the period of a sine have such steps
  if (!load.history.displacement) return 0;
  const double half = jumps[1].time * dt / 2;
  std::vector<double> changes;
  double largest = 0;
  std::vector<double> corners = corners_of(*load.source);
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  for (const double corner : corners) {
    const double t = corner - load.history.start;
    if (t < 0 || t + half > load.history.run) continue;
    const double before = load.history.value(t - half), after = load.history.value(t + half);
    largest = std::max({largest, std::abs(before), std::abs(after)});
    changes.push_back(after - before);
  }
  double squares = 0;
  for (const double change : changes)
    if (std::abs(change) > stairs * largest) squares += change * change;
  const double whole = square_mean(load.history) * load.history.run;
  return whole > 0 ? squares * dt / 2 / whole : 0;
}

std::vector<LoadFinding> sudden_loads(const Model& model) {
  Search search(model);
  for (const EdgeLoad& load : model.edge_loads)
    if (!load.traction.isZero(0) && !balances_stress(model, load)) search.add(load_on(load, load.traction));
  for (const PointLoad& load : model.point_loads)
    if (!load.force.isZero(0)) search.add(load_on(load, load.force));
  for (const PointSupport& support : model.supports)
    for (const Drive& drive : motions_of(support)) search.add(drive);
  for (const HeldBlock& held : model.held_blocks)
    for (const Drive& drive : motions_of(held)) search.add(drive);
  return search.take();
}

}  // namespace dda
