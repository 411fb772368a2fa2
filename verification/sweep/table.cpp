#include "verification/sweep/table.h"

#include <fmt/format.h>

#include <algorithm>

#include "verification/study/values.h"
#include "verification/sweep/job.h"

namespace verify {
namespace {

using Json = nlohmann::ordered_json;

// What is told of each job before its parameters and results.
const std::vector<std::string> first_columns = {"index", "status", "message"};

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
  std::vector<std::string> header = first_columns;
  for (const Json* columns : {&parameters, &results})
    for (const auto& [name, value] : columns->items()) header.push_back(name);
  std::string text = csv_line(header);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    std::vector<std::string> cells{std::to_string(i), jobs[i].status, csv_cell(jobs[i].message)};
    const Json given = to_json(spec.jobs[i]);
    for (const auto& [name, value] : given.items()) cells.push_back(csv_cell(value));
    for (const auto& [name, value] : results.items()) cells.push_back(csv_cell(jobs[i].result.value(name, Json())));
    text += csv_line(cells);
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
