// `dda report`: what came of a run, on one page that needs nothing but a browser.
#pragma once

#include <filesystem>
#include <iosfwd>

namespace dda {

struct ReportOptions {
  std::filesystem::path folder;
  std::filesystem::path file;  // empty: report.html in the folder
};

// Says on `out` what was written. InputError for a folder without a run that has ended, or a file that cannot be
// written.
void report_run(const ReportOptions& options, std::ostream& out);

}  // namespace dda
