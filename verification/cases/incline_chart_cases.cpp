#include "verification/cases/incline_chart_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "verification/cases/contact_rig.h"
#include "verification/exact/block_on_incline.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double nearest = 0.1 * degree;  // cells nearer to a boundary along either axis are not judged
constexpr double largest_friction = 50;   // deg
constexpr double largest_slope = 60;      // deg
constexpr double step_size = 1e-3;        // s
constexpr double watched = 0.05;          // s: long enough for springs to settle, short enough to be the start

// What 0.1 deg beyond a boundary makes a block slide (g 0.1 deg) and topple ((3/2) g 0.1 deg/diagonal). A block is said
// to do what it does at a third of that.
double least_sliding() { return standard_gravity * nearest / 3; }
double least_toppling(const exact::InclinedBlock& block) {
  return 1.5 * standard_gravity * nearest / std::hypot(block.width, block.height) / 3;
}

// A level floor with gravity turned, and the block on it, its lower right corner the toe.
dda::Model model_of(const exact::InclinedBlock& block) {
  dda::Model model;
  model.materials = {{"rock", 2600, 50e9, 0.2, dda::PlaneState::stress}};
  model.joints = {dry_joint(block.friction)};
  model.gravity = standard_gravity * dda::Vec2(std::sin(block.slope), -std::cos(block.slope));
  add_box(model, -2, -1, 4, 0);
  hold_corners(model, 0);
  add_box(model, 0, 0, block.width, block.height);
  // One static step gives the contacts the forces with which the motion starts.
  model.stages = {moving_stage(dda::static_integrator(), step_size, step_size),
                  moving_stage(dda::generalized_alpha_integrator(0), step_size, watched)};
  return model;
}

// Energies of all cells together, J per m of thickness.
struct Balance {
  double residual = 0;
  double scale = 0;
};

// What the engine's block does from where the static step has put it.
struct Watched {
  exact::InclineMotion mean;  // accelerations that make the way and the turn of the whole time
  double later_sliding = 0;   // m/s2, mean of the second half, when the springs have settled
};

Watched watch(const exact::InclinedBlock& block, Outcome& outcome, Balance& balance) {
  WatchedRun run(model_of(block));
  const dda::Vec2 toe(block.width, 0);
  const auto place = [&] { return dda::point_displacement(run.simulation().model(), run.state(), 1, toe).x(); };
  const auto speed = [&] { return dda::point_velocity(run.simulation().model(), run.state(), 1, toe).x(); };
  run.step();
  const double place_before = place();
  const double turn_before = run.state().displacement[1](2);
  run.run_to(step_size + watched / 2);
  const double speed_before = speed();
  run.run_to_end();
  const double scale = run.simulation().energy().scale();
  balance.residual += run.energy_residual() * scale;
  balance.scale += scale;
  outcome.counters += run.simulation().counters();
  constexpr double half_time_squared = watched * watched / 2;
  return {{(place() - place_before) / half_time_squared,
           (turn_before - run.state().displacement[1](2)) / half_time_squared},
          (speed() - speed_before) / (watched / 2)};
}

// ---- The chart of one width over height.

int region_of(bool slides, bool topples) { return (slides ? 1 : 0) + (topples ? 2 : 0); }
constexpr std::array region_names{"stable", "slides", "topples", "slides and topples"};

struct Chart {
  std::array<int, 4> cells{};
  std::array<int, 4> wrong{};
  double worst_slide = 0;  // largest error of the acceleration of blocks that only slide, m/s2
};

void judge(const exact::InclinedBlock& block, Chart& chart, Outcome& outcome, Balance& balance) {
  if (block.slope < 0 || block.friction < 0 || block.friction > largest_friction * degree) return;
  if (!exact::is_clear_of_boundaries(block, nearest)) return;
  const exact::InclineMotion expected = exact::initial_motion(block, standard_gravity);
  const Watched got = watch(block, outcome, balance);
  const int region = region_of(expected.slides(), expected.topples());
  const int judged = region_of(got.mean.sliding > least_sliding(), got.mean.toppling > least_toppling(block));
  ++chart.cells[static_cast<std::size_t>(region)];
  if (judged != region) ++chart.wrong[static_cast<std::size_t>(region)];
  if (region == 1) chart.worst_slide = std::max(chart.worst_slide, std::abs(got.later_sliding - expected.sliding));
}

