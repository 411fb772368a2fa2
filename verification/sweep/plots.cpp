#include "verification/sweep/plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "verification/study/gnuplot.h"

namespace verify {
namespace {

// Without the round-off of an eta or cfl made of a length and a time step, which would split a line of the grid.
double axis_value(const JobParameters& job, const std::string& name) {
  return std::stod(fmt::format("{:.9g}", to_json(job).at(name).get<double>()));
}

// Measured and predicted error (%), and whether they agree.
std::string errors_of(const JobFile& job, const std::string& quantity) {
  if (job.status != "ok") return "NaN NaN NaN";
  const auto number = [&](const std::string& name) {  // null where nothing was foretold
    const auto& value = job.result.at(name);
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
  };
  return fmt::format("{:.9g} {:.9g} {}", number(quantity + "_error_pct"),
                     number("predicted_" + quantity + "_error_pct"),
                     job.result.at(quantity + "_agrees").get<bool>() ? 1 : 0);
}

std::string axis_title(const std::string& name) {
  static const std::map<std::string, std::string> titles = {{"eta", "η = block length/wavelength"},
                                                            {"cfl", "CFL = c Δt/block length"},
                                                            {"dt", "Δt (s)"},
                                                            {"block_length", "block length (m)"}};
  const auto title = titles.find(name);
  if (title != titles.end()) return title->second;
  std::string words = name;
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

// Spread over a decade or more: better seen in logarithms.
bool is_wide(const std::set<double>& values) { return *values.begin() > 0 && *values.rbegin() >= 8 * *values.begin(); }

// ---- contours ------------------------------------------------------------------------------------------------------

using Places = std::map<std::pair<double, double>, std::size_t>;  // (y, x) -> job

struct Plane {
  std::set<double> xs, ys;
  Places jobs;
};

Plane plane_of(const SweepSpec& spec, const SweepPlot& plot, const PlotGroup& group) {
  Plane plane;
  for (const std::size_t i : group.jobs) {
    const double x = axis_value(spec.jobs[i], plot.x), y = axis_value(spec.jobs[i], plot.y);
    plane.xs.insert(x);
    plane.ys.insert(y);
    plane.jobs[{y, x}] = i;
  }
  return plane;
}

// A block of lines for each y, as gnuplot wants its grids.
std::string contour_data(const Plane& plane, const std::vector<JobFile>& jobs, const std::string& quantity) {
  std::string text = "# x, y, measured and predicted error (%), 1: they agree\n";
  for (const double y : plane.ys) {
    for (const double x : plane.xs) {
      const auto place = plane.jobs.find({y, x});
      text += fmt::format("{:.9g} {:.9g} {}\n", x, y,
                          place == plane.jobs.end() ? "NaN NaN NaN" : errors_of(jobs[place->second], quantity));
    }
    text += "\n";
  }
  return text;
}

std::string log_axes(const Plane& plane) {
  const std::string axes = std::string(is_wide(plane.xs) ? "x" : "") + (is_wide(plane.ys) ? "y" : "");
  return axes.empty() ? "" : "set logscale " + axes + "\n";
}

std::string panel(const std::string& data, const std::string& value) {
  return fmt::format(
      "splot '{0}' using 1:2:{1} with pm3d nocontour, '{0}' using 1:2:{1} with lines linewidth 1 linecolor rgb "
      "'#222222' nosurface, '{0}' using 1:($5==1?$2:NaN):(0) with points pointtype 7 pointsize 0.45 linecolor rgb "
      "'#000000' nocontour, '{0}' using 1:($5==0?$2:NaN):(0) with points pointtype 2 pointsize 0.8 linewidth 1.5 "
      "linecolor rgb '#d0021b' nocontour\n",
      data, value);
}

constexpr auto contour_settings = R"(set view map
set pm3d explicit interpolate 6,6
set contour base
set cntrlabel onecolor
unset key
unset grid
set tics front
set cbtics scale 0.4
)";

std::string contour_script(const PlotFiles& figure, const Plane& plane, const SweepPlot& plot, const std::string& title,
                           const std::string& quantity) {
  const std::string data = figure.name + ".dat";
  std::string text = gnuplot_style(1300, 430) + contour_settings + log_axes(plane);
  text += fmt::format("set output '{}.svg'\nset xrange [{:.9g}:{:.9g}]\nset yrange [{:.9g}:{:.9g}]\n", figure.name,
                      *plane.xs.begin(), *plane.xs.rbegin(), *plane.ys.begin(), *plane.ys.rbegin());
  text += fmt::format("set xlabel '{}'\nset ylabel '{}'\n", axis_title(plot.x), axis_title(plot.y));
  text += fmt::format("set multiplot layout 1,3 title '{} error{}{}' font ',15'\n", quantity, title.empty() ? "" : ": ",
                      title);
  text += R"(set palette defined (0 '#f7fbff', 1 '#c6dbef', 2 '#6baed6', 3 '#2171b5', 4 '#08306b')
set cbrange [-3:1.5]
set cbtics ('0.001' -3, '0.01' -2, '0.1' -1, '1' 0, '10' 1)
set cntrparam levels discrete -2,-1,0,1
set title 'measured (%)'
)";
  text += panel(data, "(log10(abs($3)+1e-6))");
  text += "set title 'predicted (%)'\n" + panel(data, "(log10(abs($4)+1e-6))");
  text += R"(set palette defined (0 '#b35806', 0.83 '#fdb863', 1 '#f7f7f7', 1.25 '#b2abd2', 2 '#542788')
set cbrange [0:2]
set cbtics ('≤ 0' 0, '0.5' 0.5, '0.83' 0.8333, '1' 1, '1.25' 1.25, '1.5' 1.5, '≥ 2' 2)
set cntrparam levels discrete 0.83333,1.25
set title 'measured over predicted'
)";
  text += panel(data, "($3/$4 > 2 ? 2 : $3/$4 < 0 ? 0 : $3/$4)");
  return text + "unset multiplot\n";
}

