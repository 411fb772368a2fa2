// What the page of `dda report` says in tables.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace dda {

using Json = nlohmann::ordered_json;

using TableRow = std::vector<std::string>;

// Returns a table in HTML of texts as people read them, or nothing where there are no rows.
std::string table(const TableRow& head, const std::vector<TableRow>& rows);

// A value of a scene or summary as people read it: texts without quotes, numbers short. "-": null, or no such key.
std::string shown(const Json& value);
std::string shown(const Json& object, const char* key);

// "<h2>title</h2>" and what follows it, nothing where that is empty.
std::string section(std::string_view title, const std::string& content);

// What was run: sizes, materials, joints and stages. `request`: run.json.
std::string scene_tables(const Json& summary, const Json& request);

// Energies released, over the run and stage by stage.
std::string release_table(const Json& summary);

// The energy that stages which take rock out release, and the same over the area and over the wall.
std::string release_rate_table(const Json& summary);

// Largest excess shear stress of every joint at the ends of stages.
std::string excess_shear_table(const Json& summary);

// Message, blocks without equilibrium and the faces that hold them, deepest penetration and remarks.
std::string warning_list(const Json& summary);

// Counters and seconds.
std::string cost_tables(const Json& summary);

}  // namespace dda
