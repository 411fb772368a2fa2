#include "verification/thesis/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "verification/thesis/findings.h"
#include "verification/thesis/plots.h"
#include "verification/thesis/report_tables.h"

namespace verify {
namespace {

std::string path_of(std::string_view figure) { return fmt::format("{}/{}", plots_folder, figure); }

double worst(const Calibration& calibration, const std::function<std::optional<double>(const CalibrationRow&)>& value) {
  double most = 0;
  for (const CalibrationRow& row : calibration.rows) most = std::max(most, std::abs(value(row).value_or(0)));
  return most;
}

KeyFigure faithful(const Calibration& calibration) {
  const double most =
      std::max(worst(calibration, [](const CalibrationRow& row) { return row.amplitude_vs_thesis_pct(); }),
               worst(calibration, [](const CalibrationRow& row) { return row.velocity_vs_thesis_pct(); }));
  return {fmt::format("{:.2f} %", most),
          fmt::format("largest difference of the thesis scheme from the {} printed numbers, one configuration",
                      2 * calibration.time_steps.size() * calibration.block_lengths.size())};
}

KeyFigure right(const Calibration& calibration) {
  double most = worst(calibration, [](const CalibrationRow& row) { return row.oracle_max_rel_diff; });
  for (const OracleResult& result : calibration.oracle) most = std::max(most, result.max_rel_diff);
  return {scientific(most), fmt::format("of the peak: largest difference of {} histories from the closed form of the "
                                        "discrete problem",
                                        calibration.rows.size() + calibration.oracle.size())};
}

KeyFigure accurate(const Calibration& calibration, double longest) {
  const double most = worst(calibration, [&](const CalibrationRow& row) -> std::optional<double> {
    if (row.scheme != "accurate" || row.block_length > longest) return std::nullopt;
    return std::max(std::abs(row.amplitude_error_pct()), std::abs(row.correlation_error_pct()));
  });
  return {fmt::format("{:.2f} %", most),
          fmt::format("largest error of the accurate scheme, amplitude or velocity, blocks up to {:g} m", longest)};
}

KeyFigure cheap(const Calibration& calibration) {
  return {fmt::format("{:.2f} ×", calibration.total_cpu("accurate") / calibration.total_cpu("thesis")),
          "CPU time of the accurate scheme over that of the thesis scheme, all rows"};
}

Section what_was_run(const Calibration& calibration) {
  const ThesisBar& bar = calibration.bar;
  return {"What was run",
          {Paragraph{fmt::format(
               "Chapter 3 of R. Zelig's thesis (“Rockbursts simulations with the numerical DDA method”, Ben-Gurion "
               "University, 2015) sends one sine cycle of {:g} Hz and {:g} kN along an elastic bar of {:g} m × {:g} m "
               "(E = {:g} GPa, ρ = {:g} kg/m³, ν = {:g}) that is cut into blocks of 0.5 to 10 m, and reads the stress "
               "σₓ at {:g} m. The same bar is run here in plane stress, without gravity, the load spread over its left "
               "face, with geometry as drawn (displacements stay below 0.3 mm; following them changes σₓ by less than "
               "10⁻⁴ of its peak).",
               bar.load_frequency, bar.load_amplitude / 1e3, bar.length, bar.height, bar.young / 1e9, bar.density,
               bar.poisson, bar.measuring_point)},
           Paragraph{"The thesis does not give the stiffness of the contact springs for this chapter, the plane state, "
                     "the block that stands for 50 m, nor how velocity is picked. One configuration reproduces all of "
                     "its numbers; it is the scheme `thesis`. All schemes have one setting for all rows:"},
           scheme_table()}};
}

Section table_section(const std::string& title, const Table& table, const std::string& figure,
                      const std::string& caption, bool figures) {
  Section section{title, {table}};
  if (figures) section.pieces.emplace_back(Figure{path_of(figure), caption});
  return section;
}

Section history_section(const Calibration& calibration) {
  Section section{"The wave at 50 m", {}};
  std::vector<double> time_steps = calibration.time_steps;
  std::ranges::sort(time_steps, std::greater());  // as the thesis numbers its figures
  for (const double dt : time_steps)
    section.pieces.emplace_back(Figure{
        path_of(history_figure(dt)),
        fmt::format("**Fig. {}** of the thesis: σₓ against time for the five block lengths at Δt = {} ms, tension "
                    "positive, with the analytic solution at 50 m (dashed). Below: what each history is off the "
                    "analytic stress at the place where it is taken, the middle of the block beside 50 m (left) "
                    "or the point itself (right).",
                    figure_number(dt), milliseconds(dt))});
  return section;
}

std::string how_far(const Calibration& calibration) {
  const double dt = calibration.time_steps.front();
  const double length = calibration.block_lengths.back();
  const CalibrationRow& row = calibration.at("accurate", dt, length);
  return fmt::format(
      "How far it got: with blocks of {:g} m, four to a wavelength, the accurate scheme's amplitude is off by {} % and "
      "its correlation velocity by {} % at Δt = {} ms. At 100 Hz itself its phase speed is off by {} %. The rest is of "
      "higher frequencies, and of fourth order in strength at the loaded face (ADR 20).",
      length, signed_pct(row.amplitude_error_pct()), signed_pct(row.correlation_error_pct()), milliseconds(dt),
      signed_pct(phase_speed_error_pct("accurate", dt, length, calibration.bar), 3));
}

Section beyond_section(const Calibration& calibration) {
  return {
      "All schemes",
      {Paragraph{
           "From springs to the accurate scheme in three changes: the integrator (which takes away the damping), "
           "the interface law (which takes away the springs' compliance), and the cubic reconstruction with "
           "the time step's dispersion corrected (which takes away that of the block length). The last "
           "scheme adds lateral inertia: the strip of 1 m then disperses sideways, at low frequencies as Love's bar "
           "does, which elementary bar theory, the reference here, does not know. Its first peak is made by the "
           "load's kinks at some kHz, where blocks of one strain across the strip are no model of it."},
       schemes_error_table(calibration), Paragraph{how_far(calibration)}}};
}

Section cost_section(const Calibration& calibration, const ReportFacts& facts) {
  Section section{"Run time", {}};
  if (facts.figures)
    section.pieces.emplace_back(
        Figure{path_of(cost_figure),
               "**Run time against error**; the blocks of a line run from 10 m (cheap) to 0.5 m (dear). "
               "Filled points: Δt = 0.01 ms, open points: Δt = 0.1 ms. Down and to the left is better. The strip is "
               "left out: what it differs by from bar theory is physics."});
  section.pieces.emplace_back(cpu_table(calibration));
  section.pieces.emplace_back(Paragraph{
      "Runs of the schemes follow each other in turn within one process, so that a busy machine disturbs all alike. "
      "The "
      "thesis scheme judges every joint's strength at every step, as it must; bonded joints leave a scene in which "
      "nothing can change, and a step is then two products with constant matrices and one solve."});
  return section;
}

Section oracle_section(const Calibration& calibration) {
  return {"Against the closed form of the discrete problem",
          {Paragraph{"A chain of equal blocks under a one-step integrator has an exact solution: waves of the "
                     "homogeneous chain from both ends for every z, and an inverse z-transform. It is coded without "
                     "any part of the engine. An engine that solves the equations it claims to solve agrees with it to "
                     "round-off, which is a far sharper statement than being within 2 % of the wave equation."},
           oracle_table(calibration)}};
}

}  // namespace

Document calibration_report(const Calibration& calibration, const std::vector<Promise>& promises,
                            const ReportFacts& facts) {
  Document report;
  report.title = "P wave in a bar of blocks: the thesis’ calibration, reproduced, checked and improved";
  report.subtitle =
      "Tables 3.2 and 3.3 of Zelig (2015) from this engine, beside the printed numbers, beside its accurate scheme, "
      "beside the closed form of the discrete problem.";
  report.key_figures = {faithful(calibration), right(calibration), accurate(calibration, 1), accurate(calibration, 5),
                        cheap(calibration)};
  report.sections = {
      what_was_run(calibration),
      table_section(
          "Stress amplitude", amplitude_table(calibration), amplitude_figure,
          "**Fig. 3.4** of the thesis: magnitude of the amplitude error against η = Δx/λ. Logarithmic, so that "
          "both schemes can be seen; where an error changes sign it dips, as the thesis scheme's at 2 m.",
          facts.figures),
      table_section("Wave velocity", velocity_table(calibration), velocity_figure,
                    "**Fig. 3.5** of the thesis: magnitude of the velocity error against η. The onset is what the "
                    "thesis picked; the correlation is what a whole pulse does.",
                    facts.figures)};
  if (facts.figures) report.sections.push_back(history_section(calibration));
  report.sections.push_back(findings(calibration));
  report.sections.push_back(beyond_section(calibration));
  report.sections.push_back(cost_section(calibration, facts));
  report.sections.push_back(oracle_section(calibration));
  report.sections.push_back(
      {"How each quantity is read", {readings_table(calibration), other_readings_table(calibration)}});
  report.sections.push_back({"What was promised", {promises_table(promises)}});
  report.sections.push_back({"Counters", {counters_table(calibration)}});
  report.footer = fmt::format("Made by `{}` in {:.1f} s of CPU time. Numbers in full: `calibration.json`.",
                              facts.command_line, facts.total_cpu_s);
  return report;
}

}  // namespace verify
