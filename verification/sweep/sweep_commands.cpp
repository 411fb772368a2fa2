// What `dda-verify sweep`, `job` and `collect` say of themselves on the command line.
#include "verification/sweep/sweep_command.h"

namespace verify {
namespace {

StudyCommand sweep_itself() {
  return study_command<SweepCommand>(
      "sweep",
      "Runs a grid of parameters over the thesis' bar, each job a process of its own: results.csv and plots/ of "
      "measured and predicted errors.\nExit code 1 if a job failed; each is told on standard error.",
      [](SweepCommand& a) -> std::vector<CommandOption> {
        return {
            {.name = "spec",
             .target = &a.spec,
             .help = "JSON file of the grid; verification/sweep/README.md",
             .required = true,
             .kind = "SPEC"},
            out_folder(a.folder),
            jobs_at_once(a.jobs, "jobs at once; default: as many as there are cores"),
            {"--resume", &a.resume, "go on in a folder that has jobs, and keep those that are done"},
            {"--job-list", &a.job_list, "run nothing: write jobs.txt, a command a line, and slurm.sh, a job array"}};
      },
      [](const SweepCommand& a, const Surroundings& s) { return sweep(a, s.program, s.out, s.errors); });
}

StudyCommand one_job() {
  return study_command<JobCommand>(
      "job", "Runs one job of a sweep and writes DIR/jobs/INDEX.json.\nExit code 1 if it failed; the file says why.",
      [](JobCommand& a) -> std::vector<CommandOption> {
        return {{.name = "spec", .target = &a.spec, .help = "JSON file of the sweep", .required = true, .kind = "SPEC"},
                {.name = "index", .target = &a.index, .help = "which job, from 0", .required = true, .kind = "INDEX"},
                {.name = "--out", .target = &a.folder, .help = "folder of the sweep", .required = true, .kind = "DIR"}};
      },
      [](const JobCommand& a, const Surroundings& s) { return job(a, s.out); });
}

StudyCommand collecting() {
  return study_command<std::filesystem::path>(
      "collect", "Makes results.csv and plots/ from the jobs of a sweep that are done.\nExit code 1 if some are not.",
      [](std::filesystem::path& folder) -> std::vector<CommandOption> {
        return {{.name = "folder", .target = &folder, .help = "folder of the sweep", .required = true, .kind = "DIR"}};
      },
      [](const std::filesystem::path& folder, const Surroundings& s) { return collect(folder, s.out, s.errors); });
}

}  // namespace

std::vector<StudyCommand> sweep_commands() { return {sweep_itself(), one_job(), collecting()}; }

}  // namespace verify
