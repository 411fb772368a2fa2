#include "verification/chapters/thesis_command.h"

#include <fmt/format.h>

#include <ostream>
#include <vector>

#include "engine/core/parallel.h"
#include "verification/chapters/chapter_3.h"
#include "verification/chapters/chapter_4.h"
#include "verification/chapters/chapter_5.h"
#include "verification/chapters/chapter_6.h"
#include "verification/chapters/jinping.h"
#include "verification/chapters/run_figures.h"
#include "verification/chapters/thesis_file.h"

namespace verify {
namespace {

Chapter judged_5(const SceneFolder& folder, bool quick) {
  Chapter chapter = chapter_5();
  if (quick) return chapter;
  const std::vector<JinpingReading> readings = jinping_readings();
  judge_jinping(run_jinping(folder, readings, chapter.failures), chapter);
  draw_jinping(folder, {readings[0], readings[1]}, chapter);  // accurate, and with the thesis' scheme
  return chapter;
}

Chapter judged(int number, const ThesisCommand& command, const std::filesystem::path& program, std::ostream& out) {
  if (number == 3) return chapter_3(chapter_3_rows());
  if (number == 4) return chapter_4(chapter_4_study(command.folder));
  const SceneFolder folder(command.folder, program, command.jobs > 0 ? command.jobs : dda::cores(), out);
  if (number == 6) return chapter_6(folder, command.quick);
  return judged_5(folder, command.quick);
}

const char* verdict(const Statement& statement) {
  if (!statement.confirmed) return "not judged   ";
  return *statement.confirmed ? "confirmed    " : "NOT confirmed";
}

void tell(const Chapter& chapter, std::ostream& out, std::ostream& errors) {
  for (const Statement& s : chapter.statements) out << fmt::format("{}  {}: {}\n", verdict(s), s.id, s.statement);
  for (const std::string& failure : chapter.failures) errors << "dda-verify: " << failure << "\n";
}

}  // namespace

int judge_thesis(const ThesisCommand& command, const std::filesystem::path& program, std::ostream& out,
                 std::ostream& errors) {
  bool well = true;
  const std::vector<int> chapters = command.chapters.empty() ? std::vector<int>{3, 4, 5, 6} : command.chapters;
  for (const int number : chapters) {
    out << fmt::format("chapter {}\n", number) << std::flush;
    const Chapter chapter = judged(number, command, program, out);
    write_chapter(command.folder, chapter);
    tell(chapter, out, errors);
    well = well && chapter.failures.empty();
  }
  return well ? 0 : 1;
}

StudyCommand thesis_command() {
  return study_command<ThesisCommand>(
      "thesis",
      "What Zelig (2015) says in chapters 3 to 6, statement by statement, and what this engine says to it, in all "
      "readings of what the text leaves open.\nWrites thesis.json and chapter_N.md, for chapters 5 and 6 also scenes/ "
      "and runs/; runs that are done there are kept. Exit code 1 if a run failed.",
      [](ThesisCommand& a) -> std::vector<CommandOption> {
        return {{.name = "--chapter",
                 .target = &a.chapters,
                 .help = "3, 4, 5 or 6; may be given several times; default: all",
                 .range = {{3, 6}}},
                out_folder(a.folder),
                jobs_at_once(a.jobs, "runs at once; default: as many as there are cores"),
                {"--quick", &a.quick,
                 "small readings of section 6.1, in seconds, and no runs of chapter 5 and section 6.2"}};
      },
      [](const ThesisCommand& a, const Surroundings& s) {
        return judge_thesis(a, std::filesystem::path(s.program).replace_filename("dda"), s.out, s.errors);
      });
}

}  // namespace verify
