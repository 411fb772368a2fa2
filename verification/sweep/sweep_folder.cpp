#include "verification/sweep/sweep_folder.h"

#include <fmt/format.h>

#include "engine/core/read_file.h"
#include "engine/record/atomic_file.h"
#include "verification/sweep/job.h"

namespace verify {
namespace {

using Json = nlohmann::ordered_json;

// A truth or, of all others, a number: one that there is not is null.
bool is_of_kind(const Json& value, const Json& example) {
  return example.is_boolean() ? value.is_boolean() : value.is_number() || value.is_null();
}

// Whether it has all that a table or a plot looks for.
bool is_whole(const Json& result) {
  const Json example = to_json(JobResult{});
  for (const auto& [name, value] : example.items()) {
    const auto found = result.find(name);
    if (found == result.end() || !is_of_kind(*found, value)) return false;
  }
  return true;
}

std::optional<JobFile> parse(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  try {
    JobFile job{json.at("status"), json.at("message"), json.at("parameters"), json.at("result")};
    return job.result.is_object() && (job.status != "ok" || is_whole(job.result)) ? std::optional(job) : std::nullopt;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace

std::filesystem::path SweepFolder::job_file(std::size_t index) const {
  return path_ / "jobs" / fmt::format("{}.json", index);
}

void SweepFolder::prepare(std::string_view spec_text) const {
  std::filesystem::create_directories(path_ / "jobs");
  dda::write_file(spec_file(), spec_text);
}

bool SweepFolder::has_jobs() const {
  return std::filesystem::exists(path_ / "jobs") && !std::filesystem::is_empty(path_ / "jobs");
}

void SweepFolder::write(std::size_t index, const JobFile& job) const {
  const Json json = {{"index", index},
                     {"status", job.status},
                     {"message", job.message},
                     {"parameters", job.parameters},
                     {"result", job.result}};
  dda::write_file(job_file(index), json.dump(2) + "\n");
}

JobFile SweepFolder::read(std::size_t index, const JobParameters& parameters) const {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(job_file(index), ignored)) return {};
  const std::optional<JobFile> job = parse(dda::read_file(job_file(index)));
  return job && job->parameters == to_json(parameters) ? *job : JobFile{};
}

std::vector<std::size_t> SweepFolder::open_jobs(const SweepSpec& spec) const {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < spec.jobs.size(); ++i)
    if (!read(i, spec.jobs[i]).ended_by_itself()) open.push_back(i);
  return open;
}

}  // namespace verify
