#include "verification/sweep/sweep_command.h"

#include <fmt/format.h>

#include <exception>
#include <ostream>

#include "engine/core/error.h"
#include "engine/core/parallel.h"
#include "engine/record/atomic_file.h"
#include "engine/record/progress.h"
#include "verification/study/gnuplot.h"
#include "verification/study/job_progress.h"
#include "verification/study/process_pool.h"
#include "verification/sweep/job.h"
#include "verification/sweep/job_list.h"
#include "verification/sweep/plots.h"
#include "verification/sweep/sweep_folder.h"
#include "verification/sweep/table.h"

namespace verify {
namespace {

using Json = nlohmann::ordered_json;

JobFile outcome_of(const JobParameters& parameters, bool closed_form) {
  const Json described = to_json(parameters);
  try {
    return {"ok", "", described, to_json(run_job(parameters, closed_form))};
  } catch (const NotMeasurable& reason) {
    return {"not_measurable", reason.what(), described, Json::object()};
  } catch (const std::exception& reason) {
    return {"failed", reason.what(), described, Json::object()};
  }
}

std::string described(std::size_t index, const JobFile& job) {
  return fmt::format("job {} {}{}{}", index, job.status == "missing" ? "is missing" : job.status,
                     job.message.empty() ? "" : ": ", job.message);
}

void run_jobs(const SweepCommand& command, const std::filesystem::path& program, const SweepSpec& spec,
              const SweepFolder& folder, const std::vector<std::size_t>& open) {
  std::vector<PoolTask> tasks;
  for (const std::size_t index : open) tasks.push_back({index, job_command(program, folder, index)});
  JobProgress progress(open.size(), dda::terminal());
  run_processes(tasks, command.jobs > 0 ? command.jobs : dda::cores(),
                [&](std::size_t index, const std::string& failure) {
                  if (!folder.read(index, spec.jobs[index]).ended_by_itself())
                    folder.write(index, {"crashed", failure.empty() ? "ended without a result" : "ended by " + failure,
                                         to_json(spec.jobs[index]), Json::object()});
                  progress.job_ended(folder.read(index, spec.jobs[index]).failed());
                });
}

}  // namespace

int sweep(const SweepCommand& command, const std::filesystem::path& program, std::ostream& out, std::ostream& errors) {
  const std::string text = spec_text(command.spec);
  const SweepSpec spec = parse_spec(text, command.spec.string());
  const SweepFolder folder(command.folder);
  if (!command.resume && folder.has_jobs())
    throw dda::InputError("", "--out", "\"" + command.folder.string() + "\", which has jobs of an earlier sweep",
                          "another folder, or --resume to keep the jobs that are done");
  folder.prepare(text);
  const std::vector<std::size_t> open = folder.open_jobs(spec);
  if (command.job_list) {
    write_job_list(program, folder, open);
    out << fmt::format("{} jobs in {} and {}\n", open.size(), (command.folder / job_list_name).string(),
                       (command.folder / slurm_name).string());
    return 0;
  }
  run_jobs(command, program, spec, folder, open);
  return collect(command.folder, out, errors);
}

int job(const JobCommand& command, std::ostream& out) {
  const SweepSpec spec = read_spec(command.spec);
  if (command.index >= spec.jobs.size())
    throw dda::InputError("", "INDEX", std::to_string(command.index),
                          fmt::format("a job of the sweep, 0 to {}", spec.jobs.size() - 1));
  const SweepFolder folder(command.folder);
  std::filesystem::create_directories(folder.job_file(command.index).parent_path());
  const JobFile outcome = outcome_of(spec.jobs[command.index], spec.closed_form);
  folder.write(command.index, outcome);
  out << described(command.index, outcome) << "\n";
  return outcome.failed() ? 1 : 0;
}

int collect(const std::filesystem::path& path, std::ostream& out, std::ostream& errors) {
  const SweepFolder folder(path);
  const SweepSpec spec = read_spec(folder.spec_file());
  const std::vector<JobFile> jobs = read_jobs(folder, spec);
  dda::write_file(path / "results.csv", to_csv(spec, jobs));
  out << summary_of(jobs);
  bool complete = true;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (!jobs[i].failed()) continue;
    complete = false;
    errors << "dda-verify: " << described(i, jobs[i]) << "\n";
  }
  if (spec.plots.empty()) return complete ? 0 : 1;
  if (!gnuplot_is_installed()) {
    errors << "dda-verify: gnuplot is not installed, so there are no plots\n";
    return 1;
  }
  plot_sweep(spec, jobs, path / "plots");
  return complete ? 0 : 1;
}

}  // namespace verify
