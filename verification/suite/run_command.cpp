#include "verification/suite/run_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <ostream>

#include "engine/record/atomic_file.h"

namespace verify {
namespace {

std::string verdict_of(const std::vector<Row>& rows) {
  const auto failed = std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.passed; });
  const std::string verdict = failed == 0 ? "ok" : fmt::format("{} of {} FAILED", failed, rows.size());
  return fmt::format("{}, {:.2f} s", verdict, rows.front().cpu_s);
}

struct RunArguments {
  RunCommand command;
  bool list = false;
};

}  // namespace

int run_cases(const std::vector<Case>& cases, const RunCommand& command, std::ostream& out, std::ostream& errors) {
  const std::vector<Case> chosen = select(cases, command.selection);
  std::filesystem::create_directories(command.folder);
  dda::AtomicFile file(command.folder / verification_file);  // first, so that nothing runs in vain
  std::vector<Row> rows;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    out << fmt::format("[{:>3}/{}] {:<40} ", i + 1, chosen.size(), chosen[i].id) << std::flush;
    const std::vector<Row> of_case = run_case(chosen[i]);
    out << verdict_of(of_case) << "\n";
    rows.insert(rows.end(), of_case.begin(), of_case.end());
  }
  file.write(to_json(rows));
  file.commit();

  std::size_t failed = 0;
  for (const Row& row : rows) {
    if (row.passed) continue;
    ++failed;
    errors << "dda-verify: failed: " << describe(row) << "\n";
  }
  out << fmt::format("{} cases, {} assertions, {} failed; {}\n", chosen.size(), rows.size(), failed,
                     file.path().string());
  return failed == 0 ? 0 : 1;
}

void list_cases(const std::vector<Case>& cases, std::ostream& out) {
  for (const Case& each : cases)
    out << fmt::format("{:<8} {}  {:<40} {}\n", fmt::format("{}", fmt::join(each.catalogue, ",")), name_of(each.label),
                       each.id, each.title);
}

void add_selection(Selection& selection, std::vector<CommandOption>& options) {
  options.push_back({.name = "--case",
                     .target = &selection.ids,
                     .help = "only the case of this id; may be given several times",
                     .kind = "ID"});
  options.push_back({.name = "--label",
                     .target = &selection.labels,
                     .help = "only cases of this label, fast or slow",
                     .kind = "LABEL"});
}

StudyCommand run_command(const ListCases& all_cases) {
  return study_command<RunArguments>(
      "run",
      "Runs the cases of the verification catalogue, all of them or those asked for, and writes verification.json: "
      "one entry per asserted quantity with its reference, error and tolerance.\nExit code 1 if an assertion fails; "
      "each is told on standard error.",
      [](RunArguments& a) {
        std::vector<CommandOption> options;
        add_selection(a.command.selection, options);
        options.push_back({"--out", &a.command.folder, "folder for verification.json; made if it is not there"});
        options.push_back({.name = "--list",
                           .target = &a.list,
                           .help = "list catalogue numbers, label, id and title of the cases",
                           .instead_of = "--out"});
        return options;
      },
      [all_cases](const RunArguments& a, const Surroundings& s) {
        if (!a.list) return run_cases(all_cases(), a.command, s.out, s.errors);
        list_cases(select(all_cases(), a.command.selection), s.out);
        return 0;
      });
}

}  // namespace verify
