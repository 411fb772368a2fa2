#include "verification/suite/runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <exception>
#include <iterator>
#include <utility>

#include "engine/core/error.h"
#include "engine/scene/nearest_word.h"

namespace verify {
namespace {

double thread_cpu_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Outcome not_completed(std::string why) {
  Outcome outcome;
  outcome.assertions = {{"completed", "", 0, 1, std::move(why), -1, 0, "a case ends by itself and asserts something"}};
  return outcome;
}

Outcome outcome_of(const Case& given) {
  try {
    Outcome outcome = given.run();
    return outcome.assertions.empty() ? not_completed("asserted nothing") : outcome;
  } catch (const std::exception& error) {
    return not_completed(error.what());
  } catch (...) {
    return not_completed("threw what is no std::exception");
  }
}

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

void expect_known(const char* option, const std::vector<std::string>& asked, const std::vector<std::string>& known,
                  const std::string& expected) {
  for (const std::string& word : asked) {
    if (contains(known, word)) continue;
    const std::string nearest = dda::nearest_word(word, known);
    const std::string hint = nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest);
    throw dda::InputError("", option, fmt::format("\"{}\"", word), expected + hint);
  }
}

std::vector<std::string> ids_of(const std::vector<Case>& cases) {
  std::vector<std::string> ids;
  for (const Case& each : cases) ids.push_back(each.id);
  return ids;
}

}  // namespace

std::vector<Row> run_case(const Case& given) {
  const double start = thread_cpu_seconds();
  const Outcome outcome = outcome_of(given);
  const double cpu_s = thread_cpu_seconds() - start;
  std::vector<Row> rows;
  for (const Assertion& assertion : outcome.assertions)
    rows.push_back({given.id, given.title, given.catalogue, assertion, passed(assertion), cpu_s, outcome.counters});
  return rows;
}

std::string name_of(CaseLabel label) { return label == CaseLabel::fast ? "fast" : "slow"; }

std::vector<Case> select(const std::vector<Case>& cases, const Selection& selection) {
  expect_known("--case", selection.ids, ids_of(cases), "an id that `dda-verify run --list` shows");
  expect_known("--label", selection.labels, {name_of(CaseLabel::fast), name_of(CaseLabel::slow)}, "fast or slow");
  std::vector<Case> chosen;
  std::copy_if(cases.begin(), cases.end(), std::back_inserter(chosen), [&](const Case& each) {
    return (selection.ids.empty() || contains(selection.ids, each.id)) &&
           (selection.labels.empty() || contains(selection.labels, name_of(each.label)));
  });
  if (chosen.empty() && !selection.ids.empty())
    throw dda::InputError("", "the selection", "empty", "a case that has one of the ids and labels");
  return chosen;
}

}  // namespace verify
