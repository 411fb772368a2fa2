#include "verification/thesis/calibration_json.h"

#include <nlohmann/json.hpp>
#include <string_view>

#include "verification/study/values.h"

namespace verify {
namespace {

using Json = nlohmann::ordered_json;

std::string_view name_of(AmplitudeReading reading) {
  return reading == AmplitudeReading::half_range ? "half_range" : "first_peak";
}

void add_extras(const CalibrationRow& row, Json& json) {
  json["amplitude_reading"] = name_of(row.reading);
  json["half_range_kpa"] = row.picks.half_range / 1e3;
  json["first_peak_kpa"] = row.picks.first_peak / 1e3;
  json["place_m"] = row.place;
  json["closed_form_amplitude_kpa"] = row.amplitude_of(row.closed_form_picks) / 1e3;
  json["closed_form_velocity_onset_m_s"] = row.closed_form_picks.onset_velocity;
  json["closed_form_velocity_xcorr_m_s"] = row.closed_form_picks.correlation_velocity;
  json["solver"] = to_string(row.solver);
  json["setup_cpu_s"] = row.setup_cpu_s;
}

Json json_of(const CalibrationRow& row, const ThesisBar& bar) {
  Json json;
  json["scheme"] = row.scheme;
  json["dt_s"] = row.dt;
  json["block_length_m"] = row.block_length;
  json["eta"] = bar.eta(row.block_length);
  json["amplitude_kpa"] = row.amplitude() / 1e3;
  json["amplitude_error_pct"] = row.amplitude_error_pct();
  json["velocity_onset_m_s"] = row.picks.onset_velocity;
  json["velocity_xcorr_m_s"] = row.picks.correlation_velocity;
  json["velocity_xcorr_error_pct"] = row.correlation_error_pct();
  json["thesis_amplitude_kpa"] = row.printed.amplitude_kpa;
  json["thesis_velocity_m_s"] = row.printed.velocity;
  json["amplitude_vs_thesis_pct"] = or_null(row.amplitude_vs_thesis_pct());
  json["velocity_vs_thesis_pct"] = or_null(row.velocity_vs_thesis_pct());
  json["oracle_max_rel_diff"] = row.oracle_max_rel_diff;
  json["steps"] = row.steps;
  json["cpu_s"] = row.cpu_s;
  json["factorizations"] = row.factorizations;
  json["matrix_rebuilds"] = row.matrix_rebuilds;
  json["solver_iterations"] = row.solver_iterations;
  json["energy_residual_rel"] = row.energy_residual_rel;
  add_extras(row, json);
  return json;
}

Json json_of(const OracleResult& result) {
  return {{"law", result.law},
          {"integrator", result.integrator},
          {"dt_s", result.dt},
          {"block_length_m", result.block_length},
          {"max_rel_diff", result.max_rel_diff}};
}

Json json_of(const Promise& promise) {
  return {{"claim", promise.claim}, {"measured", promise.measured}, {"kept", promise.kept()}};
}

template <typename Item, typename Convert>
Json list(const std::vector<Item>& items, const Convert& convert) {
  Json json = Json::array();
  for (const Item& item : items) json.push_back(convert(item));
  return json;
}

}  // namespace

std::string to_json(const Calibration& calibration, const std::vector<Promise>& promises) {
  Json json;
  json["rows"] = list(calibration.rows, [&](const CalibrationRow& row) { return json_of(row, calibration.bar); });
  json["oracle"] = list(calibration.oracle, [](const OracleResult& result) { return json_of(result); });
  json["promises"] = list(promises, [](const Promise& promise) { return json_of(promise); });
  json["bar_wave_speed_m_s"] = calibration.bar.wave_speed();
  json["incident_stress_kpa"] = calibration.bar.incident_stress() / 1e3;
  json["window_end_s"] = window_end(calibration.bar);
  json["duration_s"] = calibration.duration;
  json["repetitions"] = calibration.repetitions;
  return json.dump(1) + "\n";
}

}  // namespace verify
