#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "engine/scene/laid_bare.h"
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

// Finds the wall of an opening: what blocks that are there in the stage have along the outline drawn where it was cut
// without blocks, else what its blocks lay bare. Ground surface and what was taken out beside it are no wall.
std::vector<Stretch> read_wall(const Field& name, int stage, const std::vector<std::string>& groups,
                               const std::vector<PlanOpening>& openings, const Model& model) {
  const auto drawn = std::ranges::find(openings, name.text(), &PlanOpening::name);
  if (drawn != openings.end() && drawn->left_out)
    return faces_around(drawn->outline, static_cast<std::size_t>(stage), model);
  return faces_laid_bare(name, groups, {stage, stage},
                         "blocks that are away in the stage of peaks: the energy is spread over what they lay bare",
                         model);
}

double length_of(const std::vector<Stretch>& faces) {
  double length = 0;
  for (const Stretch& face : faces) length += (face.to - face.from).norm();
  return length;
}

EjectionRequest read_ejection(const Field& field, int stage, const std::vector<std::string>& groups,
                              const std::vector<PlanOpening>& openings, const Model& model) {
  EjectionRequest ejection;
  if (!field.has("distance") && !field.has("velocity")) field.fail("an object with distance, velocity or both");
  ejection.distance =
      value_or(field, "distance", ejection.distance, [](const Field& f) { return f.positive(Dimension::length); });
  ejection.speed =
      value_or(field, "velocity", ejection.speed, [](const Field& f) { return f.positive(Dimension::velocity); });
  if (const auto opening = field.find("opening")) {
    ejection.opening = opening->text();
    ejection.wall = length_of(read_wall(*opening, stage, groups, openings, model));
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
  if (const auto ejected = field->find("ejected"))
    peaks.ejection = read_ejection(*ejected, peaks.stage, groups, openings, model);
  if (const auto attenuation = field->find("attenuation")) peaks.attenuation = read_attenuation(*attenuation);
  model.peaks = std::move(peaks);
}

}  // namespace dda
