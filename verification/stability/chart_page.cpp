#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>

#include "verification/stability/chart.h"
#include "verification/study/markdown.h"

namespace verify {
namespace {

// The beginning of a sentence without its numbers and names, so that sentences of one kind are the same.
std::string kind_of(const std::string& sentence) {
  constexpr std::size_t beginning = 40;  // letters
  std::string kind;
  bool quoted = false;
  for (const char c : sentence) {
    if (c == '"') quoted = !quoted;
    if (!quoted && std::isalpha(static_cast<unsigned char>(c)) != 0 && kind.size() < beginning) kind += c;
  }
  return kind;
}

Table counts(const std::vector<Cell>& cells, const std::string& caption) {
  Table table;
  table.caption = caption;
  table.header = {"problem"};
  for (const auto& [outcome, name] : cell_outcomes()) table.header.push_back(name);
  for (const ChartProblem problem : all_problems) {
    std::vector<std::string>& row = table.rows.emplace_back();
    row.push_back(name_of(problem));
    std::vector<Cell> of_problem;
    std::ranges::copy_if(cells, std::back_inserter(of_problem),
                         [&](const Cell& cell) { return cell.setting.problem == problem; });
    for (const auto& [outcome, name] : cell_outcomes()) row.push_back(std::to_string(count_of(of_problem, outcome)));
  }
  return table;
}

std::string reason_of(const Cell& cell) {
  if (!cell.message.empty()) return cell.message;
  if (!cell.said.empty()) return cell.said.front();
  return first_failure(cell.checks);
}

// Every kind of reason with one example and how often it was given.
Bullets reasons(const StabilityChart& chart, RunOutcome outcome) {
  std::map<std::string, std::pair<int, const Cell*>> kinds;
  for (const std::vector<Cell>* cells : {&chart.steps, &chart.blocks})
    for (const Cell& cell : *cells)
      if (cell.outcome == outcome) {
        auto& [count, example] = kinds[kind_of(reason_of(cell))];
        if (count++ == 0) example = &cell;
      }
  Bullets bullets;
  for (const auto& [kind, counted] : kinds)
    bullets.items.push_back(fmt::format("{} cells, as {}: {}", counted.first, words_for(counted.second->setting),
                                        reason_of(*counted.second)));
  return bullets;
}

void add_reasons(const StabilityChart& chart, RunOutcome outcome, Document& document) {
  Bullets bullets = reasons(chart, outcome);
  if (bullets.items.empty()) return;
  document.sections.push_back({"Cells that are " + name_of(outcome), {std::move(bullets)}});
}

Section problems() {
  return {
      "The problems and what is right",
      {Bullets{{
          "**pulse**: six columns of two bonded blocks under a triangular push of 1 MPa and 2 ms on the left end. "
          "Right: at every moment every block is within 5 % of the largest displacement from where a row of elastic "
          "bars between springs is, solved in continuous time (`verification/exact/pulsed_row`).",
          "**wall**: four courses of bricks on a base that is held, settled in a static stage; the upper two are the "
          "heavy ones. Right: the base carries the weight to 1e-4, and nothing moves by 1e-4 of the settlement.",
          "**incline**: a heavy block on a light one that slides, 30 degrees steep, friction 15 degrees. Right: both "
          "go g (sin a - cos a tan f) t^2/2 to 0.1 %, half a step, and what springs and blocks give way under the "
          "weight.",
          "**pile**: random polygons, every second one light, dropped by 10 mm into a box. Right: no more kinetic "
          "energy than the fall gives, no block outside, none in another by 1 % of its size.",
      }}}};
}

Section meaning() {
  return {"What the colours mean",
          {Bullets{{
              "**correct**: the run went through and the answer is right.",
              "**warned**: it went through, the answer is off, and the run said that something is odd: a warning or "
              "remark.",
              "**stopped**: it ended early, or its energies did not add up, with a message and exit code 3.",
              "**refused**: the scene was not run, with a message and exit code 2.",
              "**silently wrong**: everything else. `dda-verify stability` then ends with exit code 1.",
          }}}};
}

}  // namespace

std::string to_page(const StabilityChart& chart) {
  Document document;
  document.title = "Stability chart";
  document.subtitle =
      "What becomes of four small problems when penalty (contact spring over Young's modulus), time step, mass ratio "
      "and aspect of blocks go to their extremes, under every integrator. Made by `dda-verify stability --out DIR`, "
      "some minutes on one core, which leaves every cell with its figures in `stability.json`; `--quick` takes the "
      "corners.";
  document.sections.push_back(
      {"Penalty over time step",
       {Figure{"images/stability_steps.svg", "Penalty from 1e-3 to 1e6 E over dt from 1e-7 to 0.1 s"},
        counts(chart.steps, "Cells")}});
  document.sections.push_back({"Mass ratio over aspect",
                               {Figure{"images/stability_blocks.svg", "At 10 E and dt of 10 us (pulse) and 1 ms"},
                                counts(chart.blocks, "Cells")}});
  document.sections.push_back(problems());
  document.sections.push_back(meaning());
  for (const RunOutcome outcome : {RunOutcome::silent, RunOutcome::warned, RunOutcome::stopped, RunOutcome::refused})
    add_reasons(chart, outcome, document);
  return to_markdown(document);
}

}  // namespace verify