void report(double foot, const Chart& chart, Outcome& outcome) {
  for (std::size_t region = 0; region < region_names.size(); ++region) {
    outcome.assertions.push_back(
        expect(fmt::format("cells misjudged, b/h = {}, {} cells of \"{}\"", foot, chart.cells[region],
                           region_names[region]),
               "-")
            .is(static_cast<double>(chart.wrong[region]))
            .against(0,
                     "equations of motion of a rigid block from rest (exact/block_on_incline): Voegele 1979, Sagaseta "
                     "1986 (error "
                     "absolute)")
            .off_by(chart.cells[region] > 0 ? chart.wrong[region] : std::numeric_limits<double>::quiet_NaN())
            .within(0, "target of the project: every cell outside 0.1 deg"));
  }
  outcome.assertions.push_back(
      expect(fmt::format("acceleration of sliding, largest error, b/h = {}", foot), "m/s2")
          .is(chart.worst_slide)
          .against(0, "g (sin a - cos a tan f) (error absolute)")
          .absolutely()
          .within(1e-7, "round-off of speeds over 25 ms, and what still rings next to toppling: measured 1e-8"));
}

// Cells every `spacing` degrees.
Outcome grid() {
  constexpr double spacing = 1;
  Outcome outcome;
  Balance balance;
  for (const double foot : {0.3, 0.6, 1.0}) {
    Chart chart;
    for (double slope = spacing / 2; slope < largest_slope; slope += spacing)
      for (double friction = spacing / 2; friction < largest_friction; friction += spacing)
        judge({foot, 1, slope * degree, friction * degree}, chart, outcome, balance);
    report(foot, chart, outcome);
  }
  outcome.assertions.push_back(energy_assertion("all cells together", balance.residual / balance.scale));
  return outcome;
}

// ---- Cells on both sides of every boundary.

int exact_region(const exact::InclinedBlock& block) {
  const exact::InclineMotion motion = exact::initial_motion(block, 1);
  return region_of(motion.slides(), motion.topples());
}

// Judges the cells 0.1 deg to either side of every boundary along the line of blocks at(angle), angle in rad up to
// `end`.
template <typename At>
void judge_crossings(const At& at, double end, Chart& chart, Outcome& outcome, Balance& balance) {
  constexpr double stride = 0.25 * degree;
  for (double angle = stride; angle + stride < end; angle += stride) {
    const int here = exact_region(at(angle));
    if (here == exact_region(at(angle + stride))) continue;
    double low = angle;
    double high = angle + stride;
    while (high - low > 1e-12) {
      const double middle = (low + high) / 2;
      (exact_region(at(middle)) == here ? low : high) = middle;
    }
    for (const double side : {-1.01, 1.01}) judge(at(low + side * nearest), chart, outcome, balance);
  }
}

Outcome boundaries() {
  constexpr double spacing = 1;
  Outcome outcome;
  Balance balance;
  for (const double foot : {0.3, 0.6, 1.0}) {
    Chart chart;
    for (double given = spacing / 2; given < largest_slope; given += spacing) {
      const auto along_friction = [&](double friction) {
        return exact::InclinedBlock{foot, 1, given * degree, friction};
      };
      const auto along_slope = [&](double slope) { return exact::InclinedBlock{foot, 1, slope, given * degree}; };
      judge_crossings(along_friction, largest_friction * degree, chart, outcome, balance);
      judge_crossings(along_slope, largest_slope * degree, chart, outcome, balance);
    }
    report(foot, chart, outcome);
  }
  outcome.assertions.push_back(energy_assertion("all cells together", balance.residual / balance.scale));
  return outcome;
}

}  // namespace

std::vector<Case> incline_chart_cases() {
  return {{"incline-chart",
           "Block on an incline: what it does over the chart of slope and friction angle",
           {17},
           CaseLabel::slow,
           grid},
          {"incline-chart-boundaries",
           "Block on an incline: what it does 0.1 deg to either side of every boundary",
           {17},
           CaseLabel::fast,
           boundaries}};
}

}  // namespace verify
