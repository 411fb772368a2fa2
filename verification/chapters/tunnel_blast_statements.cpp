// What section 6.2 says, judged in every reading and, where it speaks of all of them, at every friction and stress.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <utility>

#include "verification/chapters/chapter_figures.h"
#include "verification/chapters/linear_fit.h"
#include "verification/chapters/tunnel_blast.h"

namespace verify {
namespace {

using Outcome = TunnelBlastOutcome;
using Outcomes = std::vector<Outcome>;

constexpr double moving_on = 0.5;  // of free fall, as in 6.1

bool roof_falls(const Outcome& o) { return o.roof_end_speed > moving_on * o.free_fall_speed; }

Outcomes under(const TunnelBlastResult& result, double stress) {
  Outcomes all;
  for (const Outcome& o : result.outcomes)
    if (o.stress == stress) all.push_back(o);
  return all;
}

bool complete(const Outcomes& outcomes) { return outcomes.size() == blast_frictions().size(); }

// 0 to 3 for points 1 to 4.
std::size_t fastest(const Outcome& o) {
  return static_cast<std::size_t>(std::ranges::max_element(o.velocity) - o.velocity.begin());
}

std::string place(const TunnelBlastResult& result, const Outcome& o) {
  return fmt::format("{}, {:g} deg, {:g} MPa", result.reading.name, o.friction, o.stress / 1e6);
}

Statement open_statement(const char* id, const char* statement, const char* thesis, const std::string& reason) {
  return {6, id, statement, std::string(thesis), std::string(), "", std::nullopt, reason};
}

// A reading for each reading and stress whose frictions are complete.
std::vector<Reading> by_stress(const std::vector<TunnelBlastResult>& results, const std::vector<double>& stresses,
                               const std::function<Reading(const Outcomes&)>& judge) {
  std::vector<Reading> all;
  for (const TunnelBlastResult& result : results)
    for (const double stress : stresses) {
      const Outcomes outcomes = under(result, stress);
      Reading reading{"", std::nullopt, "a run failed"};
      if (complete(outcomes)) reading = judge(outcomes);
      reading.name = fmt::format("{}, {:g} MPa", result.reading.name, stress / 1e6);
      all.push_back(std::move(reading));
    }
  return all;
}

// A reading for each run with its pair at the other stress.
std::vector<Reading> by_friction(const std::vector<TunnelBlastResult>& results,
                                 const std::function<Reading(const Outcome& free, const Outcome& stressed)>& judge) {
  std::vector<Reading> all;
  for (const TunnelBlastResult& result : results)
    for (const Outcome& free : under(result, 0))
      for (const Outcome& stressed : under(result, blast_stresses().back()))
        if (free.friction == stressed.friction) {
          all.push_back(judge(free, stressed));
          all.back().name = fmt::format("{}, {:g} deg", result.reading.name, free.friction);
        }
  return all;
}

std::vector<Reading> by_run(const std::vector<TunnelBlastResult>& results,
                            const std::function<Reading(const Outcome&)>& judge) {
  std::vector<Reading> all;
  for (const TunnelBlastResult& result : results)
    for (const Outcome& outcome : result.outcomes) {
      all.push_back(judge(outcome));
      all.back().name = place(result, outcome);
    }
  return all;
}

Statement collapse(const std::vector<TunnelBlastResult>& results) {
  return judged_over(
      open_statement(
          "6.2-collapse", "The roof collapses without friction and with no other angle", "only at 0 deg",
          "The roof collapses if point 2 moves downwards in the last fifth of the run, with the blast, at more "
          "than half of the speed of free fall since the tunnel was opened."),
      by_stress(results, blast_stresses(), [](const Outcomes& all) {
        std::string falls;
        for (const Outcome& o : all)
          if (roof_falls(o)) falls += fmt::format("{}{:g}", falls.empty() ? "" : ", ", o.friction);
        const bool others = std::any_of(all.begin() + 1, all.end(), roof_falls);
        return Reading{"", roof_falls(all.front()) && !others, falls.empty() ? "at none" : "at " + falls + " deg"};
      }));
}

Statement stronger_without_stress(const std::vector<TunnelBlastResult>& results) {
  return judged_over(
      open_statement("6.2-stress",
                     "The stress that the blast brings to points 5 and 6 is higher without initial stress", "higher",
                     "Largest change of sigma_x or sigma_y by the blast, at both points, for every friction."),
      by_friction(results, [](const Outcome& free, const Outcome& stressed) {
        return Reading{"", free.stress_5 > stressed.stress_5 && free.stress_6 > stressed.stress_6,
                       fmt::format("{:.3g} and {:.3g} MPa without, {:.3g} and {:.3g} with", free.stress_5 / 1e6,
                                   free.stress_6 / 1e6, stressed.stress_5 / 1e6, stressed.stress_6 / 1e6)};
      }));
}

Statement nearer_point(const std::vector<TunnelBlastResult>& results) {
  return judged_over(
      open_statement(
          "6.2-distance", "Point 6, nearer to the blast, responds more than point 5", "much higher at point 6",
          "Largest change of sigma_x or sigma_y by the blast. Point 6 lies 4.2 m from the centre of the blast, "
          "point 5 7.8 m."),
      by_run(results, [](const Outcome& o) {
        return Reading{"", o.stress_6 > o.stress_5,
                       fmt::format("{:.3g} MPa at 6, {:.3g} at 5", o.stress_6 / 1e6, o.stress_5 / 1e6)};
      }));
}

Statement falls_with_friction(const std::vector<TunnelBlastResult>& results, bool velocity) {
  return judged_over(
      open_statement(velocity ? "6.2-velocity-friction" : "6.2-acceleration-friction",
                     velocity ? "Peak velocity of key block 1 falls with growing friction"
                              : "Peak acceleration of key block 1 falls with growing friction",
                     "falls",
                     "Of point 1: the straight line fitted over the six angles must fall, and the value at 45 deg "
                     "be below that at 0."),
      by_stress(results, blast_stresses(), [&](const Outcomes& all) {
        std::vector<double> values;
        std::string text;
        for (const Outcome& o : all) {
          values.push_back(velocity ? o.velocity[0] : o.acceleration[0]);
          text += fmt::format("{}{:.3g}", text.empty() ? "" : ", ", values.back());
        }
        return Reading{"", fit_line(blast_frictions(), values).slope < 0 && values.back() < values.front(),
                       text + (velocity ? " m/s" : " m/s2")};
      }));
}

Statement wall_is_fastest(const std::vector<TunnelBlastResult>& results) {
  std::vector<Reading> readings;
  for (const Reading& reading : by_friction(results, [](const Outcome&free, const Outcome&) {
         return Reading{
             "", fastest(free) == 0,
             fmt::format("largest at point {}, {:.3g} m/s", fastest(free) + 1, free.velocity[fastest(free)])};
       }))
    readings.push_back(reading);
  return judged_over(
      open_statement("6.2-wall", "Without initial stress point 1 has the largest peak velocity around the tunnel",
                     "at every friction", "Points 1 to 4, by the blast alone."),
      readings);
}

Statement roof_is_fastest(const std::vector<TunnelBlastResult>& results) {
  return judged_over(open_statement("6.2-roof", "Under 50 MPa point 2 has the largest peak velocity around the tunnel",
                                    "for most angles of friction",
                                    "Points 1 to 4, by the blast alone; most: more than half of the angles."),
                     by_stress(results, {blast_stresses().back()}, [](const Outcomes& all) {
                       const auto roof = std::ranges::count_if(all, [](const Outcome& o) { return fastest(o) == 1; });
                       return Reading{"", 2 * roof > static_cast<long>(all.size()),
                                      fmt::format("for {} of {} angles", roof, all.size())};
                     }));
}

Statement walls_slower_under_stress(const std::vector<TunnelBlastResult>& results) {
  return judged_over(
      open_statement("6.2-walls", "The response of the sidewalls to the blast is greater without initial stress",
                     "greater", "Peak velocities of points 1 and 3, both, for every friction."),
      by_friction(results, [](const Outcome& free, const Outcome& stressed) {
        return Reading{"", free.velocity[0] > stressed.velocity[0] && free.velocity[2] > stressed.velocity[2],
                       fmt::format("{:.3g} and {:.3g} m/s without, {:.3g} and {:.3g} with", free.velocity[0],
                                   free.velocity[2], stressed.velocity[0], stressed.velocity[2])};
      }));
}

Table figures(const TunnelBlastResult& result) {
  Table table{fmt::format("`{}`: {}", result.reading.name, result.reading.difference),
              {},
              {"friction, in situ", "velocity of points 1, 2, 3, 4, m/s", "acceleration, m/s2", "stress at 5, 6, MPa",
               "roof at the end, free fall, m/s"},
              {},
              true,
              {}};
  for (const Outcome& o : result.outcomes)
    table.rows.push_back(
        {fmt::format("{:g} deg, {:g} MPa", o.friction, o.stress / 1e6),
         fmt::format("{:.3g}, {:.3g}, {:.3g}, {:.3g}", o.velocity[0], o.velocity[1], o.velocity[2], o.velocity[3]),
         fmt::format("{:.3g}, {:.3g}, {:.3g}, {:.3g}", o.acceleration[0], o.acceleration[1], o.acceleration[2],
                     o.acceleration[3]),
         fmt::format("{:.3g}, {:.3g}", o.stress_5 / 1e6, o.stress_6 / 1e6),
         fmt::format("{:.3g}, {:.3g}", o.roof_end_speed, o.free_fall_speed)});
  return table;
}

using PeakValues = std::array<double, 4> Outcome::*;

// A line for each of the points 1 to 4 and each stress; those with a failed run have none.
dda::LinePlot over_friction(const TunnelBlastResult& result, PeakValues peaks, const char* title, const char* unit) {
  dda::LinePlot plot;
  plot.title = title;
  plot.unit = unit;
  plot.times = blast_frictions();
  plot.across = "friction angle";
  plot.across_unit = "deg";
  for (const double stress : blast_stresses())
    for (std::size_t point = 0; point < 4; ++point) {
      dda::PlottedLine line{fmt::format("point {}, {:g} MPa", point + 1, stress / 1e6), {}};
      for (const Outcome& o : result.outcomes)
        if (o.stress == stress) line.values.push_back((o.*peaks)[point]);
      if (line.values.size() == plot.times.size()) plot.lines.push_back(std::move(line));
    }
  return plot;
}

void add_figures(const TunnelBlastResult& result, Section& section, Chapter& chapter) {
  const std::string& name = result.reading.name;
  add_figure("6_2_velocity_" + name, fmt::format("`{}`: peak velocities over the friction of the joints", name),
             over_friction(result, &Outcome::velocity, "peak velocity", "m/s"), section, chapter);
  add_figure("6_2_acceleration_" + name, fmt::format("`{}`: peak accelerations over the friction of the joints", name),
             over_friction(result, &Outcome::acceleration, "peak acceleration", "m/s2"), section, chapter);
}

}  // namespace

void judge_tunnel_blast(const std::vector<TunnelBlastResult>& results, Chapter& chapter) {
  for (Statement& statement :
       std::vector<Statement>{collapse(results), stronger_without_stress(results), nearer_point(results),
                              falls_with_friction(results, true), falls_with_friction(results, false),
                              wall_is_fastest(results), roof_is_fastest(results), walls_slower_under_stress(results)})
    chapter.statements.push_back(std::move(statement));
  for (const char* text :
       {"6.2: joints, their spacing, distances, domain and time step are not given: the joints are varied, the blast's "
        "centre lies "
        "20 m from the tunnel's in rock of 54 m x 36 m, with steps of 40 us",
        "6.2: the blast is the pressure 60 MPa of Eq. 18 (10 MPa in chapter 4 for 10,000 kN) on the wall of an "
        "octagonal hole with "
        "edges of 1 m, risen in 0.2 ms, t_a = 0.729 ms as in chapter 4; the hole carries the in-situ stress by a "
        "pressure",
        "6.2: the tunnel is opened at once after settling, 80 ms before the blast; the blast is watched for 24 ms",
        "6.2: points 1 to 4 lie 0.3 m inside walls, roof and floor; key block 1 is the block of point 1"})
    chapter.assumptions.emplace_back(text);
  Section section{"6.2, runs with the blast less those without", {}};
  for (const TunnelBlastResult& result : results) {
    section.pieces.emplace_back(figures(result));
    add_figures(result, section, chapter);
  }
  chapter.sections.push_back(std::move(section));
}

}  // namespace verify
