#include "verification/thesis/plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "verification/study/gnuplot.h"

namespace verify {
namespace {

std::string name_of(const std::string& svg) { return std::filesystem::path(svg).stem().string(); }

std::string data_name(const std::string& svg) { return name_of(svg) + ".dat"; }

// ---- histories -----------------------------------------------------------------------------------------------------

constexpr double plot_interval = 0.05e-3;  // s, 200 to a period; every sample would make the page ten times as large

// Columns: t (ms); for each of the two schemes and each block length sigma_x (kPa) and its difference from the analytic
// stress at the same place; then the analytic stress at the measuring point.
std::string history_data(const Calibration& calibration, double dt) {
  std::string text = "# t_ms, per scheme (thesis, accurate) and block length: sigma_kPa difference_kPa; analytic_kPa\n";
  const std::size_t samples = calibration.at("thesis", dt, calibration.block_lengths.front()).history.size();
  const auto stride = static_cast<std::size_t>(std::max(1.0, std::floor(plot_interval / dt + 1e-9)));
  for (std::size_t i = 0; i < samples; i += stride) {
    const double time = static_cast<double>(i) * dt;
    text += fmt::format("{:.4f}", time * 1e3);
    for (const char* scheme : {"thesis", "accurate"}) {
      for (const double length : calibration.block_lengths) {
        const CalibrationRow& row = calibration.at(scheme, dt, length);
        text += fmt::format(" {:.4f} {:.4f}", row.history[i] / 1e3,
                            (row.history[i] - analytic_stress(calibration.bar, time, row.place)) / 1e3);
      }
    }
    text += fmt::format(" {:.4f}\n", analytic_stress(calibration.bar, time, calibration.bar.measuring_point) / 1e3);
  }
  return text;
}

// From dark to light with the block length; the schemes' colours are others.
constexpr std::array<std::string_view, 5> length_colours = {"#0d0887", "#7e03a8", "#cc4778", "#f0804e", "#e0b000"};

std::string curves(const Calibration& calibration, const std::string& data, std::size_t scheme,
                   std::size_t difference) {
  std::string text = "plot";
  const std::size_t lengths = calibration.block_lengths.size();
  if (difference == 0)
    text += fmt::format(" '{}' using 1:{} with lines linestyle 9 title 'analytic',", data, 2 + 4 * lengths);
  for (std::size_t j = 0; j < lengths; ++j) {
    const std::size_t column = 2 + 2 * (scheme * lengths + j) + difference;
    text += fmt::format(" '{}' using 1:{} with lines linewidth 1.8 linecolor rgb '{}' title '{:g} m'{}", data, column,
                        length_colours.at(j), calibration.block_lengths[j], j + 1 < lengths ? "," : "\n");
  }
  return text;
}

std::string history_script(const Calibration& calibration, double dt) {
  const std::string svg = history_figure(dt);
  const std::string data = data_name(svg);
  return gnuplot_style(1080, 640) + fmt::format(R"(set output '{}'
set multiplot
set xrange [10:27]
set xtics 2
set lmargin at screen 0.075; set rmargin at screen 0.525
set bmargin at screen 0.42; set tmargin at screen 0.93
set yrange [-1300:1300]; set ytics 500
set format x ''
set ylabel 'σ_x (kPa)' offset 0.5
set title 'thesis scheme' offset 0,-0.5 font ',15'
unset key
{}
set lmargin at screen 0.545; set rmargin at screen 0.985
set format y ''; unset ylabel
set title 'accurate scheme' offset 0,-0.5 font ',15'
set key top right Left reverse
{}
unset title; unset key
set format x '%g'; set xlabel 'time (ms)'
set bmargin at screen 0.1; set tmargin at screen 0.36
set yrange [-750:750]; set ytics 500
set lmargin at screen 0.075; set rmargin at screen 0.525
set format y '%g'; set ylabel 'error (kPa)' offset 0.5
{}
set lmargin at screen 0.545; set rmargin at screen 0.985
set format y ''; unset ylabel
{}
unset multiplot
)",
                                                svg, curves(calibration, data, 0, 0), curves(calibration, data, 1, 0),
                                                curves(calibration, data, 0, 1), curves(calibration, data, 1, 1));
}

// ---- errors against eta --------------------------------------------------------------------------------------------

struct Series {
  std::string title;
  std::string style;  // of gnuplot
  std::function<double(const Calibration&, double dt, double length)> error_pct;
};

double percent_off(double value, double reference) { return 100 * std::abs(value / reference - 1); }

constexpr auto printed_points = "points pointtype 6 pointsize 1.3 linewidth 1.6 linecolor rgb '#000000'";
constexpr auto thesis_line = "linespoints linestyle 4";
constexpr auto thesis_other_line = "linespoints linestyle 2 dashtype (4,3)";
constexpr auto accurate_line = "linespoints linestyle 1";

std::vector<Series> amplitude_series() {
  return {
      {"printed, Table 3.2", printed_points,
       [](const Calibration& c, double dt, double length) {
         return percent_off(c.at("thesis", dt, length).printed.amplitude_kpa, c.bar.incident_stress() / 1e3);
       }},
      {"this engine, thesis scheme", thesis_line,
       [](const Calibration& c, double dt, double length) { return c.at("thesis", dt, length).amplitude_error_pct(); }},
      {"accurate scheme", accurate_line, [](const Calibration& c, double dt, double length) {
         return c.at("accurate", dt, length).amplitude_error_pct();
       }}};
}

std::vector<Series> velocity_series() {
  return {{"printed, Table 3.3", printed_points,
           [](const Calibration& c, double dt, double length) {
             return percent_off(c.at("thesis", dt, length).printed.velocity, c.bar.wave_speed());
           }},
          {"thesis scheme, onset", thesis_line,
           [](const Calibration& c, double dt, double length) {
             return percent_off(c.at("thesis", dt, length).picks.onset_velocity, c.bar.wave_speed());
           }},
          {"thesis scheme, correlation", thesis_other_line,
           [](const Calibration& c, double dt, double length) {
             return c.at("thesis", dt, length).correlation_error_pct();
           }},
          {"accurate scheme, correlation", accurate_line, [](const Calibration& c, double dt, double length) {
             return c.at("accurate", dt, length).correlation_error_pct();
           }}};
}

// One data set (gnuplot: index) per time step; columns eta and the magnitude of each series' error.
std::string error_data(const Calibration& calibration, const std::vector<Series>& series) {
  std::string text;
  for (const double dt : calibration.time_steps) {
    text += fmt::format("# dt = {:g} s: eta, errors in %\n", dt);
    for (const double length : calibration.block_lengths) {
      text += fmt::format("{:.5f}", calibration.bar.eta(length));
      for (const Series& each : series)
        text += fmt::format(" {:.6f}", std::abs(each.error_pct(calibration, dt, length)));
      text += "\n";
    }
    text += "\n\n";
  }
  return text;
}

std::string eta_tics(const Calibration& calibration) {
  std::string text = "set xtics (";
  for (const double length : calibration.block_lengths)
    text += fmt::format("{}\"{:.3f}\\n{:g} m\" {:.5f}", text.back() == '(' ? "" : ", ", calibration.bar.eta(length),
                        length, calibration.bar.eta(length));
  return text + ")\n";
}

std::string error_panel(const Calibration& calibration, const std::vector<Series>& series, const std::string& data,
                        std::size_t panel) {
  std::string text =
      fmt::format("set title 'Δt = {:g} ms' offset 0,-0.5 font ',15'\nplot", calibration.time_steps[panel] * 1e3);
  for (std::size_t i = 0; i < series.size(); ++i)
    text += fmt::format(" '{}' index {} using 1:{} with {} title '{}'{}", data, panel, i + 2, series[i].style,
                        series[i].title, i + 1 < series.size() ? "," : "\n");
  return text;
}

std::string error_script(const Calibration& calibration, const std::vector<Series>& series, const std::string& svg,
                         const std::string& quantity) {
  std::string text = gnuplot_style(1080, 430);
  text += fmt::format(R"(set output '{}'
set multiplot
set logscale xy
set xrange [0.0095:0.29]
set yrange [0.0002:50]
set ytics ('0.001' 0.001, '0.01' 0.01, '0.1' 0.1, '1' 1, '10' 10)
set xlabel "η = Δx/λ, and block length" offset 0,-0.9
set arrow 1 from 1./12, graph 0 to 1./12, graph 1 nohead linewidth 1.2 dashtype (2,3) linecolor rgb '#777777'
set label 1 'η = 1/12' at 1./12, graph 0.965 offset 0.6,0 textcolor rgb '#555555'
set bmargin at screen 0.22; set tmargin at screen 0.91
)",
                      svg);
  text += eta_tics(calibration);
  const double step = 0.91 / static_cast<double>(calibration.time_steps.size());
  for (std::size_t panel = 0; panel < calibration.time_steps.size(); ++panel) {
    const double left = 0.075 + static_cast<double>(panel) * step;
    text += fmt::format("set lmargin at screen {:.3f}; set rmargin at screen {:.3f}\n", left, left + step - 0.02);
    text += panel == 0 ? fmt::format("set ylabel '{} (%)' offset 0.5\n", quantity)
                       : "unset ylabel\nset ytics ('' 0.001, '' 0.01, '' 0.1, '' 1, '' 10)\n";
    text += panel + 1 < calibration.time_steps.size() ? "unset key\n"
                                                      : "set key at graph 0.02,0.02 left bottom Left reverse\n";
    text += error_panel(calibration, series, data_name(svg), panel);
  }
  return text + "unset multiplot\n";
}

