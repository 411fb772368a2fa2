#include "verification/chapters/run_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "verification/chapters/chapter_figures.h"

namespace verify {
namespace {

struct Curve {
  std::string run, name;  // of the run; of the curve
};

// Size of the vector of the two columns `quantity`_x and `quantity`_y.
std::vector<double> size_of(const SceneRun& run, const std::string& quantity) {
  const std::vector<double>& x = run.at(quantity + "_x");
  const std::vector<double>& y = run.at(quantity + "_y");
  std::vector<double> size(x.size());
  for (std::size_t row = 0; row < x.size(); ++row) size[row] = std::hypot(x[row], y[row]);
  return size;
}

// Stages that take no time have rows of one time: the last of them is what they ended with.
void keep_one_row_a_time(std::vector<double>& times, std::vector<double>& values) {
  std::size_t kept = 0;
  for (std::size_t row = 0; row < times.size(); ++row) {
    if (row > 0 && times[row] > times[kept]) ++kept;
    times[kept] = times[row];
    values[kept] = values[row];
  }
  times.resize(kept + 1);
  values.resize(kept + 1);
}

// One line for each run, as long as the shortest of them.
dda::LinePlot histories(const SceneFolder& folder, const std::vector<Curve>& curves, const std::string& quantity,
                        const std::string& title, const std::string& unit) {
  dda::LinePlot plot;
  plot.title = title;
  plot.unit = unit;
  for (const Curve& curve : curves) {
    const SceneRun run = folder.read(curve.run);
    if (!run.ok() || run.times().empty()) continue;
    std::vector<double> times = run.times();
    std::vector<double> values = size_of(run, quantity);
    keep_one_row_a_time(times, values);
    if (plot.lines.empty() || times.size() < plot.times.size()) plot.times = times;
    plot.lines.push_back({curve.name, std::move(values)});
  }
  for (dda::PlottedLine& line : plot.lines) line.values.resize(plot.times.size());
  return plot;
}

void add_mesh(const SceneFolder& folder, const std::string& run, const std::string& name, const std::string& caption,
              Section& section, Chapter& chapter) {
  const std::string svg = folder.picture(run);
  if (svg.empty()) return;
  chapter.figures.push_back({name + ".svg", svg});
  section.pieces.emplace_back(Figure{name + ".svg", caption});
}

std::string megapascals(double stress) { return fmt::format("{:g} MPa", stress / 1e6); }

}  // namespace

void draw_relaxation(const SceneFolder& folder, const std::vector<RelaxationResult>& results, Chapter& chapter) {
  if (results.empty() || !results.front().missing.empty()) return;
  const RelaxationReading& reading = results.front().reading;
  std::vector<Curve> curves;
  for (const double stress : relaxation_stresses())
    curves.push_back({relaxation_run(reading, stress), megapascals(stress)});
  Section section{"6.1, histories and meshes of `" + reading.name + "`", {}};
  for (const auto& [quantity, unit] : {std::pair("displacement", "m"), {"velocity", "m/s"}, {"acceleration", "m/s2"}})
    add_figure(fmt::format("6_1_history_{}", quantity),
               fmt::format("Size of the {} of key block 1 after the tunnel is opened", quantity),
               histories(folder, curves, fmt::format("block_1_{}", quantity),
                         fmt::format("{} of key block 1", quantity), unit),
               section, chapter);
  for (const double stress : relaxation_stresses())
    add_mesh(folder, relaxation_run(reading, stress), fmt::format("6_1_mesh_{:g}MPa", stress / 1e6),
             fmt::format("The mesh at the end, {} in situ, with its principal stresses", megapascals(stress)), section,
             chapter);
  chapter.sections.push_back(std::move(section));
}

void draw_tunnel_blast(const SceneFolder& folder, const std::vector<TunnelBlastResult>& results, Chapter& chapter) {
  if (results.empty()) return;
  const TunnelBlastReading& reading = results.front().reading;
  Section section{"6.2, histories and meshes of `" + reading.name + "`", {}};
  for (const double stress : blast_stresses()) {
    const std::string name = megapascals(stress);
    std::vector<Curve> curves;
    for (const double friction : blast_frictions())
      curves.push_back({tunnel_blast_run(reading, friction, stress, true), fmt::format("{:g} deg", friction)});
    add_figure(fmt::format("6_2_history_{:g}MPa", stress / 1e6),
               fmt::format("Speed of point 1, the wall at the blast, {} in situ, by friction", name),
               histories(folder, curves, "point_1_velocity", "speed of point 1", "m/s"), section, chapter);
    for (const double friction : {blast_frictions().front(), blast_frictions().back()})
      add_mesh(folder, tunnel_blast_run(reading, friction, stress, true),
               fmt::format("6_2_mesh_{:g}MPa_{:g}deg", stress / 1e6, friction),
               fmt::format("The mesh at the end, {} in situ, friction {:g} deg, with its principal stresses", name,
                           friction),
               section, chapter);
  }
  chapter.sections.push_back(std::move(section));
}

}  // namespace verify
