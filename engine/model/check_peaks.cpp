#include <fmt/format.h>

#include <cmath>

#include "engine/model/check_parts.h"
#include "engine/model/checks.h"

namespace dda::model_checks {
namespace {

void check_ejection(const Item& item, const EjectionRequest& ejection) {
  if (std::isinf(ejection.distance) && std::isinf(ejection.speed))
    item.fail("ejected", "without a distance and a velocity", "one of them, or both");
  if (!std::isinf(ejection.distance)) item.positive("ejected distance", ejection.distance);
  if (!std::isinf(ejection.speed)) item.positive("ejected velocity", ejection.speed);
  if (!ejection.opening.empty()) item.positive("wall of the opening", ejection.wall);
}

void check_attenuation(const Item& item, const AttenuationRequest& attenuation) {
  item.finite("source", attenuation.source);
  item.positive("charge", attenuation.charge);
  item.not_negative("nearest", attenuation.nearest);
  if (!(attenuation.farthest > attenuation.nearest))
    item.fail("farthest", fmt::format("{} m", attenuation.farthest),
              fmt::format("farther than the nearest, {} m", attenuation.nearest));
}

}  // namespace

// In static stages velocities mean nothing.
void check_peaks(const Model& model) {
  if (!model.peaks) return;
  const Item item("peaks", 0);
  item.index("stage", model.peaks->stage, model.stages.size());
  const Stage& stage = model.stages[static_cast<std::size_t>(model.peaks->stage)];
  if (stage.integrator.is_static)
    item.fail("stage", fmt::format("\"{}\", which is static", stage.name), "one in which blocks move in time");
  if (model.peaks->ejection) check_ejection(item, *model.peaks->ejection);
  if (model.peaks->attenuation) check_attenuation(item, *model.peaks->attenuation);
}

}  // namespace dda::model_checks
