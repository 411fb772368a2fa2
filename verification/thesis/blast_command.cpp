#include "verification/thesis/blast_command.h"

#include "dda/record/atomic_file.h"
#include "verification/harness/markdown.h"
#include "verification/thesis/blast_report.h"

namespace verify {

void report_blast(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const ThesisBlast& blast = thesis_blast();
  dda::write_file(folder / "blast.md", to_markdown(blast_report(blast, run_blast_study(blast, {}))));
}

}  // namespace verify
