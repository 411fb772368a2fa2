#include "engine/app/report_command.h"

#include <fmt/format.h>

#include <ostream>

#include "engine/app/output_file.h"
#include "engine/app/report_page.h"
#include "engine/app/view_command.h"
#include "engine/core/error.h"
#include "engine/record/atomic_file.h"
#include "engine/record/run_folder.h"

namespace dda {

void report_run(const ReportOptions& options, std::ostream& out) {
  const std::filesystem::path file = options.file.empty() ? options.folder / report_name : options.file;
  if (file.extension() != ".html" && file.extension() != ".htm")
    throw InputError("", "--out", file.string(), "a name that ends in .html or .htm, which is what is written");
  expect_folder(options.folder);
  expect_output(file, options.folder);
  const std::string page = report_page(options.folder);
  write_file(file, page);
  out << fmt::format("{}: {:.2g} MB\n", file.string(), static_cast<double>(page.size()) / 1e6);
}

}  // namespace dda
