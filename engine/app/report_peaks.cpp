#include "engine/app/report_peaks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/record/csv.h"
#include "engine/record/run_folder.h"
#include "engine/record/vtp_file.h"
#include "engine/view/line_plot.h"

namespace dda {
namespace {

// The numbers of peaks.csv by column; what is empty is NaN.
class PeakTable {
 public:
  explicit PeakTable(std::filesystem::path path) : path_(std::move(path)) {
    const std::string file = read_file(path_);
    std::string_view rest = file;
    names_ = take_csv_row(rest);
    while (!rest.empty()) rows_.push_back(take_csv_row(rest));
  }

  [[nodiscard]] std::vector<double> column(const std::string& name) const {
    const auto place = static_cast<std::size_t>(std::ranges::find(names_, name) - names_.begin());
    if (place == names_.size()) refuse("without a column " + name);
    std::vector<double> values;
    for (const auto& row : rows_) values.push_back(place < row.size() ? number(row[place]) : missing);
    return values;
  }

 private:
  static constexpr double missing = std::numeric_limits<double>::quiet_NaN();

  [[nodiscard]] double number(const std::string& text) const {
    if (text.empty()) return missing;
    const auto value = csv_number(text);
    if (!value) refuse("with \"" + text + "\" for a number");
    return *value;
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(path_.string(), "the table", what, "what dda run has written");
  }

  std::filesystem::path path_;
  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> rows_;
};

std::string peak_sentence(const Json& peaks) {
  return fmt::format(
      "<p>In stage {}{}: largest velocity {} m/s, of {} at {} s; largest acceleration {} m/s2, of {} at {} s; kinetic "
      "energy of all blocks at the end {} J/m. All blocks are in {}.</p>\n",
      xml_escaped(shown(peaks["stage"])), peaks.value("complete", false) ? "" : ", which did not come to its end",
      shown(peaks["velocity"]["m_s"]), xml_escaped(shown(peaks["velocity"]["block"])),
      shown(peaks["velocity"]["time_s"]), shown(peaks["acceleration"]["m_s2"]),
      xml_escaped(shown(peaks["acceleration"]["block"])), shown(peaks["acceleration"]["time_s"]),
      shown(peaks["kinetic_energy_J_per_m"]), peaks_name);
}

std::string wall_sentence(const Json& ejected) {
  if (!ejected["wall_m"].is_number()) return "";
  return fmt::format("; over the wall of {}, {} m: {} kJ/m2", xml_escaped(shown(ejected["opening"])),
                     shown(ejected["wall_m"]), shown(ejected["kinetic_energy_kJ_per_m2"]));
}

std::string ejection_part(const Json& ejected) {
  std::vector<TableRow> rows;
  for (const Json& each : ejected.value("velocities", Json::array()))
    rows.push_back({fmt::format("{} to {}", shown(each["from_m_s"]), shown(each["to_m_s"])), shown(each["blocks"]),
                    shown(each["mass_kg_per_m"]), shown(each["kinetic_energy_J_per_m"])});
  return fmt::format("<p>Ejected: {} blocks, {} kg/m, {} J/m at their ejection velocities{}.</p>\n",
                     shown(ejected["blocks"]), shown(ejected["mass_kg_per_m"]),
                     shown(ejected["kinetic_energy_J_per_m"]), wall_sentence(ejected)) +
         table({"ejection velocity (m/s)", "blocks", "mass (kg/m)", "kinetic energy (J/m)"}, rows);
}

// Blocks that count for the fit, nearest first.
LinePlot attenuation_plot(const Json& law, const PeakTable& blocks) {
  const std::vector<double> distance = blocks.column("scaled_distance [m/sqrt(kg/m)]");
  const std::vector<double> speed = blocks.column("velocity [m/s]");
  const std::vector<double> counts = blocks.column("in_fit [-]");
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i < distance.size(); ++i)
    if (counts[i] == 1) points.emplace_back(distance[i], speed[i]);
  std::ranges::sort(points);
  LinePlot plot{"Peak velocity", "m/s", {}, {{"blocks", {}, true}, {"fit", {}}}, true, "scaled distance R/sqrt(W)",
                "m/sqrt(kg/m)",  true};
  for (const auto& [x, y] : points) {
    plot.times.push_back(x);
    plot.lines[0].values.push_back(y);
    plot.lines[1].values.push_back(law["K_m_s"].get<double>() * std::pow(x, -law["n"].get<double>()));
  }
  return plot;
}

std::string attenuation_part(const Json& law, const std::filesystem::path& folder) {
  if (!law["K_m_s"].is_number())
    return fmt::format("<p>Peak velocity over distance: no fit of {} blocks.</p>\n", shown(law["points"]));
  return fmt::format(
             "<p>Peak velocity v = K (R/sqrt(W))^-n with K = {} m/s, n = {}: correlation {} of the logarithms, {} "
             "blocks, from {} m, W = {} kg/m.</p>\n<div class=\"plots\">\n",
             shown(law["K_m_s"]), shown(law["n"]), shown(law["correlation"]), shown(law["points"]),
             shown(law["source_m"]), shown(law["charge_kg_per_m"])) +
         svg_plot(attenuation_plot(law, PeakTable(folder / peaks_name))) + "</div>\n";
}

}  // namespace

std::string peaks_part(const Json& summary, const std::filesystem::path& folder) {
  const Json peaks = summary.value("peaks", Json());
  if (!peaks.is_object()) return "";
  std::string text = peak_sentence(peaks);
  if (peaks["ejected"].is_object()) text += ejection_part(peaks["ejected"]);
  if (peaks["attenuation"].is_object()) text += attenuation_part(peaks["attenuation"], folder);
  return text;
}

}  // namespace dda
