#include "verification/precision/plots.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "verification/precision/table.h"
#include "verification/study/gnuplot.h"

namespace verify {
namespace {

struct Curve {
  std::string title;
  std::string look;  // gnuplot: with ...
  std::vector<CostAndError> points;
};

std::vector<CostAndError> front_points(const std::vector<Measured>& runs, Cost cost) {
  const std::vector<CostAndError> points = points_of(runs, cost);
  std::vector<CostAndError> front;
  for (const std::size_t i : pareto_front(points)) front.push_back(points[i]);
  return front;
}

// One point in each 1/7 of a decade of cost and of error: a small file that looks the same.
std::vector<CostAndError> thinned(const std::vector<CostAndError>& points) {
  constexpr double cells = 7;
  std::map<std::pair<int, int>, CostAndError> kept;
  for (const CostAndError& point : points)
    kept.try_emplace({static_cast<int>(std::floor(cells * std::log10(point.cost))),
                      static_cast<int>(std::floor(cells * std::log10(point.error)))},
                     point);
  std::vector<CostAndError> rest;
  for (const auto& [cell, point] : kept) rest.push_back(point);
  return rest;
}

bool is_other_system(const PrecisionScheme& scheme) { return !scheme.is_engine() && !scheme.is_yardstick(); }

std::vector<Measured> other_runs(const std::vector<Measured>& all, Problem problem) {
  std::vector<Measured> others;
  for (const Measured& measured : runs_of(all, problem))
    if (is_other_system(measured.job.scheme)) others.push_back(measured);
  return others;
}

std::vector<Curve> curves_of(const std::vector<Measured>& all, Problem problem, Cost cost) {
  std::vector<Curve> curves;
  curves.push_back({"every run of the engine", "points pointtype 7 pointsize 0.25 linecolor rgb '#cccccc'",
                    thinned(points_of(engine_runs(all, problem), cost))});
  const std::vector<std::pair<std::string, PrecisionScheme>> shown = {
      {"thesis (classical springs, Eq. 5)", thesis_scheme()},
      {"classical springs, trapezoidal", {"classical", "trapezoidal"}},
      {"consistent, generalized-α", {"consistent", "generalized_alpha 0.85"}},
      {fmt::format("{}, generalized-α, corrected", accurate_scheme(problem).law), accurate_scheme(problem)},
      {"yardstick: explicit finite elements", {std::string(yardstick_law), std::string(central_differences)}}};
  int style = 1;
  for (const auto& [title, scheme] : shown) {
    std::vector<CostAndError> front = front_points(runs_of(all, problem, scheme), cost);
    if (!front.empty()) curves.push_back({title, fmt::format("linespoints linestyle {}", style), std::move(front)});
    ++style;
  }
  if (cost == Cost::cpu && !other_runs(all, problem).empty())
    curves.push_back({"CalculiX", "points linestyle 6 pointsize 1.0", points_of(other_runs(all, problem), cost)});
  curves.push_back({"front of the engine", "lines linestyle 9", front_points(engine_runs(all, problem), cost)});
  return curves;
}

std::string title_of(Problem problem) {
  if (problem == Problem::plane) return "Plate: P and S wave at 30 m";
  return problem == Problem::bar ? "Bar, 100 Hz pulse, stress at 50 m" : "Bar, the thesis’ sine cycle, stress at 50 m";
}

std::string data_of(const std::vector<Curve>& curves) {
  std::string text = "# cost, relative error; a block a curve\n";
  for (const Curve& curve : curves) {
    for (const CostAndError& point : curve.points)
      if (point.error < 1) text += fmt::format("{:.6g} {:.6g}\n", point.cost, point.error);
    text += "\n\n";
  }
  return text;
}

std::string script_of(const std::string& name, Problem problem, Cost cost, const std::vector<Curve>& curves) {
  std::string text = gnuplot_style(640, 520);
  text += fmt::format(
      "set output '{0}.svg'\nset title \"{1}\"\nset logscale xy\nset format '10^{{%L}}'\nset xlabel '{2}'\n"
      "set ylabel 'relative L_2 error'\nset yrange [{3}:1]\nset key outside below maxcols 2\nplot ",
      name, title_of(problem), cost == Cost::cpu ? "CPU time (s)" : "passes over a block or element",
      problem == Problem::plane ? "0.003" : "1e-4");
  for (std::size_t i = 0; i < curves.size(); ++i)
    text += fmt::format("{}'{}.dat' index {} with {} title \"{}\"", i == 0 ? "" : ", \\\n  ", name, i, curves[i].look,
                        curves[i].title);
  return text + "\n";
}

}  // namespace

void plot_study(const std::vector<Measured>& all, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const Problem problem : {Problem::bar, Problem::bar_cycle, Problem::plane}) {
    if (runs_of(all, problem).empty()) continue;
    for (const Cost cost : {Cost::cpu, Cost::passes}) {
      const std::string name = fmt::format("{}_{}", name_of(problem), cost == Cost::cpu ? "cpu" : "passes");
      const std::vector<Curve> curves = curves_of(all, problem, cost);
      draw(folder, {name, data_of(curves), script_of(name, problem, cost, curves)});
    }
  }
}

}  // namespace verify
