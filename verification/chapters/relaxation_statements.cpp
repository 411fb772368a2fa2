// What section 6.1 says, judged in every reading.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "verification/chapters/chapter_figures.h"
#include "verification/chapters/linear_fit.h"
#include "verification/chapters/strain_relaxation.h"

namespace verify {
namespace {

using Outcome = RelaxationOutcome;
using Quantity = double Outcome::*;
using Test = std::function<Reading(const std::vector<Outcome>&)>;

// Nothing else moves on for long at the end of a run but what falls or is thrown out: half of the speed of free fall
// tells the two apart, as blocks that are held only drift with the rock, by millimetres a second.
constexpr double moving_on = 0.5;

bool roof_falls(const Outcome& o) { return o.roof_end_speed > moving_on * o.free_fall_speed; }
bool wall_moves_on(const Outcome& o) { return o.wall_end_speed > moving_on * o.free_fall_speed; }

std::vector<double> values(const std::vector<Outcome>& outcomes, Quantity quantity) {
  std::vector<double> all;
  for (const Outcome& outcome : outcomes) all.push_back(outcome.*quantity);
  return all;
}

std::string listed(const std::vector<double>& all, double unit, const char* name) {
  std::string text;
  for (const double value : all) text += fmt::format("{}{:.3g}", text.empty() ? "" : ", ", value / unit);
  return fmt::format("{} {}", text, name);
}

std::vector<Reading> readings(const std::vector<RelaxationResult>& results, const Test& test) {
  std::vector<Reading> all;
  for (const RelaxationResult& result : results) {
    Reading reading{"", std::nullopt, result.missing};
    if (result.missing.empty()) reading = test(result.outcomes);
    reading.name = result.reading.name;
    all.push_back(std::move(reading));
  }
  return all;
}

Statement open_statement(const char* id, const char* statement, const char* thesis, const std::string& reason) {
  return {6, id, statement, std::string(thesis), std::string(), "", std::nullopt, reason};
}

const std::string speed_rule =
    "A block falls or goes on moving if its mean speed in the last fifth of the run is more than half of that of free "
    "fall by the same steps and damping; what is held moves by millimetres a second.";

Statement wall_stays(const std::vector<RelaxationResult>& results) {
  return judged_over(open_statement("6.1-block-1-stays", "Key block 1 is stable without initial stress",
                                    "friction 65 deg exceeds the dip of its joint, 60 deg", speed_rule),
                     readings(results, [](const auto& o) {
                       return Reading{"", !wall_moves_on(o.front()),
                                      fmt::format("{:.2g} m/s at the end, free fall {:.2g}", o.front().wall_end_speed,
                                                  o.front().free_fall_speed)};
                     }));
}

Statement roof_falls_unstressed(const std::vector<RelaxationResult>& results) {
  return judged_over(open_statement("6.1-block-2-falls", "Roof block 2 falls without initial stress",
                                    "failed in falling mode", speed_rule),
                     readings(results, [](const auto& o) {
                       return Reading{"", roof_falls(o.front()),
                                      fmt::format("{:.2g} m/s downwards at the end, free fall {:.2g}",
                                                  o.front().roof_end_speed, o.front().free_fall_speed)};
                     }));
}

Statement roof_stays_stressed(const std::vector<RelaxationResult>& results) {
  return judged_over(open_statement("6.1-block-2-stays", "Roof block 2 stays in place at 10, 30 and 50 MPa",
                                    "mostly stable", speed_rule),
                     readings(results, [](const auto& o) {
                       const std::vector<Outcome> stressed(o.begin() + 1, o.end());
                       return Reading{
                           "", std::ranges::none_of(stressed, roof_falls),
                           listed(values(stressed, &Outcome::roof_end_speed), 1, "m/s downwards at the end")};
                     }));
}

Statement ejected_from_10(const std::vector<RelaxationResult>& results) {
  return judged_over(open_statement("6.1-threshold", "Key block 1 is ejected into the tunnel from about 10 MPa on",
                                    "10 MPa seems to be a lower threshold",
                                    speed_rule + " It must go on moving at 10, 30 and 50 MPa and not without stress."),
                     readings(results, [](const auto& o) {
                       return Reading{
                           "", !wall_moves_on(o.front()) && std::ranges::all_of(o.begin() + 1, o.end(), wall_moves_on),
                           listed(values(o, &Outcome::wall_end_speed), 1, "m/s at the end")};
                     }));
}

Statement rises(const std::vector<RelaxationResult>& results, const char* id, const char* statement, Quantity quantity,
                double unit, const char* name) {
  return judged_over(open_statement(id, statement, "rises with each stress",
                                    "The largest value of a run must rise from each stress to the next one."),
                     readings(results, [&](const auto& o) {
                       const std::vector<double> all = values(o, quantity);
                       return Reading{"", std::ranges::is_sorted(all, std::less_equal<>()), listed(all, unit, name)};
                     }));
}

Statement linear(const std::vector<RelaxationResult>& results, const char* id, const char* statement, Quantity quantity,
                 const char* name) {
  constexpr double least = 0.95;
  return judged_over(
      open_statement(id, statement, "a linear trend",
                     "The straight line fitted to the four stresses must explain 95 % of the variance and rise: "
                     "of a value that grows with the root of the stress it explains 92 %, with its square 93 %."),
      readings(results, [&](const auto& o) {
        const std::vector<double> all = values(o, quantity);
        const LinearFit fit = fit_line(relaxation_stresses(), all);
        return Reading{"", fit.slope > 0 && fit.explained >= least,
                       fmt::format("R2 {:.4f}; {}", fit.explained, listed(all, 1, name))};
      }));
}

Statement near_above_far(const std::vector<RelaxationResult>& results) {
  return judged_over(
      open_statement("6.1-wall-above-far", "Point 3 at the wall responds more than point 5, 20 m away, at every stress",
                     "more powerful at every stress",
                     "Largest change of sigma_x or sigma_y since the tunnel was opened."),
      readings(results, [](const auto& o) {
        return Reading{"", std::ranges::all_of(o, [](const Outcome& x) { return x.near_response > x.far_response; }),
                       listed(values(o, &Outcome::near_response), 1e6, "MPa at point 3, ") +
                           listed(values(o, &Outcome::far_response), 1e6, "MPa at point 5")};
      }));
}

Table figures(const std::vector<RelaxationResult>& results) {
  Table table{"Each reading at 0, 10, 30 and 50 MPa",
              {},
              {"reading", "block 1, peak velocity, m/s", "peak acceleration, m/s2", "displacement, mm",
               "speed at the end, mm/s", "block 2, speed down at the end, mm/s", "point 3, MPa", "point 5, MPa"},
              {},
              true,
              {}};
  const auto cell = [](const RelaxationResult& r, Quantity q, double unit) {
    return listed(values(r.outcomes, q), unit, "");
  };
  for (const RelaxationResult& r : results)
    table.rows.push_back({r.reading.name, cell(r, &Outcome::wall_peak_velocity, 1),
                          cell(r, &Outcome::wall_peak_acceleration, 1), cell(r, &Outcome::wall_displacement, 1e-3),
                          cell(r, &Outcome::wall_end_speed, 1e-3), cell(r, &Outcome::roof_end_speed, 1e-3),
                          cell(r, &Outcome::near_response, 1e6), cell(r, &Outcome::far_response, 1e6)});
  return table;
}

// A line a reading; those with a failed run have none.
dda::LinePlot over_stress(const std::vector<RelaxationResult>& results, Quantity quantity, const char* title,
                          const char* unit) {
  dda::LinePlot plot;
  plot.title = title;
  plot.unit = unit;
  plot.times = relaxation_stresses();
  plot.across = "initial stress";
  plot.across_unit = "Pa";
  for (const RelaxationResult& r : results)
    if (r.outcomes.size() == plot.times.size()) plot.lines.push_back({r.reading.name, values(r.outcomes, quantity)});
  return plot;
}

void add_figures(const std::vector<RelaxationResult>& results, Section& section, Chapter& chapter) {
  add_figure("6_1_velocity", "Peak velocity of key block 1 over the initial stress, a line a reading",
             over_stress(results, &Outcome::wall_peak_velocity, "peak velocity of key block 1", "m/s"), section,
             chapter);
  add_figure("6_1_acceleration", "Peak acceleration of key block 1 over the initial stress, a line a reading",
             over_stress(results, &Outcome::wall_peak_acceleration, "peak acceleration of key block 1", "m/s2"),
             section, chapter);
}

Bullets described(const std::vector<RelaxationResult>& results) {
  Bullets bullets;
  for (const RelaxationResult& r : results)
    bullets.items.push_back(
        fmt::format("`{}`: {}{}", r.reading.name, r.reading.difference, r.missing.empty() ? "" : " - " + r.missing));
  return bullets;
}

}  // namespace

void judge_relaxation(const std::vector<RelaxationResult>& results, Chapter& chapter) {
  for (Statement& statement : std::vector<Statement>{
           wall_stays(results), roof_falls_unstressed(results), roof_stays_stressed(results),
           rises(results, "6.1-velocity-rises", "Velocity of key block 1 rises with the initial stress",
                 &Outcome::wall_peak_velocity, 1, "m/s"),
           rises(results, "6.1-acceleration-rises", "Acceleration of key block 1 rises with the initial stress",
                 &Outcome::wall_peak_acceleration, 1, "m/s2"),
           rises(results, "6.1-displacement-rises", "Displacement of key block 1 rises with the initial stress",
                 &Outcome::wall_displacement, 1e-3, "mm"),
           linear(results, "6.1-velocity-linear", "Peak velocity of key block 1 follows a linear trend with the stress",
                  &Outcome::wall_peak_velocity, "m/s"),
           linear(results, "6.1-acceleration-linear",
                  "Peak acceleration of key block 1 follows a linear trend with the stress",
                  &Outcome::wall_peak_acceleration, "m/s2"),
           ejected_from_10(results), near_above_far(results),
           rises(results, "6.1-wall-response-rises", "The response at the wall grows with the initial stress",
                 &Outcome::near_response, 1e6, "MPa"),
           rises(results, "6.1-far-response-rises", "The response 20 m away grows with the initial stress",
                 &Outcome::far_response, 1e6, "MPa")})
    chapter.statements.push_back(std::move(statement));
  for (const char* text :
       {"6.1: the second joint set, spacings, offsets, domain, time steps and durations are not given and are varied: "
        "the readings below",
        "6.1: classical springs of 10 E, shear 0.4 of it, in all readings; plane stress as in chapter 3",
        "6.1: the rock settles under weight and stress to equilibrium in place of 2.5 s, without sliding; its edges "
        "are held "
        "level meanwhile and let go with their forces, so that viscous edges carry the static stress",
        "6.1: key blocks are the largest ones that block theory finds at the left wall (held by friction) and in the "
        "roof "
        "(falling)",
        "6.1: point 3 lies 0.3 m inside the right wall, point 5 20 m from the wall"})
    chapter.assumptions.emplace_back(text);
  Section section{"6.1, readings", {described(results), figures(results)}};
  add_figures(results, section, chapter);
  chapter.sections.push_back(std::move(section));
}

}  // namespace verify
