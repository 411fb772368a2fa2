#include "verification/stability/stability_command.h"

#include <fmt/format.h>

#include <ostream>

#include "engine/record/atomic_file.h"
#include "verification/stability/chart.h"
#include "verification/stability/scenes.h"
#include "verification/study/jobs.h"

namespace verify {
namespace {

// What a job hands over: the cell without its setting, which goes by its index.
std::string text_of(const Cell& cell) {
  nlohmann::ordered_json json = {{"outcome", cell.outcome}, {"cpu_s", cell.cpu_s}};
  add_reasons(cell, json);
  return json.dump();
}

Cell cell_from(const std::string& text, const Setting& setting) {
  const auto json = nlohmann::ordered_json::parse(text);
  Cell cell;
  cell.setting = setting;
  cell.outcome = json.at("outcome").get<RunOutcome>();
  cell.cpu_s = json.at("cpu_s");
  read_reasons(json, cell);
  return cell;
}

// The scene of every cell that is not correct is kept, to be run and looked at.
std::vector<Cell> run_all(const std::vector<Setting>& settings, const std::string& map,
                          const StabilityCommand& command) {
  std::vector<Cell> cells;
  const auto run = [&](std::size_t i) { return text_of(run_cell(settings[i], scene_of(settings[i]))); };
  run_jobs(settings.size(), command.jobs, run, [&](std::size_t i, const std::string& text) {
    Cell& cell = cells.emplace_back(cell_from(text, settings[i]));
    if (cell.outcome == RunOutcome::right) return;
    cell.scene = fmt::format("scenes/{}_{}.json", map, cells.size());
    dda::write_file(command.folder / cell.scene, scene_of(settings[i]).dump(1) + "\n");
  });
  return cells;
}

std::size_t tell_silent(const std::vector<Cell>& cells, std::ostream& errors) {
  for (const Cell& cell : cells)
    if (cell.outcome == RunOutcome::silent)
      errors << fmt::format("dda-verify: silently wrong: {} ({})\n", words_for(cell.setting), cell.scene);
  return count_of(cells, RunOutcome::silent);
}

void write_chart(const StabilityChart& chart, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder / "images");
  dda::write_file(folder / "stability.json", to_json(chart));
  dda::write_file(folder / "stability.md", to_page(chart));
  dda::write_file(folder / "images" / "stability_steps.svg", steps_svg(chart));
  dda::write_file(folder / "images" / "stability_blocks.svg", blocks_svg(chart));
}

}  // namespace

int chart_stability(const StabilityCommand& command, std::ostream& out, std::ostream& errors) {
  std::filesystem::create_directories(command.folder / "scenes");
  StabilityChart chart;
  chart.grid = chart_grid(command.quick);
  chart.steps = run_all(step_settings(chart.grid), "steps", command);
  chart.blocks = run_all(block_settings(chart.grid), "blocks", command);
  write_chart(chart, command.folder);
  std::vector<Cell> all = chart.steps;
  all.insert(all.end(), chart.blocks.begin(), chart.blocks.end());
  out << counts_of(all, cell_outcomes());
  return tell_silent(chart.steps, errors) + tell_silent(chart.blocks, errors) > 0 ? 1 : 0;
}

StudyCommand stability_command() {
  return study_command<StabilityCommand>(
      "stability",
      "Penalty, time step, mass ratio and aspect of blocks at their extremes, in four small problems under every "
      "integrator: which runs are right, which refuse, warn or stop.\nWrites stability.json, stability.md and images/; "
      "some minutes. Exit code 1 if a run is wrong and says nothing.",
      [](StabilityCommand& a) -> std::vector<CommandOption> {
        return {out_folder(a.folder),
                {"--quick", &a.quick, "the corners of the chart under two integrators, in seconds"},
                jobs_at_once(a.jobs, "cells at once, each a process of its own; default: 1")};
      },
      [](const StabilityCommand& a, const Surroundings& s) { return chart_stability(a, s.out, s.errors); });
}

}  // namespace verify
