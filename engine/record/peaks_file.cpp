#include "engine/record/peaks_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/record/csv.h"

namespace dda {
namespace {

using Json = nlohmann::ordered_json;

std::string header(const PeakRequest& asked) {
  std::string text =
      "block,x [m],y [m],mass [kg/m],velocity [m/s],velocity_at [s],acceleration [m/s2],"
      "acceleration_at [s],kinetic_energy [J/m]";
  if (asked.ejection) text += ",moved [m],ejection_velocity [m/s],ejected_at [s]";
  if (asked.attenuation) text += ",scaled_distance [m/sqrt(kg/m)],in_fit [-]";
  return text + "\n";
}

std::string row(const Model& model, std::size_t i, const BlockPeaks& peaks) {
  const PeakRequest& asked = *model.peaks;
  std::string text = fmt::format("{},{},{},{},{},{},{},{},{}", csv_cell(model.blocks[i].name), peaks.place.x(),
                                 peaks.place.y(), model.mass_of(static_cast<int>(i)), peaks.speed, peaks.speed_time,
                                 peaks.acceleration, peaks.acceleration_time, peaks.kinetic);
  if (asked.ejection)
    text += fmt::format(",{},{},{}", peaks.moved, peaks.thrown,
                        peaks.is_ejected() ? fmt::format("{}", peaks.ejected_at) : "");
  if (asked.attenuation)
    text += fmt::format(",{},{}", scaled_distance(*asked.attenuation, peaks.place),
                        counts_for_fit(*asked.attenuation, peaks) ? 1 : 0);
  return text + "\n";
}

Json or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json to_json(const ThrownBlocks& blocks) {
  return {{"from_m_s", blocks.from},
          {"to_m_s", blocks.to},
          {"blocks", blocks.blocks},
          {"mass_kg_per_m", blocks.mass},
          {"kinetic_energy_J_per_m", blocks.kinetic}};
}

Json to_json(const EjectionRequest& asked, const Ejection& ejection) {
  Json json = {{"distance_m", or_null(asked.distance)},
               {"velocity_m_s", or_null(asked.speed)},
               {"blocks", ejection.all.blocks},
               {"mass_kg_per_m", ejection.all.mass},
               {"kinetic_energy_J_per_m", ejection.all.kinetic},
               {"kinetic_energy_at_end_J_per_m", ejection.kinetic_at_end},
               {"mean_velocity_m_s", ejection.mean_velocity},
               {"largest_velocity_m_s", ejection.all.to}};
  json["opening"] = asked.opening.empty() ? Json(nullptr) : Json(asked.opening);
  json["wall_m"] = asked.wall > 0 ? Json(asked.wall) : Json(nullptr);
  json["kinetic_energy_kJ_per_m2"] = asked.wall > 0 ? Json(ejection.all.kinetic / asked.wall / 1e3) : Json(nullptr);
  json["velocities"] = Json::array();
  for (const ThrownBlocks& each : ejection.classes) json["velocities"].push_back(to_json(each));
  return json;
}

Json to_json(const AttenuationRequest& asked, std::span<const BlockPeaks> peaks) {
  Json json = {{"source_m", {asked.source.x(), asked.source.y()}},
               {"charge_kg_per_m", asked.charge},
               {"nearest_m", asked.nearest},
               {"farthest_m", or_null(asked.farthest)}};
  const auto law = attenuation_of(asked, peaks);
  json["points"] = std::ranges::count_if(peaks, [&](const BlockPeaks& each) { return counts_for_fit(asked, each); });
  json["K_m_s"] = law ? or_null(law->k) : Json(nullptr);
  json["n"] = law ? or_null(law->exponent) : Json(nullptr);
  json["correlation"] = law ? or_null(law->correlation) : Json(nullptr);
  return json;
}

// The block of the largest value, with it and its time.
Json largest(const Model& model, std::span<const BlockPeaks> peaks, double BlockPeaks::*value, double BlockPeaks::*time,
             const char* unit) {
  const auto most = std::ranges::max_element(peaks, {}, value);
  return {{"block", model.blocks[static_cast<std::size_t>(most - peaks.begin())].name},
          {unit, (*most).*value},
          {"time_s", (*most).*time}};
}

}  // namespace

std::string peaks_csv(const Model& model, std::span<const BlockPeaks> peaks) {
  std::string text = header(*model.peaks);
  for (std::size_t i = 0; i < peaks.size(); ++i)
    if (peaks[i].takes_part) text += row(model, i, peaks[i]);
  return text;
}

nlohmann::ordered_json peaks_json(const Model& model, std::span<const BlockPeaks> peaks, bool is_over) {
  const PeakRequest& asked = *model.peaks;
  double kinetic = 0;
  for (const BlockPeaks& block : peaks) kinetic += block.kinetic;
  Json json = {{"stage", model.stages[static_cast<std::size_t>(asked.stage)].name},
               {"complete", is_over},
               {"blocks", std::ranges::count(peaks, true, &BlockPeaks::takes_part)},
               {"kinetic_energy_J_per_m", kinetic}};
  json["velocity"] = largest(model, peaks, &BlockPeaks::speed, &BlockPeaks::speed_time, "m_s");
  json["acceleration"] = largest(model, peaks, &BlockPeaks::acceleration, &BlockPeaks::acceleration_time, "m_s2");
  json["ejected"] = asked.ejection ? to_json(*asked.ejection, ejection_of(model, peaks)) : Json(nullptr);
  json["attenuation"] = asked.attenuation ? to_json(*asked.attenuation, peaks) : Json(nullptr);
  return json;
}

}  // namespace dda