void draw_contours(const SweepSpec& spec, const std::vector<JobFile>& jobs, const SweepPlot& plot,
                   const std::filesystem::path& folder) {
  const std::vector<PlotGroup> groups = groups_of(spec, plot);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const Plane plane = plane_of(spec, plot, groups[i]);
    if (plane.xs.size() < 2 || plane.ys.size() < 2) continue;
    for (const char* quantity : {"velocity", "amplitude"}) {
      PlotFiles figure{fmt::format("{}_{}_{}_{}", quantity, plot.x, plot.y, i + 1), "", ""};
      figure.data = contour_data(plane, jobs, quantity);
      figure.script = contour_script(figure, plane, plot, groups[i].title, quantity);
      draw(folder, figure);
    }
  }
}

// ---- lines ---------------------------------------------------------------------------------------------------------

std::string line_data(const SweepSpec& spec, const std::vector<JobFile>& jobs, const SweepPlot& plot,
                      const std::vector<PlotGroup>& groups, const std::string& quantity) {
  std::string text = "# a data set for each line: x, measured and predicted error (%), 1: they agree\n";
  for (const PlotGroup& group : groups) {
    std::map<double, std::size_t> in_order;
    for (const std::size_t i : group.jobs) in_order[axis_value(spec.jobs[i], plot.x)] = i;
    for (const auto& [x, i] : in_order) text += fmt::format("{:.9g} {}\n", x, errors_of(jobs[i], quantity));
    text += "\n\n";
  }
  return text;
}

std::string line_script(const PlotFiles& figure, const SweepSpec& spec, const SweepPlot& plot,
                        const std::vector<PlotGroup>& groups, const std::string& quantity) {
  std::set<double> xs;
  for (const JobParameters& job : spec.jobs) xs.insert(axis_value(job, plot.x));
  std::string text = gnuplot_style(900, 480) + fmt::format("set output '{}.svg'\n", figure.name);
  text += is_wide(xs) ? "set logscale xy\n" : "set logscale y\n";
  text +=
      fmt::format("set xlabel '{}'\nset ylabel 'size of the {} error (%)'\nset key outside right top Left reverse\n",
                  axis_title(plot.x), quantity);
  text += "set title 'points: measured, dashed: predicted'\nplot";
  for (std::size_t i = 0; i < groups.size(); ++i)
    text += fmt::format(
        "{0} '{1}.dat' index {2} using 1:(abs($2)) with linespoints linestyle {3} title '{4}', '{1}.dat' index {2} "
        "using 1:(abs($3)) with lines linestyle {3} dashtype (6,4) notitle",
        i == 0 ? "" : ",", figure.name, i, i % 6 + 1, groups[i].title.empty() ? "measured" : groups[i].title);
  return text + "\n";
}

void draw_lines(const SweepSpec& spec, const std::vector<JobFile>& jobs, const SweepPlot& plot,
                const std::filesystem::path& folder) {
  const std::vector<PlotGroup> groups = groups_of(spec, plot);
  for (const char* quantity : {"velocity", "amplitude"}) {
    PlotFiles figure{fmt::format("{}_{}", quantity, plot.x), "", ""};
    figure.data = line_data(spec, jobs, plot, groups, quantity);
    figure.script = line_script(figure, spec, plot, groups, quantity);
    draw(folder, figure);
  }
}

}  // namespace

void plot_sweep(const SweepSpec& spec, const std::vector<JobFile>& jobs, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const bool any = std::any_of(jobs.begin(), jobs.end(), [](const JobFile& job) { return job.status == "ok"; });
  if (!any) return;
  for (const SweepPlot& plot : spec.plots) {
    if (plot.y.empty()) {
      draw_lines(spec, jobs, plot, folder);
    } else {
      draw_contours(spec, jobs, plot, folder);
    }
  }
}

}  // namespace verify
