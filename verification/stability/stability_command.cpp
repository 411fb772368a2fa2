#include "verification/stability/stability_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "engine/record/atomic_file.h"
#include "engine/record/progress.h"
#include "verification/stability/chart.h"
#include "verification/stability/scenes.h"

namespace verify {
namespace {

// The scene of every cell that is not correct is kept, to be run and looked at.
std::vector<Cell> run_all(const std::vector<Setting>& settings, const std::string& map,
                          const std::filesystem::path& folder) {
  std::vector<Cell> cells;
  dda::Progress progress(0, static_cast<double>(settings.size()), dda::terminal());
  for (const Setting& setting : settings) {
    const nlohmann::ordered_json scene = scene_of(setting);
    Cell& cell = cells.emplace_back(run_cell(setting, scene));
    progress.update(static_cast<double>(cells.size()), static_cast<std::int64_t>(cells.size()));
    if (cell.outcome == Outcome::correct) continue;
    cell.scene = fmt::format("scenes/{}_{}.json", map, cells.size());
    dda::write_file(folder / cell.scene, scene.dump(1) + "\n");
  }
  return cells;
}

std::size_t tell_silent(const std::vector<Cell>& cells, std::ostream& errors) {
  for (const Cell& cell : cells)
    if (cell.outcome == Outcome::silent)
      errors << fmt::format("dda-verify: silently wrong: {} ({})\n", words_for(cell.setting), cell.scene);
  return static_cast<std::size_t>(std::ranges::count(cells, Outcome::silent, &Cell::outcome));
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
  chart.steps = run_all(step_settings(chart.grid), "steps", command.folder);
  chart.blocks = run_all(block_settings(chart.grid), "blocks", command.folder);
  write_chart(chart, command.folder);
  for (const Outcome outcome : all_outcomes)
    out << fmt::format("{:5} {}\n",
                       std::ranges::count(chart.steps, outcome, &Cell::outcome) +
                           std::ranges::count(chart.blocks, outcome, &Cell::outcome),
                       name_of(outcome));
  return tell_silent(chart.steps, errors) + tell_silent(chart.blocks, errors) > 0 ? 1 : 0;
}

}  // namespace verify
