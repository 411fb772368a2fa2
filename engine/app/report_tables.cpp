#include "engine/app/report_tables.h"

#include <fmt/format.h>

#include "engine/record/vtp_file.h"

namespace dda {

std::string table(const TableRow& head, const std::vector<TableRow>& rows) {
  if (rows.empty()) return "";
  std::string text = "<table>";
  const auto append = [&](const TableRow& row, const char* cell) {
    text += "<tr>";
    for (const std::string& value : row) text += fmt::format("<{0}>{1}</{0}>", cell, xml_escaped(value));
    text += "</tr>\n";
  };
  if (!head.empty()) append(head, "th");
  for (const TableRow& row : rows) append(row, "td");
  return text + "</table>\n";
}

std::string shown(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return fmt::format("{:.6g}", value.get<double>());
  if (value.is_null()) return "-";
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string shown(const Json& object, const char* key) { return object.contains(key) ? shown(object[key]) : "-"; }

namespace {

// "density 2650 kg/m3, young 50 GPa" of an entry of a scene.
std::string properties(const Json& entry) {
  std::string text;
  for (const auto& [key, value] : entry.items()) text += (text.empty() ? "" : ", ") + key + " " + shown(value);
  return text;
}

std::vector<TableRow> named_entries(const Json& scene, const char* key) {
  std::vector<TableRow> rows;
  if (scene.contains(key) && scene[key].is_object())
    for (const auto& [name, entry] : scene[key].items()) rows.push_back({name, properties(entry)});
  return rows;
}

std::size_t count_of(const Json& scene, const char* key) {
  if (!scene.contains(key)) return 0;
  return scene[key].is_array() ? scene[key].size() : 1;
}

std::vector<TableRow> sizes(const Json& summary, const Json& scene) {
  std::vector<TableRow> rows = {{"blocks", shown(summary, "blocks")},
                                {"contacts", shown(summary, "contacts")},
                                {"solver", shown(summary, "solver")}};
  for (const char* key : {"gravity", "stress_field", "scheme", "plane"})
    if (scene.contains(key)) rows.push_back({key, shown(scene[key])});
  for (const char* key : {"loads", "fixed", "supports", "bolts", "linings", "viscous_boundaries", "measurements"})
    if (const std::size_t count = count_of(scene, key); count > 0) rows.push_back({key, fmt::format("{}", count)});
  return rows;
}

std::string balance_of(const Json& summary, const Json& stage) {
  for (const Json& settled : summary.value("static_stages", Json::array()))
    if (settled["name"] == stage["name"]) return shown(settled["out_of_balance"]);
  return "-";
}

std::string steps_of(const Json& stage) {
  const double dt = stage.value("dt_s", 0.0);
  if (dt == 0) return "its own";
  const double first = stage.value("first_dt_s", dt);
  return first < dt ? fmt::format("{} to {}", shown(first), shown(dt)) : shown(dt);
}

std::vector<TableRow> stages(const Json& summary) {
  std::vector<TableRow> rows;
  for (const Json& stage : summary.value("stages", Json::array())) {
    rows.push_back({shown(stage["name"]), shown(stage["begin_s"]), shown(stage["end_s"]), steps_of(stage),
                    shown(stage["dt_reason"]), balance_of(summary, stage)});
  }
  return rows;
}

constexpr const char* release_keys[] = {
    "W", "Uc", "Ub", "Wj", "Wp", "Uk", "Wk", "Wv", "Um", "released_by_work", "released_by_fate"};

TableRow release_row(const std::string& name, const Json& release) {
  TableRow row = {name};
  for (const char* key : release_keys) row.push_back(shown(release, key));
  return row;
}

}  // namespace

std::string section(std::string_view title, const std::string& content) {
  return content.empty() ? "" : fmt::format("<section><h2>{}</h2>\n{}</section>\n", xml_escaped(title), content);
}

std::string scene_tables(const Json& summary, const Json& request) {
  const Json scene = request.value("scene", Json::object());
  return table({}, sizes(summary, scene)) + table({"material", ""}, named_entries(scene, "materials")) +
         table({"joint", ""}, named_entries(scene, "joints")) +
         table({"stage", "begins (s)", "ends (s)", "dt (s)", "why this dt", "out of balance"}, stages(summary));
}

std::string release_table(const Json& summary) {
  if (!summary.contains("energy_released")) return "";
  const Json& release = summary["energy_released"];
  std::vector<TableRow> rows;
  for (const Json& stage : release.value("stages", Json::array()))
    rows.push_back(release_row(shown(stage["stage"]), stage));
  rows.push_back(release_row("whole run", release));
  return table({"J per m", "W work", "Uc stored", "Ub height", "Wj friction", "Wp plastic", "Uk motion", "Wk damping",
                "Wv radiated", "Um removed", "W - (Uc + Ub + Wj + Wp)", "Uk + Wk + Wv + Um"},
               rows) +
         fmt::format("<p>Energy released, in both forms of Salamon; they differ by {} of the largest entry.</p>\n",
                     shown(release, "difference_relative"));
}

std::string release_rate_table(const Json& summary) {
  std::vector<TableRow> rows;
  for (const Json& rate : summary.value("energy_release_rates", Json::array()))
    rows.push_back({shown(rate["stage"]), shown(rate["released_J_per_m"]), shown(rate["area_m2"]),
                    shown(rate["wall_m"]), shown(rate["per_volume_J_per_m3"]), shown(rate["per_wall_J_per_m2"])});
  return table(
      {"taken out in stage", "released (J/m)", "area (m2)", "wall (m)", "ERR per volume (J/m3)", "ERR per wall (J/m2)"},
      rows);
}

std::string excess_shear_table(const Json& summary) {
  std::vector<TableRow> rows;
  for (const Json& each : summary.value("excess_shear", Json::array()))
    rows.push_back({shown(each["stage"]), shown(each["joint"]), shown(each["largest_Pa"]), shown(each["between"]),
                    shown(each["place_m"]), shown(each["normal_Pa"]), shown(each["shear_Pa"]),
                    shown(each["positive_m"]), shown(each["length_m"])});
  return table({"end of stage", "joint", "largest ESS (Pa)", "between", "at (m)", "normal (Pa)", "shear (Pa)",
                "above 0 on (m)", "of (m)"},
               rows);
}

namespace {

std::string faces_of(const Json& block) {
  std::string text;
  for (const Json& face : block.value("held_by", Json::array()))
    text += fmt::format("{}\"{}\" at {} m", text.empty() ? "" : ", ", shown(face["block"]), shown(face["place_m"]));
  return text.empty() ? "no face" : text;
}

std::string unbalanced_sentence(const char* what, const Json& block) {
  return fmt::format("{} block \"{}\" (number {}, {} kg/m) at {} m in stage \"{}\", held by {}", what,
                     shown(block["block"]), shown(block, "number"), shown(block, "mass_kg_per_m"),
                     shown(block["place_m"]), shown(block["stage"]), faces_of(block));
}

}  // namespace

std::string warning_list(const Json& summary) {
  std::string items;
  const auto add = [&](const std::string& text) { items += "<li>" + xml_escaped(text) + "</li>\n"; };
  if (const std::string message = summary.value("message", ""); !message.empty()) add(message);
  for (const Json& loose : summary.value("loose_blocks", Json::array()))
    add(unbalanced_sentence("without equilibrium:", loose));
  for (const Json& block : summary.value("blocks_out_of_balance", Json::array()))
    add(unbalanced_sentence("out of balance:", block));
  if (const Json deepest = summary.value("deepest_penetration", Json()); deepest.is_object())
    add(fmt::format("deepest penetration: {} m, {:.2g} % of the smaller block, at {} s between {}",
                    shown(deepest["depth_m"]), 100 * deepest.value("of_smaller_block", 0.0), shown(deepest["time_s"]),
                    shown(deepest["blocks"])));
  for (const Json& remark : summary.value("remarks", Json::array())) add("remark: " + shown(remark));
  return items.empty() ? "<p>None.</p>\n" : "<ul>\n" + items + "</ul>\n";
}

std::string cost_tables(const Json& summary) {
  std::vector<TableRow> counters;
  const Json counts = summary.value("counters", Json::object());
  for (const auto& [name, value] : counts.items()) counters.push_back({name, shown(value)});
  std::vector<TableRow> seconds = {{"processor", shown(summary, "cpu_s")}, {"clock", shown(summary, "wall_s")}};
  const Json phases = summary.value("phases", Json::object());
  for (const auto& [name, value] : phases.items()) seconds.push_back({name, shown(value)});
  return table({"counter", ""}, counters) + table({"seconds", ""}, seconds);
}

}  // namespace dda
