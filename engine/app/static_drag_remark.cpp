#include "engine/app/static_drag_remark.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <variant>
#include <vector>

#include "engine/app/frame_clock.h"
#include "engine/model/held_motion.h"
#include "engine/simulation/run_so_far.h"

namespace dda {
namespace {

// A share of the work. Pushed blocks that slide have forces too large by about as much; at a tenth of the speed, or in
// steps ten times as long, it is a tenth.
constexpr double felt = 0.05;

struct Span {
  std::size_t stage = 0;
  StageTimes times;
};

// At times that no period of a history falls in with.
bool changes(const TimeFunction& history, const Span& span) {
  if (std::holds_alternative<Constant>(history)) return false;
  constexpr int times = 32;
  const auto at = [&](double share) {
    return evaluate(history, std::lerp(span.times.begin_s, span.times.end_s, share));
  };
  for (int i = 1; i <= times; ++i)
    if (at(std::fmod(0.6180339887498949 * i, 1.0)) != at(0)) return true;
  return false;
}

template <typename Motion>
bool goes_on_in(const Motion& motion, const Span& span) {
  return motion.kind != MotionKind::displacement || changes(motion.history, span);
}

bool something_moves(const Model& model, const Span& span) {
  return std::ranges::any_of(model.supports,
                             [&](const PointSupport& support) {
                               const bool there =
                                   support.last_stage < 0 || static_cast<std::size_t>(support.last_stage) >= span.stage;
                               return there && !support.amplitude.isZero(0) && goes_on_in(support, span);
                             }) ||
         std::ranges::any_of(model.held_blocks,
                             [&](const HeldBlock& held) { return moves(held) && goes_on_in(held, span); });
}

template <typename Load>
bool one_changes(const std::vector<Load>& loads, const Span& span) {
  return std::ranges::any_of(
      loads, [&](const Load& load) { return load.stages.has(span.stage) && changes(load.history, span); });
}

// A part of what begins to act at once is taken on the way to equilibrium however long steps are.
template <typename Load>
bool one_comes(const std::vector<Load>& loads, const Span& span) {
  return std::ranges::any_of(loads, [&](const Load& load) {
    if (!load.stages.has(span.stage)) return false;
    return (span.stage == 0 || !load.stages.has(span.stage - 1)) && evaluate(load.history, span.times.begin_s) != 0;
  });
}

bool is_judged(const Model& model, const Span& span) {
  const Stage& stage = model.stages[span.stage];
  if (!stage.integrator.is_static || stage.paces_itself()) return false;
  if (one_comes(model.edge_loads, span) || one_comes(model.point_loads, span)) return false;
  return something_moves(model, span) || one_changes(model.edge_loads, span) || one_changes(model.point_loads, span);
}

// What inertia took beyond what weight and stored energy brought, over the work of loads and motions.
double share_of_drag(const EnergyLedger& before, const EnergyLedger& after) {
  const auto stored = [](const EnergyLedger& energy) {
    return energy.strain + energy.contact + energy.bolts + energy.linings;
  };
  const double given =
      std::max(0.0, after.gravity_work - before.gravity_work) + std::max(0.0, stored(before) - stored(after));
  const double taken = after.damping - before.damping + after.numerical - before.numerical - given;
  const double work = std::abs(after.external_work - before.external_work);
  return work > 0 ? taken / work : 0;
}

}  // namespace

std::string static_drag_remark(const Simulation& simulation) {
  const Model& model = simulation.model();
  const std::span<const EnergyLedger> energies = energy_at_ends_of_stages(simulation);
  const std::vector<StageTimes> times = stage_spans(model);
  double worst = felt;
  std::size_t named = 0;
  EnergyLedger before;
  if (!energies.empty()) before.store(energies.front().initial);
  for (std::size_t i = 0; i < energies.size(); ++i) {
    const double share = is_judged(model, {i, times[i]}) ? share_of_drag(before, energies[i]) : 0;
    if (share > worst) {
      worst = share;
      named = i + 1;
    }
    before = energies[i];
  }
  if (named == 0) return "";
  const Stage& stage = model.stages[named - 1];
  return fmt::format(
      "static stage \"{}\": inertia took {:.0f} % of the work of what moved or changed in it, as steps of {:g} s hold "
      "a mass back by 2 v/dt times itself: unless rock gave way at once, forces on the way are too large by as much; "
      "leave dt out, or go as far in more time and longer steps",
      stage.name, 100 * worst, stage.dt);
}

}  // namespace dda
