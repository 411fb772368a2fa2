#include "verification/precision/precision_command.h"

#include <fmt/format.h>

#include <ostream>

#include "engine/record/atomic_file.h"
#include "engine/record/progress.h"
#include "verification/harness/gnuplot.h"
#include "verification/precision/grid.h"
#include "verification/precision/other_systems.h"
#include "verification/precision/plots.h"
#include "verification/precision/study.h"
#include "verification/precision/summary.h"
#include "verification/precision/table.h"

namespace verify {

int work_precision(const PrecisionCommand& command, std::ostream& out, std::ostream& errors) {
  const StudyOptions options{command.rounds, command.resume, dda::terminal() != nullptr};
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

}  // namespace verify
