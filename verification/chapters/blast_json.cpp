// blast.json: the blast study, so that it need not be run again.
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/record/atomic_file.h"
#include "engine/record/progress.h"
#include "verification/chapters/chapter_4.h"

namespace verify {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const BlastReading& r) { return {r.peak_time, r.peak_velocity, r.peak_stress}; }
BlastReading reading_from(const Json& json) { return {json.at(0), json.at(1), json.at(2)}; }

Json json_of(const BlastResult& result) {
  Json readings = Json::array();
  for (const BlastReading& reading : result.readings) readings.push_back(json_of(reading));
  return {{"name", result.name},
          {"description", result.description},
          {"largest_without", result.largest_without},
          {"cpu_s", result.cpu_s},
          {"readings", readings}};
}

BlastResult result_from(const Json& json) {
  BlastResult result{json.at("name"), json.at("description"), {}, json.at("largest_without"), json.at("cpu_s")};
  for (const Json& reading : json.at("readings")) result.readings.push_back(reading_from(reading));
  return result;
}

std::vector<PrintedArrival> points_named(const Json& names) {
  std::vector<PrintedArrival> points;
  for (const Json& name : names)
    for (const PrintedArrival& point : thesis_blast().points)
      if (point.point == name) points.push_back(point);
  return points;
}

}  // namespace

std::string blast_json(const BlastStudy& study) {
  Json json = {{"blocks", study.blocks}, {"dt", study.dt}, {"duration", study.duration}};
  json["reading"] = "[time of the largest velocity s, that velocity m/s, largest compression Pa]";
  for (const PrintedArrival& point : study.points) json["points"].push_back(point.point);
  for (const BlastResult& result : study.results) json["results"].push_back(json_of(result));
  for (const DecayResult& d : study.decays)
    json["decays"].push_back({{"decay_time", d.decay_time}, {"H1", json_of(d.level)}, {"V1", json_of(d.upright)}});
  json["edges"] = Json::array();
  for (const EdgeResult& edge : study.edges)
    json["edges"].push_back({{"name", edge.name}, {"point", edge.point}, {"difference", edge.difference}});
  return json.dump(1) + "\n";
}

BlastStudy blast_from_json(std::string_view text) {
  try {
    const Json json = Json::parse(text);
    BlastStudy study;
    study.blocks = json.at("blocks");
    study.dt = json.at("dt");
    study.duration = json.at("duration");
    study.points = points_named(json.at("points"));
    for (const Json& result : json.at("results")) study.results.push_back(result_from(result));
    for (const Json& d : json.at("decays"))
      study.decays.push_back({d.at("decay_time"), reading_from(d.at("H1")), reading_from(d.at("V1"))});
    for (const Json& e : json.at("edges")) study.edges.push_back({e.at("name"), e.at("point"), e.at("difference")});
    return study;
  } catch (const Json::exception&) {
    throw dda::InputError("blast.json", "its content", "no blast study",
                          "what this command writes; remove the file to run the study again");
  }
}

BlastStudy chapter_4_study(const std::filesystem::path& folder) {
  const auto file = folder / "blast.json";
  if (std::filesystem::exists(file)) return blast_from_json(dda::read_file(file));
  std::filesystem::create_directories(folder);
  BlastStudy study = run_blast_study(thesis_blast(), {.progress = dda::terminal()});
  dda::write_file(file, blast_json(study));
  return study;
}

}  // namespace verify
