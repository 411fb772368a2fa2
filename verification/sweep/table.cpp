#include "verification/sweep/table.h"

#include <fmt/format.h>

#include <algorithm>

#include "verification/sweep/job.h"

namespace verify {
namespace {

using Json = nlohmann::ordered_json;

std::string quoted(const std::string& text) {
  if (text.find_first_of("\",\n\r") == std::string::npos) return text;
  std::string result(1, '"');
  for (const char c : text) {
    result += c == '\n' ? ' ' : c;
    if (c == '"') result += c;
  }
  result += '"';
  return result;
}

std::string cell(const Json& value) {
  if (value.is_null()) return "";
  return quoted(value.is_string() ? value.get<std::string>() : value.dump());
}

std::string agreeing(const std::vector<JobFile>& jobs, const std::string& name) {
  const auto measured = std::count_if(jobs.begin(), jobs.end(), [](const JobFile& job) { return job.status == "ok"; });
  const auto agreed = std::count_if(jobs.begin(), jobs.end(), [&](const JobFile& job) {
    return job.status == "ok" && job.result.value(name + "_agrees", false);
  });
  return fmt::format("{} error predicted within 20 % or 0.05 percentage points in {} of {} jobs\n", name, agreed,
                     measured);
}

}  // namespace

std::vector<JobFile> read_jobs(const SweepFolder& folder, const SweepSpec& spec) {
  std::vector<JobFile> jobs;
  for (std::size_t i = 0; i < spec.jobs.size(); ++i) jobs.push_back(folder.read(i, spec.jobs[i]));
  return jobs;
}

std::string to_csv(const SweepSpec& spec, const std::vector<JobFile>& jobs) {
  const Json results = to_json(JobResult{});
  const Json parameters = to_json(JobParameters{});
  std::string text = "index,status,message";
  for (const auto& [name, value] : parameters.items()) text += fmt::format(",{}", name);
  for (const auto& [name, value] : results.items()) text += fmt::format(",{}", name);
  text += "\n";
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    text += fmt::format("{},{},{}", i, jobs[i].status, quoted(jobs[i].message));
    const Json given = to_json(spec.jobs[i]);
    for (const auto& [name, value] : given.items()) text += fmt::format(",{}", cell(value));
    for (const auto& [name, value] : results.items())
      text += fmt::format(",{}", cell(jobs[i].result.value(name, Json())));
    text += "\n";
  }
  return text;
}

std::string summary_of(const std::vector<JobFile>& jobs) {
  std::string text = fmt::format("{} jobs:", jobs.size());
  for (const char* status : {"ok", "not_measurable", "failed", "crashed", "missing"}) {
    const auto count =
        std::count_if(jobs.begin(), jobs.end(), [&](const JobFile& job) { return job.status == status; });
    if (count > 0) text += fmt::format(" {} {}", count, status);
  }
  return text + "\n" + agreeing(jobs, "velocity") + agreeing(jobs, "amplitude");
}

}  // namespace verify
