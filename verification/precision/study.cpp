#include "verification/precision/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <fstream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "verification/precision/run_job.h"
#include "verification/study/job_progress.h"

namespace verify {
namespace {

using Json = nlohmann::ordered_json;

constexpr double long_run = 0.5;  // s: one is enough
constexpr double nothing_read = std::numeric_limits<double>::quiet_NaN();

void take(Measured& measured, const PrecisionResult& result) {
  const double least = measured.runs == 0 ? result.cpu_s : std::min(measured.result.cpu_s, result.cpu_s);
  measured.result = result;
  measured.result.cpu_s = least;
  ++measured.runs;
}

Json line_of(const Measured& run) {
  return {{"job", run.job.key()},
          {"error", run.result.error},
          {"reading", run.result.reading},
          {"cells", run.result.cells},
          {"steps", run.result.steps},
          {"solves", run.result.solves},
          {"iterations", run.result.iterations},
          {"cpu_s", run.result.cpu_s},
          {"failure", run.failure}};
}

void read_line(const std::string& line, std::map<std::string, Measured*>& by_key) {
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object() || !json.contains("failure")) return;
  const auto found = by_key.find(json.at("job").get<std::string>());
  if (found == by_key.end()) return;
  found->second->failure = json.at("failure");
  if (json.at("error").is_null()) ++found->second->runs;  // not finite, or no result
  const Json& reading = json.at("reading");
  if (json.at("error").is_number())
    take(*found->second,
         {json.at("error"), reading.is_number() ? reading.get<double>() : nothing_read, json.at("cells"),
          json.at("steps"), json.at("solves"), json.at("iterations"), json.at("cpu_s")});
}

void read_runs(const std::filesystem::path& file, std::vector<Measured>& all) {
  std::map<std::string, Measured*> by_key;
  for (Measured& measured : all) by_key[measured.job.key()] = &measured;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) read_line(line, by_key);
}

Measured run_once(const PrecisionJob& job) {
  try {
    const PrecisionResult result = run_job(job);
    return {job, result, 1, ""};
  } catch (const std::exception& reason) {
    PrecisionResult nothing;
    nothing.error = nothing_read;
    return {job, nothing, 1, reason.what()};
  }
}

bool has_runs(const std::filesystem::path& file) {
  return std::filesystem::exists(file) && !std::filesystem::is_empty(file);
}

// At most: long runs are not repeated.
std::size_t runs_left(const std::vector<Measured>& all, int rounds) {
  std::size_t left = 0;
  for (const Measured& measured : all) left += static_cast<std::size_t>(std::max(0, rounds - measured.runs));
  return left;
}

}  // namespace

std::vector<Measured> run_study(const std::vector<PrecisionJob>& jobs, const std::filesystem::path& folder,
                                const StudyOptions& options) {
  const std::filesystem::path file = folder / "runs.jsonl";
  if (!options.resume && has_runs(file))
    throw dda::InputError("", "--out", "\"" + folder.string() + "\", which has runs of an earlier study",
                          "another folder, or --resume to keep them");
  std::filesystem::create_directories(folder);
  std::vector<Measured> all;
  for (const PrecisionJob& job : jobs) all.push_back({job, {}, 0, ""});
  if (options.resume) read_runs(file, all);
  std::ofstream stream(file, std::ios::app);
  if (options.resume) stream << "\n";  // ends a line that was cut off
  JobProgress progress(runs_left(all, options.rounds), options.progress);
  for (int round = 0; round < options.rounds; ++round) {
    for (Measured& measured : all) {
      if (measured.runs > round || (measured.runs > 0 && measured.result.cpu_s > long_run)) continue;
      const Measured run = run_once(measured.job);
      measured.failure = run.failure;
      take(measured, run.result);
      stream << line_of(run).dump() << std::endl;
      progress.job_ended(!run.failure.empty());
    }
  }
  return all;
}

}  // namespace verify
