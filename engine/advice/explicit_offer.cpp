#include "engine/advice/explicit_offer.h"

#include <cmath>

#include "engine/core/error.h"
#include "engine/model/explicit_conditions.h"
#include "engine/simulation/stability_limit.h"

namespace dda {
namespace {

constexpr double least_saving = 0.2;

bool can_become_explicit(const Model& model, const Stage& stage) {
  return !stage.integrator.is_static && !stage.integrator.is_explicit() && !explicit_obstacle(model, stage);
}

// Rounds down to two digits.
double rounded_down(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::floor(value / unit) * unit;
}

// Returns the longest stable dt of that stage with explicit steps, s; 0 where it cannot have them.
double limit_of(Model model, std::size_t index) {
  Stage& stage = model.stages[index];
  stage.integrator = central_difference_integrator();
  try {
    return stability_limit(model, index);
  } catch (const InputError&) {
    return 0;
  }
}

}  // namespace

std::optional<ExplicitOffer> explicit_offer(const Model& model, std::size_t index, const SceneSize& size,
                                            const StageCost& cost) {
  const Stage& stage = model.stages[index];
  if (!can_become_explicit(model, stage)) return std::nullopt;
  const double limit = limit_of(model, index);
  if (!(limit > 0) || !std::isfinite(limit)) return std::nullopt;
  StepPlan plan;
  plan.linear = plan.explicit_steps = true;
  const double dt = rounded_down(limit);
  const double seconds = cost_of(size, plan, std::llround(std::ceil(stage.duration / dt))).seconds;
  if (seconds > (1 - least_saving) * cost.seconds) return std::nullopt;
  return ExplicitOffer{dt, seconds};
}

}  // namespace dda
