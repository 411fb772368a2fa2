#include "verification/study/judged_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace verify {

using Json = nlohmann::ordered_json;

Json json_of(const Check& check) {
  return {{"what", check.what},
          {"value", std::isfinite(check.value) ? Json(check.value) : Json(nullptr)},
          {"allowed", check.allowed},
          {"holds", check.holds()}};
}

std::string first_failure(const std::vector<Check>& checks) {
  const auto failed = std::ranges::find_if_not(checks, &Check::holds);
  return failed == checks.end()
             ? ""
             : fmt::format("{}: {:.3g}, {:.2g} is allowed", failed->what, failed->value, failed->allowed);
}

const std::string& name_of(RunOutcome outcome, const OutcomeNames& names) {
  return std::ranges::find(names, outcome, &OutcomeNames::value_type::first)->second;
}

void add_reasons(const JudgedRun& run, Json& json) {
  if (!run.message.empty()) json["message"] = run.message;
  if (!run.said.empty()) json["said"] = run.said;
  for (const Check& check : run.checks) json["checks"].push_back(json_of(check));
}

void read_reasons(const Json& json, JudgedRun& run) {
  run.message = json.value("message", "");
  run.said = json.value("said", std::vector<std::string>());
  for (const Json& check : json.value("checks", Json::array())) {
    const Json& value = check.at("value");
    const double read = value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>();
    run.checks.push_back({check.at("what"), read, check.at("allowed")});
  }
}

std::string count_line(std::size_t count, const std::string& name) { return fmt::format("{:5} {}\n", count, name); }

}  // namespace verify
