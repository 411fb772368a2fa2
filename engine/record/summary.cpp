#include "engine/record/summary.h"

#include <nlohmann/json.hpp>
#include <string>

#include "engine/model/energy_release.h"
#include "engine/record/atomic_file.h"
#include "engine/record/energy_terms.h"

namespace dda {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Counters& counters) {
  Json json = Json::object();
  for (const CounterField& field : counter_fields) json[field.name] = counters.*field.value;
  return json;
}

Json to_json(const EnergyLedger& energy) {
  Json json = {{"unit", "J per m of thickness"}};
  for (const StoredTerm& term : stored_terms) json[term.name] = energy.*term.now;
  for (const StoredTerm& term : stored_terms) json[std::string("initial_") + term.name] = energy.initial.*term.initial;
  for (const FlowTerm& term : flow_terms) json[term.name] = energy.*term.sum;
  json["residual"] = energy.residual();
  json["residual_relative"] = energy.relative_residual();
  return json;
}

// In both of Salamon's forms, see model/energy_release.h.
Json to_json(const EnergyRelease& release) {
  return {{"unit", "J per m of thickness"},
          {"W", release.work},
          {"Uc", release.strain},
          {"Ub", release.potential},
          {"Wj", release.joints},
          {"Wp", release.plastic},
          {"Uk", release.kinetic},
          {"Wk", release.damping},
          {"Wv", release.radiated},
          {"Um", release.removed},
          {"released_by_work", release.by_work()},
          {"released_by_fate", release.by_fate()},
          {"difference_relative", release.relative_difference()}};
}

Json released_in_stages(const RunSummary& summary) {
  Json stages = Json::array();
  const EnergyLedger* before = nullptr;
  for (const auto& [name, energy] : summary.energy_at_end) {
    Json entry = {{"stage", name}};
    entry.update(to_json(before == nullptr ? energy_release(energy, summary.steps)
                                           : energy_release(*before, energy, summary.steps)));
    stages.push_back(entry);
    before = &energy;
  }
  return stages;
}

Json to_json(const HistoryFile& history) {
  Json columns = Json::array();
  columns.push_back({{"name", "time"}, {"unit", "s"}});
  for (const Column& column : history.columns) columns.push_back({{"name", column.name}, {"unit", column.unit}});
  return {{"file", history.file}, {"rows", history.rows}, {"columns", columns}};
}

Json to_json(const DeepestPenetration& deepest) {
  return {{"depth_m", deepest.depth_m},
          {"of_smaller_block", deepest.share},
          {"blocks", Json::array({deepest.blocks.first, deepest.blocks.second})},
          {"time_s", deepest.time_s}};
}

Json to_json(const RunSummary& summary) {
  Json json = {{"status", to_string(summary.status)},
               {"message", summary.message},
               {"title", summary.title},
               {"from", summary.from.empty() ? Json(nullptr) : Json(summary.from)},
               {"time_s", summary.time_s},
               {"steps", summary.steps},
               {"blocks", summary.blocks},
               {"contacts", summary.contacts},
               {"solver", summary.solver},
               {"cpu_s", summary.cpu_s},
               {"wall_s", summary.wall_s}};
  json["phases"] = Json::object();
  for (const auto& [name, seconds] : summary.phases) json["phases"][name] = seconds;
  json["stages"] = Json::array();
  for (const StageTimes& stage : summary.stages)
    json["stages"].push_back({{"name", stage.name},
                              {"begin_s", stage.begin_s},
                              {"end_s", stage.end_s},
                              {"settles", stage.settles},
                              {"first_dt_s", stage.first_dt_s},
                              {"dt_s", stage.dt_s},
                              {"dt_reason", stage.dt_reason},
                              {"stable_dt_s", stage.stable_dt_s > 0 ? Json(stage.stable_dt_s) : Json(nullptr)},
                              {"integrator", stage.integrator},
                              {"integrator_reason", stage.integrator_reason}});
  json["static_stages"] = Json::array();
  for (const auto& [name, share] : summary.out_of_balance)
    json["static_stages"].push_back({{"name", name}, {"out_of_balance", share}});
  json["loose_blocks"] = summary.loose_blocks;
  json["blocks_out_of_balance"] = summary.blocks_out_of_balance;
  json["counters"] = to_json(summary.counters);
  json["energy"] = to_json(summary.energy);
  json["energy_released"] = to_json(energy_release(summary.energy, summary.steps));
  json["energy_released"]["stages"] = released_in_stages(summary);
  json["energy_release_rates"] = summary.energy_release_rates;
  json["excess_shear"] = summary.excess_shear;
  if (!summary.linings.is_null()) json["linings"] = summary.linings;
  if (!summary.peaks.is_null()) json["peaks"] = summary.peaks;
  json["deepest_penetration"] = summary.penetration ? to_json(*summary.penetration) : Json(nullptr);
  if (!summary.unsettled_steps.is_null()) json["unsettled_steps"] = summary.unsettled_steps;
  json["remarks"] = summary.remarks;
  json["histories"] = Json::array();
  for (const HistoryFile& history : summary.histories) json["histories"].push_back(to_json(history));
  json["outputs"] = summary.outputs;
  return json;
}

}  // namespace

std::string summary_json(const RunSummary& summary) {
  return to_json(summary).dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

void write_summary(const std::filesystem::path& path, const RunSummary& summary) {
  write_file(path, summary_json(summary));
}

}  // namespace dda
