// What one cell of the chart is about: a problem, and the numbers that are driven to their extremes in it.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace verify {

enum class ChartProblem { pulse, wall, incline, pile };
inline constexpr std::array all_problems{ChartProblem::pulse, ChartProblem::wall, ChartProblem::incline,
                                         ChartProblem::pile};
[[nodiscard]] std::string name_of(ChartProblem problem);

struct Setting {
  ChartProblem problem = ChartProblem::pulse;
  std::string integrator = "thesis";  // as scenes name it; with its parameter behind: "hht 0.1"
  double penalty = 10;                // contact spring over Young's modulus
  double dt = 1e-3;                   // s
  double mass_ratio = 1;              // density of the heavy blocks over that of the light ones under or beside them
  double aspect = 1;                  // width over height, over what it is in the ordinary scene
  int most_steps = 2000;              // ten times as many for the pulse, whose steps are linear
};

// The whole duration of the problem, but at least ten steps and at most what the setting allows.
[[nodiscard]] int steps_of(const Setting& setting);

// The same words for files and command lines: "wall, thesis, penalty 10, dt 0.001, mass ratio 1, aspect 1".
[[nodiscard]] std::string words_for(const Setting& setting);

// Values of the chart's axes. `quick`: the corners and the middle of each, two integrators, few steps.
struct ChartGrid {
  std::vector<std::string> integrators;
  std::vector<double> penalties, dts;        // of one map
  std::vector<double> mass_ratios, aspects;  // of the other
  int most_steps = 0;
};
[[nodiscard]] ChartGrid chart_grid(bool quick);

// Penalty over dt in ordinary blocks, then mass ratio over aspect at the ordinary penalty and dt.
[[nodiscard]] std::vector<Setting> step_settings(const ChartGrid& grid);
[[nodiscard]] std::vector<Setting> block_settings(const ChartGrid& grid);

}  // namespace verify
