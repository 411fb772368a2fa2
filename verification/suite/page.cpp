#include "verification/suite/page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "verification/suite/catalogue.h"

namespace verify {
namespace {

constexpr auto case_mark = "### `";
constexpr auto section_mark = "## ";

constexpr auto head = R"(# Verification

What the engine is held to, and how well it does. This page is made from what the cases measured; do not edit it:

```
build/release/bin/dda-verify run --out results/verification
build/release/bin/dda-verify table results/verification --out docs/verification.md
```

A test fails when the page no longer says what the cases measure. `dda-verify run --case ID --out DIR` runs one case. The
numbers are those of the verification catalogue.

The value is the engine's, the reference the exact or published answer. The error is relative to the reference unless the
quantity says otherwise, and must stay within the tolerance. An order of convergence is observed on the finest levels, with the
expected one in brackets. Letters in brackets are notes below the table: where a reference comes from, why a tolerance is
what it is. Errors below 1e-8 are shown as bounds, because round-off is not the same on every processor.
)";

std::set<int> covered(const std::vector<Case>& cases) {
  std::set<int> numbers;
  for (const Case& each : cases) numbers.insert(each.catalogue.begin(), each.catalogue.end());
  return numbers;
}

std::string case_text(const Case& given, const Tables& tables) {
  std::string text = fmt::format("{}{}`: {}{}\n\n", case_mark, given.id, given.title,
                                 given.label == CaseLabel::slow ? " (label slow)" : "");
  const auto table = tables.find(given.id);
  if (table == tables.end()) return text;
  for (const std::string& line : table->second) text += line + "\n";
  return text + "\n";
}

// How well an area does: its cases and quantities, and where an error comes nearest to its tolerance.
struct AreaFigures {
  int cases = 0;
  int quantities = 0;
  Margin nearest{"", 0};
  std::string nearest_case;
};

AreaFigures figures_of(const Area& area, const std::vector<Case>& cases, const Tables& tables) {
  AreaFigures figures;
  for (const Case& each : cases) {
    const auto table = tables.find(each.id);
    if (each.catalogue.empty() || each.catalogue.front() < area.first || each.catalogue.front() > area.last) continue;
    ++figures.cases;
    if (table == tables.end()) continue;
    for (const Margin& margin : margins_of(table->second)) {
      ++figures.quantities;
      if (margin.share <= figures.nearest.share) continue;
      figures.nearest = margin;
      figures.nearest_case = each.id;
    }
  }
  return figures;
}

// A row for each area that has cases.
std::string summary_text(const std::vector<Case>& cases, const Tables& tables) {
  std::string text = "| area | problems | cases | quantities | nearest to its tolerance |\n|---|---|---:|---:|---|\n";
  for (const Area& area : areas()) {
    const AreaFigures figures = figures_of(area, cases, tables);
    if (figures.cases == 0) continue;
    const std::string nearest = figures.nearest.share > 0
                                    ? fmt::format("{:.0f} % of it: `{}`, {}", 100 * figures.nearest.share,
                                                  figures.nearest_case, figures.nearest.quantity)
                                    : "all round-off or exact";
    text += fmt::format("| {} | {} to {} | {} | {} | {} |\n", area.title, area.first, area.last, figures.cases,
                        figures.quantities, nearest);
  }
  return text;
}

// A case stands under its first number; its other numbers point there.
std::string section_text(const CatalogueProblem& problem, const std::vector<Case>& cases, const Tables& tables) {
  std::string text;
  for (const Case& each : cases) {
    const auto& numbers = each.catalogue;
    if (numbers.empty() || std::find(numbers.begin(), numbers.end(), problem.number) == numbers.end()) continue;
    text += numbers.front() == problem.number ? case_text(each, tables)
                                              : fmt::format("See `{}` under number {}.\n\n", each.id, numbers.front());
  }
  return text.empty() ? "" : fmt::format("{}{}. {}\n\n{}", section_mark, problem.number, problem.title, text);
}

std::string coverage_text(std::size_t covered, std::size_t cases) {
  const std::size_t problems = catalogue().size();
  if (covered == problems) return fmt::format("All {} problems are covered, by {} cases.", problems, cases);
  return fmt::format("{} of the {} problems are covered, by {} cases; the others are listed at the end.", covered,
                     problems, cases);
}

std::string uncovered_text(const std::set<int>& numbers) {
  std::string text;
  for (const CatalogueProblem& problem : catalogue())
    if (!numbers.contains(problem.number)) text += fmt::format("- {} {}\n", problem.number, problem.title);
  return text.empty() ? "" : fmt::format("{}Not yet covered\n\n{}", section_mark, text);
}

Lines lines_of(const std::string& text) {
  Lines lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// The id in a line that begins a case, else empty.
std::string id_in(const std::string& line) {
  if (!line.starts_with(case_mark)) return "";
  const std::size_t start = std::string(case_mark).size();
  return line.substr(start, line.find('`', start) - start);
}

void trim(Lines& lines) {
  while (!lines.empty() && lines.front().empty()) lines.erase(lines.begin());
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
}

// The page's lines without tables and empty lines.
Lines frame_of(const std::string& page) {
  Lines frame;
  bool in_case = false;
  for (const std::string& line : lines_of(page)) {
    if (line.starts_with(section_mark)) in_case = false;
    if (!id_in(line).empty()) {
      in_case = true;
      frame.push_back(line);
    } else if (!line.empty() && (!in_case || line.starts_with("See `"))) {
      frame.push_back(line);
    }
  }
  return frame;
}

std::string first_difference(const Lines& printed, const Lines& expected) {
  const auto [was, is] = std::mismatch(printed.begin(), printed.end(), expected.begin(), expected.end());
  if (was == printed.end() && is == expected.end()) return "";
  return fmt::format("\"{}\" is printed, it should be \"{}\"", was == printed.end() ? "nothing more" : *was,
                     is == expected.end() ? "nothing more" : *is);
}

}  // namespace

std::string page_of(const std::vector<Case>& cases, const Tables& tables) {
  const std::set<int> numbers = covered(cases);
  std::string text = head;
  text += fmt::format("\n{}\n\n{}\n", coverage_text(numbers.size(), cases.size()), summary_text(cases, tables));
  for (const CatalogueProblem& problem : catalogue()) text += section_text(problem, cases, tables);
  return text + uncovered_text(numbers);
}

Tables tables_of(const std::string& page) {
  Tables tables;
  Lines* current = nullptr;
  for (const std::string& line : lines_of(page)) {
    const std::string id = id_in(line);
    if (!id.empty())
      current = &tables[id];
    else if (line.starts_with(section_mark) || line.starts_with("See `"))
      current = nullptr;
    else if (current != nullptr)
      current->push_back(line);
  }
  for (auto& [id, lines] : tables) trim(lines);
  return tables;
}

std::vector<std::string> differences(const std::string& page, const std::vector<Case>& cases, const Tables& measured) {
  std::vector<std::string> found;
  const Tables printed = tables_of(page);
  const std::string frame = first_difference(frame_of(page), frame_of(page_of(cases, printed)));
  if (!frame.empty()) found.push_back(frame);
  for (const Case& each : cases) {
    const auto was = printed.find(each.id);
    const auto is = measured.find(each.id);
    if (was == printed.end() || was->second.empty()) {
      found.push_back(fmt::format("{}: no table", each.id));
    } else if (is != measured.end()) {
      for (const std::string& difference : differences(was->second, is->second))
        found.push_back(fmt::format("{}: {}", each.id, difference));
    }
  }
  return found;
}

}  // namespace verify
