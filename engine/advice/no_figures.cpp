#include "engine/advice/no_figures.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/advice/sudden_loads.h"
#include "engine/advice/unseen_loads.h"

namespace dda {
namespace {

// Steps in a period, and blocks in a wavelength, of a load's main frequency: with fewer, what comes is no wave like it.
constexpr double least_in_period = 4;

// Share of a wave that may be in steps beside jumps.
constexpr double most_of_jumps = 0.004;

// Share of the forces of stress at the start that may be out of balance.
constexpr double hardly_out_of_balance = 0.01;

bool has_settled_by(const Model& model, std::size_t stage) {
  for (std::size_t i = 0; i <= stage; ++i)
    if (model.stages[i].integrator.is_static) return true;
  return false;
}

bool has_no_stress(const Model& model) {
  return std::ranges::all_of(model.blocks, [](const Block& block) { return block.initial_stress.isZero(0); });
}

// Weight that blocks without stress have from the first moment of a run sets all of them swinging.
bool weight_jumps(const Model& model, std::size_t stage) {
  return !model.gravity.isZero(0) && !has_settled_by(model, stage) && has_no_stress(model);
}

// So does stress that they begin with and nothing balances.
bool stress_jumps(const Model& model, std::size_t stage, double out_of_balance) {
  return out_of_balance > hardly_out_of_balance && !has_settled_by(model, stage) && !has_no_stress(model);
}

}  // namespace

NoFigures::NoFigures(const Model& model, double out_of_balance)
    : model_(model),
      out_of_balance_(out_of_balance),
      unseen_(unseen_load_findings(model)),
      sudden_(sudden_loads(model)) {}

// Readings of a wave that jumps look good, as they are means over all of it, while its front is far off; those of one
// that steps or blocks pass over are readings of something else.
std::string NoFigures::why(const SceneLoad& load, std::size_t stage, double wavelength, double block_size) const {
  const auto concerns = [&](const LoadFinding& finding) {
    return finding.stage == static_cast<int>(stage) && finding.history == load.source;
  };
  if (std::ranges::any_of(sudden_, [&](const LoadFinding& each) { return concerns(each) && !each.leaves_figures; }))
    return "it jumps, which no mesh and dt carry without overshoot and ringing: no figures";
  if (weight_jumps(model_, stage))
    return "cannot be foretold: weight acts from the first moment, and sets the rock swinging";
  if (stress_jumps(model_, stage, out_of_balance_))
    return "cannot be foretold: stress that nothing balances acts from the first moment, and sets the rock swinging";
  const double dt = model_.stages[stage].dt, period = load.history.period;
  if (const double share = share_of_jumps(load, dt); share > most_of_jumps)
    return fmt::format("its velocity jumps, and {:.2g} % of it is in the steps beside: no figures", 100 * share);
  if (std::ranges::any_of(unseen_, concerns)) return "steps of this dt see too little of it: no figures";
  if (dt > period / least_in_period)
    return fmt::format("too short for steps of {:g} s, {:.2g} in a period of its main frequency: no figures", dt,
                       period / dt);
  if (block_size > wavelength / least_in_period)
    return fmt::format("too short for blocks of {:.4g} m, {:.2g} in a wavelength of its main frequency: no figures",
                       block_size, wavelength / block_size);
  return "";
}

}  // namespace dda
