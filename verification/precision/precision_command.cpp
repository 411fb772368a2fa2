#include "verification/precision/precision_command.h"

#include <fmt/format.h>

#include <ostream>

#include "engine/record/atomic_file.h"
#include "engine/record/progress.h"
#include "verification/precision/grid.h"
#include "verification/precision/other_systems.h"
#include "verification/precision/plots.h"
#include "verification/precision/study.h"
#include "verification/precision/summary.h"
#include "verification/precision/table.h"
#include "verification/study/gnuplot.h"

namespace verify {

int work_precision(const PrecisionCommand& command, std::ostream& out, std::ostream& errors) {
  const StudyOptions options{command.rounds, command.resume, dda::terminal()};
  std::vector<Measured> all = run_study(study_jobs(), command.folder, options);
  const std::vector<Measured> others = read_other_systems(command.folder / other_systems_file);
  all.insert(all.end(), others.begin(), others.end());
  dda::write_file(command.folder / "work_precision.csv", to_csv(all));
  const std::string summary = summary_of(all);
  dda::write_file(command.folder / "work_precision.md", summary);
  out << summary;
  int code = 0;
  for (const Measured& measured : all) {
    if (measured.failure.empty()) continue;
    errors << fmt::format("dda-verify: {}: {}\n", measured.job.key(), measured.failure);
    code = 1;
  }
  if (!gnuplot_is_installed()) {
    errors << "dda-verify: gnuplot is not installed, so there are no plots\n";
    return 1;
  }
  plot_study(all, command.folder / "plots");
  return code;
}

StudyCommand precision_command() {
  return study_command<PrecisionCommand>(
      "work-precision",
      "Error against CPU time: every interface law and integrator over block size and time step, for the thesis' bar "
      "and a pulse in a plate, beside plain explicit finite elements.\nWrites work_precision.csv, work_precision.md "
      "and plots/. Exit code 1 if a run failed.",
      [](PrecisionCommand& a) -> std::vector<CommandOption> {
        return {out_folder(a.folder),
                {.name = "--rounds",
                 .target = &a.rounds,
                 .help = "runs of every job, of which the least CPU time counts",
                 .shows_default = true,
                 .positive = true},
                {"--resume", &a.resume, "go on in a folder that has runs, and keep them"}};
      },
      [](const PrecisionCommand& a, const Surroundings& s) { return work_precision(a, s.out, s.errors); });
}

}  // namespace verify