// ---- run time against error ----------------------------------------------------------------------------------------

// The strip is left out: what it differs by from bar theory is physics, no error to be bought off with run time.
bool is_strip(std::string_view scheme) { return scheme == "accurate_strip"; }

// One data set per scheme and time step, in the order of the rows: CPU (ms), |amplitude error|, |velocity error| (%).
std::string cost_data(const Calibration& calibration) {
  std::string text;
  for (const std::string_view scheme : scheme_names()) {
    if (is_strip(scheme)) continue;
    for (const double dt : calibration.time_steps) {
      text += fmt::format("# {}, dt = {:g} s: cpu_ms, amplitude error %, correlation velocity error %\n", scheme, dt);
      for (const double length : calibration.block_lengths) {
        const CalibrationRow& row = calibration.at(scheme, dt, length);
        text += fmt::format("{:.6f} {:.6f} {:.6f}\n", row.cpu_s * 1e3, std::abs(row.amplitude_error_pct()),
                            std::abs(row.correlation_error_pct()));
      }
      text += "\n\n";
    }
  }
  return text;
}

// Colours of the schemes in the order of scheme_names(), as the other figures use them.
constexpr std::array<int, 5> scheme_styles = {4, 2, 3, 1, 5};

std::string cost_panel(const Calibration& calibration, const std::string& data, int column) {
  std::string text = "plot";
  std::size_t index = 0;
  for (std::size_t i = 0; i < scheme_names().size(); ++i) {
    if (is_strip(scheme_names()[i])) continue;
    for (const double dt : calibration.time_steps) {
      const bool finest = dt == std::ranges::min(calibration.time_steps);
      const std::string title = finest ? scheme_settings(scheme_names()[i]).title : "";
      text +=
          fmt::format("{} '{}' index {} using 1:{} with linespoints linestyle {} linewidth 1.1 pointtype {} title '{}'",
                      index == 0 ? "" : ",", data, index, column, scheme_styles.at(i), finest ? 7 : 6, title);
      ++index;
    }
  }
  return text + "\n";
}

