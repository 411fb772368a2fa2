#include "engine/model/step_choice.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/model/extent.h"

namespace dda {
namespace {

constexpr double wave_error = 0.002;
constexpr double motion_share = 0.01;  // of its size that a block may move in a step
constexpr double transit_share = 0.5;  // of the time of a wave through a block, where nothing else limits dt
// The same where something is let go at once, and all blocks beside it ring: of the energy of blocks that an opening
// throws steps of half of it took up to a half, a quarter a fifth, an eighth a twentieth and a sixteenth nothing.
constexpr double release_share = 0.125;
constexpr double least_transits = 0.05;  // through a block in a step
constexpr double last_steps = 10;        // that a stage whose steps grow takes at least when they are as long as can be
constexpr double fewest_steps = 100;     // in a stage
constexpr double small_rock = 0.05;      // share of the rock whose blocks are not asked

struct Limit {
  double dt = std::numeric_limits<double>::infinity();  // s
  std::string reason;
};

void tighten(Limit& limit, double dt, std::string reason) {
  if (dt < limit.dt) limit = {dt, std::move(reason)};
}

const Material& rock_of(const Model& model, const Block& block) {
  return model.materials[static_cast<std::size_t>(block.material)];
}

double bar_speed(const Material& rock) { return std::sqrt(rock.young / rock.density); }

// Those that are not held; where all are, these, since a step has to have some length.
std::vector<const Block*> moving_blocks(const Model& model) {
  std::vector<const Block*> moving;
  std::vector<const Block*> all;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    all.push_back(&model.blocks[i]);
    if (!model.is_held(static_cast<int>(i))) moving.push_back(&model.blocks[i]);
  }
  return moving.empty() ? all : moving;
}

// The size that 5 % of the rock is smaller than.
template <typename Size>
double typical(const std::vector<const Block*>& blocks, const Size& size) {
  std::vector<std::pair<double, double>> sizes;  // and areas
  double rock = 0;
  for (const Block* block : blocks) {
    sizes.emplace_back(size(*block), block->moments.area);
    rock += block->moments.area;
  }
  std::ranges::sort(sizes);
  double smaller = 0;
  for (const auto& [value, area] : sizes)
    if ((smaller += area) >= small_rock * rock) return value;
  return sizes.empty() ? 0 : sizes.back().first;
}

double side_of(const Block& block) { return std::sqrt(block.moments.area); }

// Straight lines through points: a table, or a recording.
struct Points {
  std::span<const double> times, values;
};

// Where they turn back by more than a little, and their ends: between two of these they rise or fall.
std::vector<std::size_t> turns_of(const Points& points, double little) {
  std::vector<std::size_t> turns{0};
  std::size_t low = 0, high = 0;  // since the last turn
  for (std::size_t i = 1; i < points.values.size(); ++i) {
    if (points.values[i] > points.values[high]) high = i;
    if (points.values[i] < points.values[low]) low = i;
    const bool falls = points.values[high] - points.values[i] > little && high != turns.back();
    const bool rises = points.values[i] - points.values[low] > little && low != turns.back();
    if (!falls && !rises) continue;
    turns.push_back(falls ? high : low);
    low = high = turns.back();
    (falls ? low : high) = i;
  }
  const std::size_t last = high != turns.back() ? high : low;
  if (last != turns.back()) turns.push_back(last);
  return turns;
}

// Hz: what points would change by between two of their turns, all at its steepest there, is a quarter of a period. So
// many points in a smooth table do not make it fast (a sine of f in a table is (pi/2) f), and neither does a preload
// make slow what follows it. Changes below `ripple` of the largest count for nothing.
std::optional<double> frequency_of(const Points& points, double ripple) {
  double largest = 0;
  for (const double value : points.values) largest = std::max(largest, std::abs(value - points.values.front()));
  if (largest == 0) return std::nullopt;
  const double little = ripple * largest;
  const std::vector<std::size_t> turns = turns_of(points, little);
  double highest = 0;
  for (std::size_t turn = 1; turn < turns.size(); ++turn) {
    const double change = std::abs(points.values[turns[turn]] - points.values[turns[turn - 1]]);
    if (change <= little) continue;
    double steepest = 0;
    for (std::size_t i = turns[turn - 1] + 1; i <= turns[turn]; ++i)
      steepest = std::max(steepest,
                          std::abs(points.values[i] - points.values[i - 1]) / (points.times[i] - points.times[i - 1]));
    highest = std::max(highest, 0.25 * steepest / change);
  }
  return highest;
}

std::optional<double> frequency_of(const PiecewiseLinear& table) {
  constexpr double ripple = 0.05;
  return frequency_of({table.times, table.values}, ripple);
}

// What is measured has noise, and small waves of high frequency on the large ones: those count for less, and steps that
// followed them all would be a small part of the interval of the samples.
std::optional<double> frequency_of(const Recorded& record) {
  constexpr double ripple = 0.5;
  return frequency_of({record.recording->times(), record.recording->values()}, ripple);
}

// Hz, of the fastest change of a history; none of one that does not change.
std::optional<double> highest_frequency(const TimeFunction& history) {
  if (const auto* sine = std::get_if<SineCycles>(&history)) return sine->frequency;
  if (const auto* decay = std::get_if<ExponentialDecay>(&history))
    return 0.25 / (decay->rise > 0 ? std::min(decay->rise, decay->decay_time) : decay->decay_time);
  if (const auto* table = std::get_if<PiecewiseLinear>(&history)) return frequency_of(*table);
  const auto* record = std::get_if<Recorded>(&history);
  return record == nullptr ? std::nullopt : frequency_of(*record);
}

std::vector<const TimeFunction*> histories_of(const Model& model) {
  std::vector<const TimeFunction*> histories;
  for (const auto& load : model.point_loads) histories.push_back(&load.history);
  for (const auto& load : model.edge_loads) histories.push_back(&load.history);
  for (const auto& support : model.supports) histories.push_back(&support.history);
  for (const auto& held : model.held_blocks) histories.push_back(&held.history);
  for (const auto& stage : model.stages)  // what removed blocks exerted fades as a load
    if (stage.removal.relaxation) histories.push_back(&*stage.removal.relaxation);
  return histories;
}

// Hz, of loads and prescribed motions or as it is given; 0 where nothing changes.
double fastest_change(const Model& model) {
  if (model.expected.frequency) return *model.expected.frequency;
  double highest = 0;
  for (const TimeFunction* history : histories_of(model))
    highest = std::max(highest, highest_frequency(*history).value_or(0));
  return highest;
}

double dt_for_wave(const Model& model, const Integrator& integrator, double frequency) {
  double slowest = std::numeric_limits<double>::infinity();
  for (const Block& block : model.blocks) slowest = std::min(slowest, bar_speed(rock_of(model, block)));
  const double periods = std::max(1.0, diameter(model) * frequency / slowest);
  const auto is_good = [&](double theta) {
    const StepErrors errors = step_errors(integrator, theta);
    return std::max(std::abs(errors.speed), periods * std::abs(errors.amplitude)) <= wave_error;
  };
  double theta = 1;  // six steps a period at most
  for (int i = 0; i < 40 && !is_good(theta); ++i) theta /= std::numbers::sqrt2;
  return theta / (2 * std::numbers::pi * frequency);
}

void limit_by_waves(const Model& model, const Stage& stage, Limit& limit) {
  for (const TimeFunction* history : histories_of(model))
    if (const auto* record = std::get_if<Recorded>(history))
      tighten(limit, record->recording->mean_interval(), "the interval of a recording's samples");
  if (const double highest = fastest_change(model); highest > 0)
    tighten(limit, dt_for_wave(model, stage.integrator, highest), fmt::format("waves of {:.3g} Hz", highest));
}

void limit_by_motion(const Model& model, const std::vector<const Block*>& blocks, Limit& limit) {
  const double size = typical(blocks, side_of);
  const double g = model.gravity.norm();
  if (g > 0) tighten(limit, motion_share * std::sqrt(size / g), fmt::format("blocks of {:.3g} m that fall", size));
  double fastest = 0;
  for (const Block* block : blocks) {
    const Material& rock = rock_of(model, *block);
    const double pushed = model.expected.pressure / (rock.density * bar_speed(rock));
    fastest =
        std::max({fastest, block->initial_velocity.norm(), std::abs(block->initial_spin) * side_of(*block), pushed});
  }
  if (fastest > 0)
    tighten(limit, motion_share * size / fastest, fmt::format("blocks of {:.3g} m at {:.3g} m/s", size, fastest));
}

bool supports_let_go_before(const Model& model, std::size_t stage) {
  return std::ranges::any_of(model.supports, [&](const PointSupport& support) {
    return support.takes_force_along && support.last_stage + 1 == static_cast<int>(stage);
  });
}

bool begins_under_stress(const Model& model) {
  return std::ranges::any_of(model.blocks, [](const Block& block) { return !block.initial_stress.isZero(0); });
}

// What removed blocks, supports, or joints that could not break before held back is let go within no time, and every
// block beside them rings at its own frequency. So it is with stress that no stage has settled.
void limit_by_release(const Model& model, std::size_t index, double transit, Limit& limit) {
  const Stage& stage = model.stages[index];
  const Stage* before = index > 0 ? &model.stages[index - 1] : nullptr;
  const auto release = [&](const char* why) {
    tighten(limit, release_share * transit, fmt::format("an eighth of the time of a wave through a block, as {}", why));
  };
  if (!stage.removal.blocks.empty() && !stage.removal.relaxation) release("rock is removed at once");
  if (before != nullptr && before->unlimited_strength && !stage.unlimited_strength)
    release("joints get their own strength at once");
  if (before != nullptr && supports_let_go_before(model, index)) release("supports let go at once");
  if (before == nullptr && begins_under_stress(model)) release("stress begins to act at once");
}

// No part of what steps are multiplied with, or waves are corrected by, goes by the dt of the stage.
bool steps_may_grow(const Model& model, const Stage& stage) {
  return !model.stays_linear() && model.free_field_sides.empty() && !stage.integrator.is_explicit() &&
         stage.velocity_factor == 1;
}

// Times that are the same differ by round-off where they come about in two ways, or are written in other units. It
// makes no step more, and none of half the length: steps are chosen with far less care than that.
constexpr double round_off = 1e-12;

bool fits(double time, double most) { return time * (1 - round_off) <= most; }

// The steps of a stage begin with its dt and grow while `longest` (s) and its duration allow it.
void let_grow(double longest, Stage& stage) {
  FirstSteps first{stage.dt, 0};
  const auto leaves_enough = [&](FirstSteps next) {
    ++next.doublings;
    const double dt = std::ldexp(next.dt, next.doublings);
    return fits(dt, longest) && fits(next.duration() + last_steps * dt, stage.duration);
  };
  while (leaves_enough(first)) ++first.doublings;
  if (!first.grow()) return;
  const double left = stage.duration - first.duration();
  stage.dt = left / std::ceil(left / std::ldexp(first.dt, first.doublings) * (1 - round_off));
  stage.chosen.dt.first_steps = first;
}

bool blocks_can_part(const Model& model) {
  return model.joints.empty() ||
         !std::ranges::all_of(model.joints, [](const JointMaterial& joint) { return joint.bonded; });
}

double rounded_down(double dt) {
  const double power = std::pow(10, std::floor(std::log10(dt * (1 + round_off))));
  for (const double digit : {5.0, 2.0})
    if (fits(digit * power, dt)) return digit * power;
  return power;
}

void limit_at_all(const Stage& stage, double transit, Limit& limit) {
  if (!std::isfinite(limit.dt)) tighten(limit, transit_share * transit, "half the time of a wave through a block");
  if (limit.dt < least_transits * transit)
    limit = {least_transits * transit, "a twentieth of the time of a wave through a block, the least"};
  tighten(limit, stage.duration / fewest_steps, fmt::format("{} steps in the stage, the fewest", fewest_steps));
}

void choose(const Model& model, std::size_t index, Stage& stage) {
  const std::vector<const Block*> blocks = moving_blocks(model);
  const double transit =
      typical(blocks, [&](const Block& block) { return side_of(block) / bar_speed(rock_of(model, block)); });
  Limit all_along;
  limit_by_waves(model, stage, all_along);
  if (blocks_can_part(model)) limit_by_motion(model, blocks, all_along);
  Limit at_first = all_along;
  if (blocks_can_part(model)) limit_by_release(model, index, transit, at_first);
  for (Limit* limit : {&all_along, &at_first}) limit_at_all(stage, transit, *limit);
  stage.dt = rounded_down(at_first.dt);
  stage.chosen.dt.reason = at_first.reason;
  if (at_first.dt < all_along.dt && steps_may_grow(model, stage)) let_grow(all_along.dt, stage);
}

}  // namespace

