#include "verification/thesis/blast_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace verify {
namespace {

const BlastResult& named(const BlastStudy& study, const std::string& name) {
  for (const BlastResult& result : study.results)
    if (result.name == name) return result;
  throw std::out_of_range("no blast run of that name");
}

// The stress (Pa) at the first point of a direction, which is the largest, as stresses fall from there.
double first_stress(const BlastStudy& study, const std::string& name, bool level) {
  const auto& points = study.points;
  const auto first = std::find_if(points.begin(), points.end(), [&](const auto& p) { return p.level() == level; });
  return named(study, name).readings.at(static_cast<std::size_t>(first - points.begin())).peak_stress;
}

double upright_over_level(const BlastStudy& study, const std::string& name) {
  return first_stress(study, name, false) / first_stress(study, name, true);
}

using Cell = std::function<std::string(const BlastReading&, const PrintedArrival&)>;

// A row a run, a column a point.
std::vector<std::vector<std::string>> rows_of(const BlastStudy& study, const Cell& cell) {
  std::vector<std::vector<std::string>> rows;
  for (const BlastResult& result : study.results) {
    std::vector<std::string> row{result.name};
    for (std::size_t i = 0; i < study.points.size(); ++i) row.push_back(cell(result.readings[i], study.points[i]));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<std::string> header_of(const BlastStudy& study, const std::string& first) {
  std::vector<std::string> header{first};
  for (const PrintedArrival& point : study.points)
    header.push_back(fmt::format("{}, {:g} m", point.point, point.distance));
  return header;
}

std::vector<std::string> printed_row(const BlastStudy& study, const std::string& name,
                                     const std::function<std::string(const PrintedArrival&)>& cell) {
  std::vector<std::string> row{name};
  for (const PrintedArrival& point : study.points) row.push_back(cell(point));
  return row;
}

std::string actual(const PrintedArrival& point) {
  return point.actual_ms ? fmt::format("{:.2f}", *point.actual_ms) : "N/A";
}

Table times_table(const ThesisBlast& blast, const BlastStudy& study) {
  Table table{"Time of the largest velocity away from the blast, ms after it (Table 4.1)",
              {},
              header_of(study, "ms"),
              {},
              true,
              {2}};
  table.rows.push_back(printed_row(study, "thesis, actual", actual));
  table.rows.push_back(printed_row(study, "thesis, predicted: 1.1 R/c_P of Eq. 11",
                                   [](const PrintedArrival& p) { return fmt::format("{:.2f}", p.predicted_ms); }));
  for (auto& row : rows_of(study, [](const BlastReading&reading, const PrintedArrival&) {
         return fmt::format("{:.2f}", 1e3 * reading.peak_time);
       }))
    table.rows.push_back(std::move(row));
  const double wait = 1.1 * blast_arrival_time(blast);
  const auto front = [&](const PrintedArrival& point) {
    return fmt::format("{:.2f}",
                       1e3 * (wait + (point.distance - blast.octagon_width() / 2) / blast.speed_plane_stress()));
  };
  table.rows.push_back(printed_row(study, "front: 1.1 t_a + (R - a)/c_P of plane stress", front));
  return table;
}

std::string percent_of_printed(const BlastReading& reading, const PrintedArrival& point) {
  return point.actual_ms ? fmt::format("{:+.1f}", 100 * (1e3 * reading.peak_time / *point.actual_ms - 1)) : "-";
}

Table differences_table(const BlastStudy& study) {
  return {"Difference of these times from the thesis' actual ones, %",
          {},
          header_of(study, "%"),
          rows_of(study, percent_of_printed),
          true,
          {}};
}

Table stresses_table(const ThesisBlast& blast, const BlastStudy& study) {
  Table table{"Largest compression in the direction of the blast, MPa (Figures 4.5 and 4.6)",
              {},
              header_of(study, "MPa"),
              {},
              true,
              {1}};
  table.rows.push_back(printed_row(study, "thesis, the two numbers in its text", [&](const PrintedArrival& point) {
    if (point.point == "H1") return fmt::format("{:.2f}", blast.level_stress / 1e6);
    return point.point == "V1" ? fmt::format("{:.2f}", blast.upright_stress / 1e6) : std::string("-");
  }));
  for (auto& row : rows_of(study, [](const BlastReading&reading, const PrintedArrival&) {
         return fmt::format("{:.2f}", reading.peak_stress / 1e6);
       }))
    table.rows.push_back(std::move(row));
  return table;
}

Table velocities_table(const BlastStudy& study) {
  return {"Peak particle velocity, m/s (Figures 4.7 and 4.8, of which only the captions are known)",
          {},
          header_of(study, "m/s"),
          rows_of(study, [](const BlastReading& reading,
                            const PrintedArrival&) { return fmt::format("{:.3f}", reading.peak_velocity); }),
          true,
          {}};
}

Section text_says(const ThesisBlast& blast) {
  return {
      "What the text says",
      {Bullets{{fmt::format("rock: density {:g} kg/m3, E = {:g} GPa, Poisson's ratio {:g}; no initial stress; joints "
                            "with a friction angle of 45 deg (no cohesion or tensile strength is given)",
                            blast.density, blast.young / 1e9, blast.poisson),
                fmt::format("time step {:g} s, viscous edges, blast at 2 s", blast.time_step),
                fmt::format("a blast element of eight blocks, a hollow octagon with edges of {:g} m; 10,000 kN a face, "
                            "{:g} MPa at its edge",
                            blast.octagon_edge, blast.peak_pressure / 1e6),
                "pressure by Eq. 18: P0 exp(-(t - 1.1 t_a)/t_a) from t = 1.1 t_a on, t_a = R/c",
                "blocks 1 m long level with the blast, 2 m along the upright, refined along both",
                "every run with the blast and without it; what is reported is the difference"}}}};
}

Section assumptions(const ThesisBlast& blast, const BlastStudy& study) {
  const double arrival = blast_arrival_time(blast);
  return {
      "What it does not say, and what is assumed here",
      {Bullets{
          {"distances of the points: inferred; the predicted times are 1.1 R/c_P of Eq. 11 (3825 m/s, nu = 1/3) with "
           "the R in the tables, to the last digit",
           fmt::format("R of Eq. 18: taken as the width of the octagon, {:.3f} m, so t_a = {:.3f} ms. Chosen because "
                       "the axisymmetric peak at H1 then comes at its printed time; with half of it the first peaks "
                       "of dry joints come 0.4 to 0.6 ms earlier and are a quarter to a third lower",
                       blast.octagon_width(), 1e3 * arrival),
           "the jump of Eq. 18 is a straight line over 20 us",
           "the pressure acts on the wall of an octagonal hole with edges of 1 m; in one run (`element`) on the inner "
           "faces of eight blocks that fill it but for a hollow of half its size, with joints as between all others: "
           "the figure of the element is not in the text",
           "plane stress, as chapter 3 needs it",
           "springs of 10 E at each vertex, shear 0.4 of it (chapter 6, and what chapter 3 needs)",
           "mesh: along each axis blocks of 1 m x 2 m in a strip 14 m wide, blocks of 8 m x 8 m in the four quarters, "
           "four triangles beside the octagon; the row through the blast is 2 m high, the column 1 m wide",
           fmt::format("{} blocks, to 71 m level and 47 m upright, {:g} ms; H5, for which the table has no time, is "
                       "left out",
                       study.blocks, 1e3 * study.duration),
           "small motions; the blast at t = 0 instead of 2 s, because nothing happens before",
           "velocity and stress at the point and of its block; the printed times lie 0.1 ms apart, those here 0.01 "
           "ms"}}}};
}

Section runs(const BlastStudy& study) {
  Section section{"What was run", {}};
  Bullets bullets;
  for (const BlastResult& result : study.results)
    bullets.items.push_back(fmt::format("`{}`: {}", result.name, result.description));
  section.pieces.emplace_back(bullets);
  double largest = 0;
  for (const BlastResult& result : study.results) largest = std::max(largest, result.largest_without);
  section.pieces.emplace_back(
      Paragraph{fmt::format("All but the last were run with the blast and without it, and subtracted. Without it the "
                            "largest velocity is {:g} "
                            "m/s: a model at rest stays at rest here, and there is no background noise to take away.",
                            largest)});
  return section;
}

Section decays(const ThesisBlast& blast, const BlastStudy& study) {
  Table table{"Dry joints; largest stress in MPa, time of the largest velocity in ms after the start of the load",
              {},
              {"t_a, ms", "H1 stress", "V1 stress", "H1 time", "V1 time"},
              {},
              true,
              {1}};
  table.rows.push_back({"thesis", fmt::format("{:.2f}", blast.level_stress / 1e6),
                        fmt::format("{:.2f}", blast.upright_stress / 1e6), "1.96 less the wait", "1.96 less the wait"});
  for (const DecayResult& decay : study.decays)
    table.rows.push_back(
        {fmt::format("{:.3f}", 1e3 * decay.decay_time), fmt::format("{:.2f}", decay.level.peak_stress / 1e6),
         fmt::format("{:.2f}", decay.upright.peak_stress / 1e6), fmt::format("{:.2f}", 1e3 * decay.level.peak_time),
         fmt::format("{:.2f}", 1e3 * decay.upright.peak_time)});
  return {"What t_a changes",
          {Paragraph{
               "The text gives neither t_a nor R. On a smaller mesh (23 m each way), with the load from the start on:"},
           table,
           Paragraph{
               "With a decay of 4 ms both printed stresses are met within 10 %, and H1 and V1 have their peaks at the "
               "same time, as printed; a wait of 1.1 t_a is then too long for these times. Which of the "
               "two the thesis used cannot be told from its text."}}};
}

Section findings(const ThesisBlast& blast, const BlastStudy& study) {
  const double printed = blast.upright_stress / blast.level_stress;
  const auto low = [&](bool level) {
    return 100 * (1 - first_stress(study, "dry", level) / (level ? blast.level_stress : blast.upright_stress));
  };
  return {
      "What follows",
      {Bullets{
          {fmt::format(
               "Printed, the upright stress at 4 m is {:.2f} times the level one at 5 m. In solid rock it can be "
               "{:.2f} "
               "(axisymmetric). With dry joints on this mesh it is {:.2f}: without cohesion and confinement a row of "
               "blocks cannot spread its load, so the face of 1 m drives a column 1 m wide upright, but a row 2 m "
               "high level. If the thesis' mesh is like this one beside the blast (its Figure 4.3 is not in the "
               "text), its large vertical stress is a mark of the mesh.",
               printed, upright_over_level(study, "axisymmetric"), upright_over_level(study, "dry")),
           fmt::format(
               "With this t_a both stresses are below the printed ones, by {:.0f} and {:.0f} %; a slower decay raises "
               "them alike.",
               low(true), low(false)),
           fmt::format(
               "Pressed through the element of eight blocks, rock with dry joints bears {:.2f} and {:.2f} times "
               "the stress at H1 and V1: the element parts along its joints, and each of its blocks hands the "
               "force on its inner face to the rock behind it.",
               first_stress(study, "element", true) / first_stress(study, "dry", true),
               first_stress(study, "element", false) / first_stress(study, "dry", false)),
           "The printed level times are those of a wave in solid rock of plane stress: axisymmetric ones differ by at "
           "most 4 %. With dry joints the peak travels at about the speed of a bar, 3123 m/s, as in a row without "
           "neighbours.",
           "The percentages of Table 4.1 compare peak times with 1.1 R/c_P of plane strain. If the load starts after "
           "1.1 t_a of one R, as here, the wait is the same at all points and does not grow with their distance: it "
           "weighs most near the blast, where the thesis finds errors of 36 and 70 %.",
           fmt::format("Glued with corner springs, blocks carry {:.0f} % of the axisymmetric stress to H1: such joints "
                       "lock, as blocks can only move by f(x) + g(y). With consistent joints they carry {:.0f} %: "
                       "blocks of 1 m x 2 m are coarse beside a hole of 2.4 m and a rise of 20 us. How the error "
                       "falls with the size of blocks is asserted in case 40 of the catalogue.",
                       100 * first_stress(study, "glued", true) / first_stress(study, "axisymmetric", true),
                       100 * first_stress(study, "continuous", true) / first_stress(study, "axisymmetric", true))}}}};
}

}  // namespace

Document blast_report(const ThesisBlast& blast, const BlastStudy& study) {
  Document document;
  document.title = "The blast of chapter 4";
  document.subtitle =
      "R. Zelig, Rockbursts simulations with the numerical DDA method (2015), beside this engine; made by `dda-verify "
      "blast --out DIR` in some five minutes";
  document.sections.push_back(text_says(blast));
  document.sections.push_back(assumptions(blast, study));
  document.sections.push_back(runs(study));
  document.sections.push_back({"Arrival times", {times_table(blast, study), differences_table(study)}});
  document.sections.push_back({"Peaks", {stresses_table(blast, study), velocities_table(study)}});
  if (!study.decays.empty()) document.sections.push_back(decays(blast, study));
  document.sections.push_back(findings(blast, study));
  return document;
}

}  // namespace verify
