#include <fmt/format.h>

#include "verification/stability/chart.h"

namespace verify {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Cell& cell) {
  const Setting& setting = cell.setting;
  Json json = {{"problem", name_of(setting.problem)},
               {"integrator", setting.integrator},
               {"penalty_over_young", setting.penalty},
               {"dt_s", setting.dt},
               {"mass_ratio", setting.mass_ratio},
               {"aspect", setting.aspect},
               {"steps", steps_of(setting)},
               {"outcome", name_of(cell.outcome)}};
  add_reasons(cell, json);
  if (!cell.scene.empty()) json["scene"] = cell.scene;
  json["cpu_s"] = cell.cpu_s;
  return json;
}

// A line a cell: files of two versions can be compared.
std::string lines_of(const std::vector<Cell>& cells) {
  std::vector<std::string> lines;
  for (const Cell& cell : cells) lines.push_back("    " + json_of(cell).dump());
  return fmt::format("{}", fmt::join(lines, ",\n"));
}

}  // namespace

std::string to_json(const StabilityChart& chart) {
  return fmt::format("{{\"version\": 1,\n  \"penalty_over_dt\": [\n{}],\n  \"mass_ratio_over_aspect\": [\n{}]}}\n",
                     lines_of(chart.steps), lines_of(chart.blocks));
}

}  // namespace verify
