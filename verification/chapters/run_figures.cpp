#include "verification/chapters/run_figures.h"

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "verification/chapters/chapter_figures.h"

namespace verify {
namespace {

struct Curve {
  std::string name;
  SceneRun run;
};

// Those whose runs are well.
void add_curve(const SceneFolder& folder, const std::string& run, const std::string& name, std::vector<Curve>& curves) {
  SceneRun read = folder.read(run);
  if (read.ok() && !read.times().empty()) curves.push_back({name, std::move(read)});
}

// From the settled state on; a line for each run, as long as the shortest of them.
dda::LinePlot histories(const std::vector<Curve>& curves, const std::string& quantity, const std::string& title,
                        const std::string& unit) {
  dda::LinePlot plot;
  plot.title = title;
  plot.unit = unit;
  for (const auto& [name, run] : curves) {
    const auto from = static_cast<std::ptrdiff_t>(run.settled_row());
    const std::vector<double> sizes = run.size_of(quantity);
    plot.lines.push_back({name, {sizes.begin() + from, sizes.end()}});
    if (plot.lines.size() == 1 || sizes.size() - run.settled_row() < plot.times.size())
      plot.times.assign(run.times().begin() + from, run.times().end());
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

// The columns of one run, or some of one and some of another, whose times are the same.
void add_lines(const SceneRun& run, const std::vector<std::string>& columns, const std::string& added,
               dda::LinePlot& plot) {
  for (const std::string& column : columns) plot.lines.push_back({column + added, run.at(column)});
}

dda::LinePlot velocities(const std::string& title, const SceneRun& run) {
  dda::LinePlot plot;
  plot.title = title;
  plot.unit = "m/s";
  plot.times = run.times();
  return plot;
}

std::vector<std::string> names_of_sensors() {
  std::vector<std::string> names;
  for (const Sensor& sensor : jinping_sensors()) names.push_back(sensor.name);
  return names;
}

void draw_jinping_reading(const SceneFolder& folder, const JinpingReading& reading, Section& section,
                          Chapter& chapter) {
  const SceneRun run = folder.read(jinping_run(reading, 0));
  const SceneRun larger = folder.read(jinping_run(reading, larger_margin));
  if (!run.ok() || !larger.ok() || run.times().size() != larger.times().size()) return;
  dda::LinePlot sensors = velocities("velocity along the axis, " + reading.name, run);
  add_lines(run, names_of_sensors(), "", sensors);
  add_figure("5_sensors_" + reading.name, "Velocities at the sensors: " + reading.difference, sensors, section,
             chapter);
  dda::LinePlot edges = velocities("velocity at the edges, " + reading.name, run);
  add_lines(run, {"point 5", "point 6"}, "", edges);
  add_lines(larger, {"point 5", "point 6"}, ", larger rock", edges);
  add_figure("5_edges_" + reading.name, "Velocities at the two points at the edges, and there in larger rock", edges,
             section, chapter);
}

}  // namespace

void draw_jinping(const SceneFolder& folder, const std::vector<JinpingReading>& readings, Chapter& chapter) {
  Section section{"Histories", {}};
  for (const JinpingReading& reading : readings) draw_jinping_reading(folder, reading, section, chapter);
  if (!section.pieces.empty()) chapter.sections.push_back(std::move(section));
}

void draw_relaxation(const SceneFolder& folder, const std::vector<RelaxationResult>& results, Chapter& chapter) {
  if (results.empty() || !results.front().missing.empty()) return;
  const RelaxationReading& reading = results.front().reading;
  std::vector<Curve> curves;
  for (const double stress : relaxation_stresses())
    add_curve(folder, relaxation_run(reading, stress), megapascals(stress), curves);
  Section section{"6.1, histories and meshes of `" + reading.name + "`", {}};
  for (const auto& [quantity, unit] : {std::pair("displacement", "m"), {"velocity", "m/s"}, {"acceleration", "m/s2"}})
    add_figure(fmt::format("6_1_history_{}", quantity),
               fmt::format("Size of the {} of key block 1 after the tunnel is opened", quantity),
               histories(curves, fmt::format("block_1_{}", quantity), fmt::format("{} of key block 1", quantity), unit),
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
      add_curve(folder, tunnel_blast_run(reading, friction, stress, true), fmt::format("{:g} deg", friction), curves);
    add_figure(fmt::format("6_2_history_{:g}MPa", stress / 1e6),
               fmt::format("Speed of point 1, the wall at the blast, {} in situ, by friction", name),
               histories(curves, "point_1_velocity", "speed of point 1", "m/s"), section, chapter);
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