// Rows: x1, dt v1, dt^2 a1 by x0, dt v0, dt^2 a0.
StepErrors step_errors(const Integrator& i, double theta) {
  // Two of the eigenvalues below meet at 1, where they keep half of the digits; errors of no integrator fall slower
  // than in proportion.
  constexpr double least = 1e-4;
  if (theta < least) {
    const StepErrors there = step_errors(i, least);
    return {there.speed * theta / least, there.amplitude * theta / least};
  }
  const double own = 1 - i.alpha_m + theta * theta * (1 - i.alpha_f) * i.beta;
  const double old = -theta * theta / own;
  const Eigen::RowVector3d acceleration(old, old * (1 - i.alpha_f),
                                        old * (1 - i.alpha_f) * (0.5 - i.beta) - i.alpha_m / own);
  Eigen::Matrix3d step;
  step.row(2) = acceleration;
  step.row(0) = Eigen::RowVector3d(1, 1, 0.5 - i.beta) + i.beta * acceleration;
  step.row(1) = Eigen::RowVector3d(0, 1, 1 - i.gamma) + i.gamma * acceleration;
  const std::complex<double> exact = std::polar(1.0, theta);
  std::complex<double> nearest = 0;
  const Eigen::EigenSolver<Eigen::Matrix3d> solver(step, false);  // a loop over a temporary's values would outlive it
  for (const std::complex<double>& value : solver.eigenvalues())
    if (std::abs(value - exact) < std::abs(nearest - exact)) nearest = value;
  return {std::arg(nearest) / theta - 1, 1 - std::pow(std::abs(nearest), 2 * std::numbers::pi / theta)};
}

std::optional<FastestWave> fastest_wave(const Model& model, const Stage& stage, double dt) {
  const double frequency = fastest_change(model);
  if (frequency <= 0) return std::nullopt;
  return FastestWave{frequency, step_errors(stage.integrator, 2 * std::numbers::pi * frequency * dt)};
}

std::string in_words(double first_dt, double dt) {
  return first_dt < dt ? fmt::format("{:.6g} to {:.6g} s", first_dt, dt) : fmt::format("{:.6g} s", dt);
}

void choose_time_steps(Model& model) {
  for (std::size_t i = 0; i < model.stages.size(); ++i) {
    Stage& stage = model.stages[i];
    if (stage.chosen.dt.automatic && stage.dt == 0) choose(model, i, stage);
  }
}

}  // namespace dda
