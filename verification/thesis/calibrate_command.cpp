#include "verification/thesis/calibrate_command.h"

#include <fmt/format.h>

#include <iostream>

#include "engine/record/atomic_file.h"
#include "engine/record/progress.h"
#include "verification/harness/recorded_run.h"
#include "verification/study/gnuplot.h"
#include "verification/study/html.h"
#include "verification/study/markdown.h"
#include "verification/thesis/calibration_json.h"
#include "verification/thesis/plots.h"
#include "verification/thesis/promises.h"
#include "verification/thesis/report.h"

namespace verify {
namespace {

// True if all promises are kept; says on standard error which rows break them.
bool all_kept(const std::vector<Promise>& promises) {
  bool kept = true;
  for (const Promise& promise : promises) {
    for (const std::string& failure : promise.failures) std::cerr << "dda-verify: " << failure << "\n";
    kept = kept && promise.kept();
  }
  return kept;
}

void say_what_came_out(const std::vector<Promise>& promises) {
  for (const Promise& promise : promises)
    fmt::print("{}  {}: {}\n", promise.kept() ? "kept  " : "BROKEN", promise.claim, promise.measured);
}

}  // namespace

int calibrate(const CalibrateCommand& command) {
  std::filesystem::create_directories(command.folder);
  const double start = cpu_seconds();
  const Calibration calibration = run_calibration({command.quick, CalibrationOptions().repetitions, dda::terminal()});
  const std::vector<Promise> promises = judge(calibration);
  const bool figures = gnuplot_is_installed();
  ReportFacts facts;
  facts.figures = figures;
  facts.total_cpu_s = cpu_seconds() - start;
  facts.command_line = command.quick ? "dda-verify calibrate --quick" : "dda-verify calibrate";
  const Document report = calibration_report(calibration, promises, facts);

  dda::write_file(command.folder / "calibration.json", to_json(calibration, promises));
  dda::write_file(command.folder / "calibration.md", to_markdown(report));
  if (figures) {
    plot_calibration(calibration, command.folder / plots_folder);
    dda::write_file(command.folder / "calibration.html", to_html(report, command.folder));
  } else {
    std::cerr << "dda-verify: gnuplot is not installed, so there are no plots and no calibration.html\n";
  }
  say_what_came_out(promises);
  return all_kept(promises) && figures ? 0 : 1;
}

StudyCommand calibrate_command() {
  return study_command<CalibrateCommand>(
      "calibrate",
      "The P wave of Zelig (2015), chapter 3: Tables 3.2 and 3.3 from this engine, beside the printed numbers, its "
      "accurate scheme and the closed form of the discrete problem.\nWrites calibration.json, calibration.md, "
      "calibration.html and plots/. Exit code 1 if a promised accuracy is not met.",
      [](CalibrateCommand& a) -> std::vector<CommandOption> {
        return {out_folder(a.folder, "folder of the report; made if it is not there"),
                {"--quick", &a.quick, "the time step of 0.1 ms only, each run once"}};
      },
      [](const CalibrateCommand& a, const Surroundings&) { return calibrate(a); });
}

}  // namespace verify
