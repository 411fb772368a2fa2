#include "verification/suite/table_command.h"

#include <fmt/format.h>

#include <map>
#include <ostream>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/record/atomic_file.h"
#include "verification/suite/page.h"
#include "verification/suite/run_command.h"

namespace verify {
namespace {

using RowsById = std::map<std::string, std::vector<Row>>;

void add_file(const std::filesystem::path& file, RowsById& rows) {
  for (Row& row : rows_from_json(dda::read_file(file), file.string())) rows[row.id].push_back(std::move(row));
}

// The rows of the chosen cases that the folder has.
RowsById rows_in(const std::filesystem::path& folder, const std::vector<Case>& chosen) {
  RowsById found;
  const bool together = std::filesystem::exists(folder / verification_file);
  if (together) add_file(folder / verification_file, found);
  RowsById rows;
  for (const Case& each : chosen) {
    const std::filesystem::path file = folder / each.id / verification_file;
    if (!together && std::filesystem::exists(file)) add_file(file, found);
    if (found.contains(each.id)) rows[each.id] = found[each.id];
  }
  if (rows.empty() && !chosen.empty())
    throw dda::InputError("", "the folder of results", "\"" + folder.string() + "\"",
                          "one that `dda-verify run --out` has written");
  return rows;
}

bool all_passed(const RowsById& rows, std::ostream& errors) {
  bool passed = true;
  for (const auto& [id, of_case] : rows) {
    for (const Row& row : of_case) {
      if (!row.passed) errors << "dda-verify: failed: " << describe(row) << "\n";
      passed = passed && row.passed;
    }
  }
  return passed;
}

Tables tables_from(const RowsById& rows) {
  Tables tables;
  for (const auto& [id, of_case] : rows) tables[id] = page_table(of_case);
  return tables;
}

std::string text_of(const std::filesystem::path& page) {
  return std::filesystem::exists(page) ? dda::read_file(page) : "";
}

int check_page(const std::vector<Case>& cases, const TableCommand& command, const Tables& measured,
               std::ostream& errors) {
  std::vector<std::string> found = differences(text_of(command.page), cases, measured);
  for (const Case& each : select(cases, command.selection))
    if (!measured.contains(each.id)) found.push_back(fmt::format("{}: not in {}", each.id, command.results.string()));
  for (const std::string& difference : found)
    errors << "dda-verify: " << command.page.string() << " is stale: " << difference << "\n";
  if (found.empty()) return 0;
  errors << "To make it again (`--case ID`, repeated, runs only what has changed):\n"
         << "  build/release/bin/dda-verify run --out results/verification\n"
         << "  build/release/bin/dda-verify table results/verification --out docs/verification.md\n";
  return 1;
}

void write_page(const std::vector<Case>& cases, const TableCommand& command, const Tables& measured) {
  Tables tables = measured;
  tables.merge(tables_of(text_of(command.page)));
  for (const Case& each : cases)
    if (!tables.contains(each.id))
      throw dda::InputError("", "the table of case \"" + each.id + "\"", "neither in the results nor in the page",
                            "a result, by `dda-verify run --case " + each.id + " --out DIR`");
  dda::write_file(command.page, page_of(cases, tables));
}

struct TableArguments {
  TableCommand command;
  std::filesystem::path checked;
};

}  // namespace

int make_table(const std::vector<Case>& cases, const TableCommand& command, std::ostream& out, std::ostream& errors) {
  const RowsById rows = rows_in(command.results, select(cases, command.selection));
  if (!all_passed(rows, errors)) return 1;
  const Tables measured = tables_from(rows);
  if (command.check) return check_page(cases, command, measured, errors);
  write_page(cases, command, measured);
  out << fmt::format("{} of {} tables made anew; {}\n", measured.size(), cases.size(), command.page.string());
  return 0;
}

StudyCommand table_command(const ListCases& all_cases) {
  return study_command<TableArguments>(
      "table",
      "Makes docs/verification.md from what `run` has written. Cases without results keep the table that the page "
      "has.\nExit code 1 if an assertion failed, or with --check if the page is stale.",
      [](TableArguments& a) {
        std::vector<CommandOption> options{{.name = "results",
                                            .target = &a.command.results,
                                            .help = "folder with verification.json, or with one for each case",
                                            .required = true,
                                            .kind = "DIR"}};
        add_selection(a.command.selection, options);
        options.push_back({"--check", &a.checked, "page to compare; nothing is written"});
        options.push_back(
            {.name = "--out", .target = &a.command.page, .help = "page to write", .instead_of = "--check"});
        return options;
      },
      [all_cases](const TableArguments& a, const Surroundings& s) {
        TableCommand command = a.command;
        command.check = !a.checked.empty();
        if (command.check) command.page = a.checked;
        return make_table(all_cases(), command, s.out, s.errors);
      });
}

}  // namespace verify
