#include "verification/thesis/blast_command.h"

#include <ostream>
#include <string>

#include "engine/core/read_file.h"
#include "engine/record/atomic_file.h"
#include "engine/record/progress.h"
#include "verification/study/markdown.h"
#include "verification/study/page_check.h"
#include "verification/thesis/blast_report.h"

namespace verify {
namespace {

// Friction leaves several answers open; which one a run of dry joints ends in depends on the way of its iteration. Two
// versions of it were 3 apart in the last digits of these rows, and the same everywhere else.
constexpr int last_digits = 5;

std::string made_page() {
  const ThesisBlast& blast = thesis_blast();
  return to_markdown(blast_report(blast, run_blast_study(blast, {.progress = dda::terminal()})));
}

struct BlastArguments {
  std::filesystem::path folder, page;
};

}  // namespace

void report_blast(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  dda::write_file(folder / "blast.md", made_page());
}

int check_blast_page(const std::filesystem::path& page, std::ostream& errors) {
  const std::string printed = std::filesystem::exists(page) ? dda::read_file(page) : "";
  const auto stale = stale_lines(printed, made_page(), last_digits);
  for (const std::string& line : stale) errors << "dda-verify: " << page.string() << " is stale: " << line << "\n";
  return stale.empty() ? 0 : 1;
}

StudyCommand blast_command() {
  return study_command<BlastArguments>(
      "blast",
      "The blast of Zelig (2015), chapter 4, as far as its text defines it: Table 4.1 and peak stresses beside this "
      "engine's, with three kinds of joints and by the radial wave equation.\nWrites blast.md; some five minutes. Exit "
      "code 1 with --check if the page is stale.",
      [](BlastArguments& a) -> std::vector<CommandOption> {
        return {{"--out", &a.folder, "folder of the page; made if it is not there"},
                {.name = "--check",
                 .target = &a.page,
                 .help = "page to compare; nothing is written",
                 .instead_of = "--out"}};
      },
      [](const BlastArguments& a, const Surroundings& s) {
        if (!a.page.empty()) return check_blast_page(a.page, s.errors);
        report_blast(a.folder);
        return 0;
      });
}

}  // namespace verify
