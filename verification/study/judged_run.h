// What a run of a population or chart is judged to be, and by which measures.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace verify {

// A measure of a run and the most it may be. Holds unless `value` is more than `allowed`, or no number.
struct Check {
  std::string what;
  double value = 0;
  double allowed = 0;

  [[nodiscard]] bool holds() const { return value <= allowed; }
};

// A value that is no number, or has no end, is written as null.
[[nodiscard]] nlohmann::ordered_json json_of(const Check& check);

// What the first that does not hold says; empty where all hold.
[[nodiscard]] std::string first_failure(const std::vector<Check>& checks);

enum class RunOutcome {
  right,    // went through, and every check holds
  warned,   // went through, a check fails, and something was said
  stopped,  // ended early or with a failed balance, and said why
  refused,  // was not begun, and said why
  late,     // did not come to its end in the time that it was given
  silent,   // anything else: wrong, and nothing was said
};

// The outcomes that a study knows, in the order in which it lists them, as its pages call them.
using OutcomeNames = std::vector<std::pair<RunOutcome, std::string>>;
[[nodiscard]] const std::string& name_of(RunOutcome outcome, const OutcomeNames& names);

struct JudgedRun {
  RunOutcome outcome = RunOutcome::silent;
  std::string message;            // why it stopped, was refused or is late
  std::vector<Check> checks;      // of runs that went through
  std::vector<std::string> said;  // warnings and remarks
  double cpu_s = 0;
};

// Its message, what it said and its checks, those that there are; and back from there. A value that was written as null
// comes back without end, which holds as little.
void add_reasons(const JudgedRun& run, nlohmann::ordered_json& json);
void read_reasons(const nlohmann::ordered_json& json, JudgedRun& run);

// "   12 right" as a line.
[[nodiscard]] std::string count_line(std::size_t count, const std::string& name);

template <typename Runs>
[[nodiscard]] std::size_t count_of(const Runs& runs, RunOutcome outcome) {
  std::size_t count = 0;
  for (const JudgedRun& run : runs) count += run.outcome == outcome ? 1 : 0;
  return count;
}

// A line for each outcome.
template <typename Runs>
[[nodiscard]] std::string counts_of(const Runs& runs, const OutcomeNames& names) {
  std::string text;
  for (const auto& [outcome, name] : names) text += count_line(count_of(runs, outcome), name);
  return text;
}

}  // namespace verify
