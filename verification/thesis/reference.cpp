#include "verification/thesis/reference.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>

namespace verify {
namespace {

using Json = nlohmann::json;

ThesisBar read_bar(const Json& tables) {
  const auto table = [&](const char* name) { return tables.at("table_3_1").at(name).at("value").get<double>(); };
  const auto section = [&](const char* name) { return tables.at("section_3_1").at(name).at("value").get<double>(); };
  ThesisBar bar;
  bar.density = table("density");
  bar.young = table("young");
  bar.poisson = table("poisson");
  bar.friction_angle = table("friction_angle") * std::numbers::pi / 180;
  bar.cohesion = table("cohesion");
  bar.tensile_strength = table("tensile_strength");
  bar.length = section("bar_length");
  bar.height = section("bar_height");
  bar.measuring_point = section("measuring_point");
  bar.load_amplitude = section("load_amplitude");
  bar.load_frequency = section("load_frequency");
  return bar;
}

double number(const Json& row, std::size_t column) {
  return std::stod(row.at("printed").at(column).get<std::string>());
}

ThesisReference read_reference() {
  const Json tables = Json::parse(thesis_tables_text());
  ThesisReference reference;
  reference.bar = read_bar(tables);
  reference.block_lengths = tables.at("block_lengths").at("values").get<std::vector<double>>();
  const Json& amplitudes = tables.at("table_3_2").at("rows");
  const Json& velocities = tables.at("table_3_3").at("rows");
  for (std::size_t i = 0; i < amplitudes.size(); ++i) {
    const double dt = amplitudes.at(i).at("dt_s");
    if (velocities.at(i).at("dt_s") != dt) throw std::logic_error("Tables 3.2 and 3.3 differ in their time steps");
    reference.time_steps.push_back(dt);
    for (std::size_t j = 0; j < reference.block_lengths.size(); ++j)
      reference.printed.push_back(
          {dt, reference.block_lengths[j], number(amplitudes.at(i), j), number(velocities.at(i), j)});
  }
  return reference;
}

}  // namespace

double ThesisBar::wave_speed() const { return std::sqrt(young / density); }

const PrintedResult& ThesisReference::at(double dt, double block_length) const {
  for (const PrintedResult& result : printed)
    if (result.dt == dt && result.block_length == block_length) return result;
  throw std::out_of_range("no such column in the thesis' tables");
}

const ThesisReference& thesis_reference() {
  static const ThesisReference reference = read_reference();
  return reference;
}

}  // namespace verify
