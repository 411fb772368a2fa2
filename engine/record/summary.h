// The result summary of a run as JSON.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/counters.h"
#include "engine/core/status.h"
#include "engine/model/energy.h"
#include "engine/record/history_writer.h"

namespace dda {

struct HistoryFile {
  std::string file;
  std::int64_t rows = 0;
  std::vector<Column> columns;  // after the time
};

// The deepest that two blocks were pressed into each other.
struct DeepestPenetration {
  double depth_m = 0;
  double share = 0;  // of the size of the smaller block
  std::pair<std::string, std::string> blocks;
  double time_s = 0;
};

// When a stage of the scene lasts, and in which steps; `settles`: its time passes in no motion (it ends at static
// equilibrium).
struct StageTimes {
  std::string name;
  double begin_s = 0;
  double end_s = 0;
  bool settles = false;
  double first_dt_s = 0;  // less than dt_s where steps grow
  double dt_s = 0;        // 0: steps of no time, which the stage finds itself
  std::string dt_reason;  // why the engine chose dt; empty where the scene gives it
  std::string integrator;
  std::string integrator_reason;  // why the engine chose that; empty where it had no choice
  double stable_dt_s = 0;         // up to which explicit steps are stable; 0 where steps are implicit
};

struct RunSummary {
  Status status = Status::ok;
  std::string message;  // one sentence when status is not ok
  std::string title;
  std::string from;   // the run that this one went on from, empty where it began by itself
  double time_s = 0;  // reached by the simulation
  std::int64_t steps = 0;
  Counters counters;
  EnergyLedger energy;
  std::vector<std::pair<std::string, EnergyLedger>> energy_at_end;  // of stages that are over, by name
  double cpu_s = 0;
  double wall_s = 0;
  std::vector<std::pair<std::string, double>> phases;  // name and seconds, in the order of the run
  std::vector<StageTimes> stages;
  std::vector<std::pair<std::string, double>> out_of_balance;  // static stages: name and share of the largest force
  nlohmann::ordered_json loose_blocks = nlohmann::ordered_json::array();           // that nothing held in static stages
  nlohmann::ordered_json blocks_out_of_balance = nlohmann::ordered_json::array();  // at their ends
  nlohmann::ordered_json excess_shear = nlohmann::ordered_json::array();           // at ends of stages, by joint
  nlohmann::ordered_json energy_release_rates = nlohmann::ordered_json::array();   // of stages that remove blocks
  std::string solver;
  std::int64_t blocks = 0;
  std::int64_t contacts = 0;
  nlohmann::ordered_json linings;  // null, and left out: there are none
  nlohmann::ordered_json peaks;    // null, and left out: not asked for, or the run did not come to their stage
  std::optional<DeepestPenetration> penetration;  // none: no contacts that can change, or never pressed
  nlohmann::ordered_json unsettled_steps;         // null, and left out: there were none
  std::vector<std::string> remarks;               // on what is legal in the scene but odd
  std::vector<HistoryFile> histories;
  std::vector<std::string> outputs;  // files written
};

// JSON text; numbers that are not finite become null, bytes that are not UTF-8 the replacement character.
std::string summary_json(const RunSummary& summary);

// Writes the text whole or not at all; std::runtime_error naming path and reason.
void write_summary(const std::filesystem::path& path, const RunSummary& summary);

}  // namespace dda
