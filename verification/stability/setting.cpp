#include "verification/stability/setting.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verification/study/grid.h"

namespace verify {
namespace {

// s: two crossings of the pulse; vibrations of the wall; a metre of sliding; the pile's fall and rest.
double duration_of(ChartProblem problem) {
  switch (problem) {
    case ChartProblem::pulse: return 4e-3;
    case ChartProblem::wall: return 0.5;
    case ChartProblem::incline: return 1;
    case ChartProblem::pile: return 0.5;
  }
  return 0;
}

double ordinary_dt(ChartProblem problem) { return problem == ChartProblem::pulse ? 1e-5 : 1e-3; }

Setting ordinary(const ChartGrid& grid, ChartProblem problem, const std::string& integrator) {
  Setting setting;
  setting.problem = problem;
  setting.integrator = integrator;
  setting.dt = ordinary_dt(problem);
  setting.most_steps = grid.most_steps;
  return setting;
}

struct Axis {
  double Setting::*quantity;
  const std::vector<double>& values;
};

// Every problem and integrator with all pairs of values, the others being ordinary.
std::vector<Setting> all_settings(const ChartGrid& grid, const Axis& outer, const Axis& inner) {
  std::vector<Setting> settings;
  for (const ChartProblem problem : all_problems)
    for (const std::string& integrator : grid.integrators) settings.push_back(ordinary(grid, problem, integrator));
  for (const Axis& axis : {outer, inner})
    settings = with_each(settings, axis.values, [&](double value, Setting& each) { each.*axis.quantity = value; });
  return settings;
}

}  // namespace

std::string name_of(ChartProblem problem) {
  switch (problem) {
    case ChartProblem::pulse: return "pulse";
    case ChartProblem::wall: return "wall";
    case ChartProblem::incline: return "incline";
    case ChartProblem::pile: return "pile";
  }
  return "";
}

int steps_of(const Setting& setting) {
  const int most = setting.problem == ChartProblem::pulse ? 10 * setting.most_steps : setting.most_steps;
  const double steps = std::ceil(duration_of(setting.problem) / setting.dt * (1 - 1e-9));
  return static_cast<int>(std::clamp(steps, 10.0, static_cast<double>(most)));
}

std::string words_for(const Setting& setting) {
  return fmt::format("{}, {}, penalty {:g}, dt {:g}, mass ratio {:g}, aspect {:g}", name_of(setting.problem),
                     setting.integrator, setting.penalty, setting.dt, setting.mass_ratio, setting.aspect);
}

ChartGrid chart_grid(bool quick) {
  if (quick) return {{"thesis", "trapezoidal"}, {1e-3, 10, 1e6}, {1e-7, 1e-3, 1e-1}, {1, 1e6}, {1, 1e4}, 100};
  return {{"thesis", "generalized_alpha 0", "generalized_alpha 0.85", "hht 0.1", "trapezoidal", "energy_conserving"},
          {1e-3, 1e-2, 1e-1, 1, 10, 1e2, 1e3, 1e4, 1e5, 1e6},
          {1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1},
          {1, 1e2, 1e4, 1e6},
          {1, 10, 1e2, 1e3, 1e4},
          1000};
}

std::vector<Setting> step_settings(const ChartGrid& grid) {
  return all_settings(grid, {&Setting::penalty, grid.penalties}, {&Setting::dt, grid.dts});
}

std::vector<Setting> block_settings(const ChartGrid& grid) {
  return all_settings(grid, {&Setting::mass_ratio, grid.mass_ratios}, {&Setting::aspect, grid.aspects});
}

}  // namespace verify
