#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "engine/builder/free_outline.h"
#include "engine/scene/places.h"
#include "engine/scene/sections.h"

namespace dda {
namespace {

int read_stage_of_peaks(const Field& peaks, const Model& model) {
  const auto is_static = [&](int stage) { return model.stages[static_cast<std::size_t>(stage)].integrator.is_static; };
  if (const auto named = peaks.find("stage")) {
    const int stage = read_stage_reference(*named, model);
    if (is_static(stage)) named->fail("a stage that is not static: in those velocities mean nothing");
    return stage;
  }
  int stage = static_cast<int>(model.stages.size()) - 1;
  while (stage >= 0 && is_static(stage)) --stage;
  if (stage < 0) peaks.fail("left out where all stages are static: in those velocities mean nothing");
  return stage;
}

double length_of(const Ring& ring) {
  double length = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) length += (ring[(i + 1) % ring.size()] - ring[i]).norm();
  return length;
}

// Measures the wall of an opening, m: the outline drawn where it has no blocks, else that around its group.
double read_wall(const Field& name, const std::vector<std::string>& groups, const std::vector<PlanOpening>& openings,
                 const Model& model) {
  const std::string opening = name.text();
  const auto drawn = std::ranges::find(openings, opening, &PlanOpening::name);
  if (drawn != openings.end() && drawn->left_out) return length_of(drawn->outline);
  return outline_length(blocks_called(name, groups, model), model);
}

EjectionRequest read_ejection(const Field& field, const std::vector<std::string>& groups,
                              const std::vector<PlanOpening>& openings, const Model& model) {
  EjectionRequest ejection;
  if (!field.has("distance") && !field.has("velocity")) field.fail("an object with distance, velocity or both");
  ejection.distance =
      value_or(field, "distance", ejection.distance, [](const Field& f) { return f.positive(Dimension::length); });
  ejection.speed =
      value_or(field, "velocity", ejection.speed, [](const Field& f) { return f.positive(Dimension::velocity); });
  if (const auto opening = field.find("opening")) {
    ejection.opening = opening->text();
    ejection.wall = read_wall(*opening, groups, openings, model);
  }
  return ejection;
}

AttenuationRequest read_attenuation(const Field& field) {
  AttenuationRequest attenuation;
  attenuation.source = field.at("source").vector(Dimension::length);
  attenuation.charge =
      value_or(field, "charge", attenuation.charge, [](const Field& f) { return f.positive(Dimension::mass); });
  attenuation.nearest =
      value_or(field, "nearest", attenuation.nearest, [](const Field& f) { return f.not_negative(Dimension::length); });
  attenuation.farthest =
      value_or(field, "farthest", attenuation.farthest, [](const Field& f) { return f.positive(Dimension::length); });
  if (attenuation.farthest <= attenuation.nearest)
    field.at("farthest").fail(fmt::format("more than nearest, {} m", attenuation.nearest));
  return attenuation;
}

}  // namespace

void read_peaks(const Field& scene, const std::vector<std::string>& groups, const std::vector<PlanOpening>& openings,
                Model& model) {
  const auto field = scene.find("peaks");
  if (!field) return;
  PeakRequest peaks;
  peaks.stage = read_stage_of_peaks(*field, model);
  if (const auto ejected = field->find("ejected")) peaks.ejection = read_ejection(*ejected, groups, openings, model);
  if (const auto attenuation = field->find("attenuation")) peaks.attenuation = read_attenuation(*attenuation);
  model.peaks = std::move(peaks);
}

}  // namespace dda