std::string cost_script(const Calibration& calibration) {
  const std::string data = data_name(cost_figure);
  return gnuplot_style(1080, 500) + fmt::format(R"(set output '{}'
set multiplot
set logscale xy
set xrange [0.15:150]
set yrange [0.0002:50]
set ytics ('0.001' 0.001, '0.01' 0.01, '0.1' 0.1, '1' 1, '10' 10)
set xtics ('0.2' 0.2, '1' 1, '10' 10, '100' 100)
set xlabel 'CPU time of the stepping loop (ms)'
set bmargin at screen 0.14; set tmargin at screen 0.92
set lmargin at screen 0.075; set rmargin at screen 0.505
set ylabel 'error (%)' offset 0.5
set key at graph 0.02,0.02 left bottom Left reverse samplen 1.6
set title 'amplitude' offset 0,-0.5 font ',15'
{}
set lmargin at screen 0.555; set rmargin at screen 0.985
unset ylabel; unset key
set title 'correlation velocity' offset 0,-0.5 font ',15'
{}
unset multiplot
)",
                                                cost_figure, cost_panel(calibration, data, 2),
                                                cost_panel(calibration, data, 3));
}

}  // namespace

std::string figure_number(double dt) { return dt > 5e-5 ? "3.2" : "3.3"; }

std::string history_figure(double dt) { return dt > 5e-5 ? "fig_3_2_histories.svg" : "fig_3_3_histories.svg"; }

void plot_calibration(const Calibration& calibration, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const double dt : calibration.time_steps)
    draw(folder, {name_of(history_figure(dt)), history_data(calibration, dt), history_script(calibration, dt)});
  const auto draw_errors = [&](const std::string& svg, const std::vector<Series>& series, const std::string& quantity) {
    draw(folder, {name_of(svg), error_data(calibration, series), error_script(calibration, series, svg, quantity)});
  };
  draw_errors(amplitude_figure, amplitude_series(), "amplitude error");
  draw_errors(velocity_figure, velocity_series(), "velocity error");
  draw(folder, {name_of(cost_figure), cost_data(calibration), cost_script(calibration)});
}

}  // namespace verify
