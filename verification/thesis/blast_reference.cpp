#include "verification/thesis/blast_reference.h"

#include <nlohmann/json.hpp>
#include <numbers>

#include "verification/exact/wave_speeds.h"

namespace verify {
namespace {

using Json = nlohmann::json;

std::vector<PrintedArrival> read_points(const Json& tables) {
  const Json& table = tables.at("table_4_1");
  const Json& distances = tables.at("inferred").at("distances").at("values");
  std::vector<PrintedArrival> points;
  for (std::size_t i = 0; i < table.at("points").size(); ++i) {
    PrintedArrival point;
    point.point = table.at("points").at(i).get<std::string>();
    point.distance = distances.at(i).get<double>();
    point.predicted_ms = std::stod(table.at("predicted").at(i).get<std::string>());
    const std::string actual = table.at("actual").at(i).get<std::string>();
    if (actual != "N/A") point.actual_ms = std::stod(actual);
    points.push_back(point);
  }
  return points;
}

ThesisBlast read_blast() {
  const Json tables = Json::parse(thesis_blast_text());
  const auto section = [&](const char* name) { return tables.at("section_4_1").at(name).at("value").get<double>(); };
  const auto result = [&](const char* name) { return tables.at("section_4_2").at(name).at("value").get<double>(); };
  ThesisBlast blast;
  blast.density = section("density");
  blast.young = section("young");
  blast.poisson = section("poisson");
  blast.friction_angle = section("friction_angle") * std::numbers::pi / 180;
  blast.time_step = section("time_step");
  blast.octagon_edge = section("octagon_edge");
  blast.peak_pressure = section("peak_pressure");
  blast.block_along_x = section("block_along_x");
  blast.block_along_y = section("block_along_y");
  blast.level_stress = result("largest_horizontal_stress");
  blast.upright_stress = result("largest_vertical_stress");
  blast.points = read_points(tables);
  return blast;
}

}  // namespace

double ThesisBlast::octagon_width() const { return (1 + std::numbers::sqrt2) * octagon_edge; }

double ThesisBlast::speed_plane_stress() const { return exact::p_speed_plane_stress(young, poisson, density); }

double ThesisBlast::speed_plane_strain() const { return exact::p_speed_plane_strain(young, poisson, density); }

const ThesisBlast& thesis_blast() {
  static const ThesisBlast blast = read_blast();
  return blast;
}

}  // namespace verify
