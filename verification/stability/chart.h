// The chart as files: JSON with every cell, a picture of each map, a page with counts and reasons.
#pragma once

#include <string>
#include <vector>

#include "verification/stability/cell.h"

namespace verify {

struct StabilityChart {
  ChartGrid grid;
  std::vector<Cell> steps;   // step_settings(grid)
  std::vector<Cell> blocks;  // block_settings(grid)
};

[[nodiscard]] std::string to_json(const StabilityChart& chart);

// Rows are problems, columns integrators; each map has a square a cell.
[[nodiscard]] std::string steps_svg(const StabilityChart& chart);
[[nodiscard]] std::string blocks_svg(const StabilityChart& chart);

[[nodiscard]] std::string to_page(const StabilityChart& chart);

}  // namespace verify
