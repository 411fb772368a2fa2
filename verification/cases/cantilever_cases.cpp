#include "verification/cases/cantilever_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "verification/cases/bonded_beam.h"
#include "verification/cases/contact_rig.h"
#include "verification/harness/recorded_run.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

constexpr double load = 1e3;  // N per m of thickness

exact::Cantilever beam_of(double slenderness, double poisson) { return {slenderness, 1, 1e9, poisson, 2000}; }

// Columns by rows of equal rectangular blocks with the axis of the beam at y = 0.
struct Grid {
  exact::Cantilever beam;
  int columns = 0;
  int rows = 0;

  [[nodiscard]] double block_length() const { return beam.length / columns; }
  [[nodiscard]] double block_height() const { return beam.height / rows; }
  [[nodiscard]] int block(int column, int row) const { return row * columns + column; }
  [[nodiscard]] double bottom(int row) const { return -beam.height / 2 + row * block_height(); }
};

// Blocks `shape` times as long as high.
Grid grid_of(const exact::Cantilever& beam, int rows, double shape = 1) {
  return {beam, static_cast<int>(std::lround(beam.length / beam.height * rows / shape)), rows};
}

std::vector<dda::Ring> rectangles(const Grid& grid) {
  std::vector<dda::Ring> rings;
  for (int row = 0; row < grid.rows; ++row) {
    const double bottom = grid.bottom(row);
    const double top = bottom + grid.block_height();
    for (int column = 0; column < grid.columns; ++column) {
      const double left = column * grid.block_length();
      const double right = left + grid.block_length();
      rings.push_back({{left, bottom}, {right, bottom}, {right, top}, {left, top}});
    }
  }
  return rings;
}

dda::Model bonded_blocks(const Grid& grid) {
  const exact::Cantilever& beam = grid.beam;
  return bonded_beam(rectangles(grid), {"rock", beam.density, beam.young, beam.poisson, dda::PlaneState::stress});
}

// Springs of 3,000 E in all along the left end: stiffer ones cost digits of the energy balance, softer ones frequency
// (0.02 % here).
void clamp(const Grid& grid, dda::Model& model) {
  const double stiffness = 3e3 * grid.beam.young / (2 * grid.rows);
  for (int row = 0; row < grid.rows; ++row)
    for (const double y : {grid.bottom(row), grid.bottom(row) + grid.block_height()})
      model.supports.push_back({grid.block(0, row), {0, y}, true, true, stiffness, dda::Vec2::Zero(), {}});
}

// ---- Deflection under the tractions of two-dimensional elasticity at both ends.

double end_loaded_deflection(const Grid& grid, Outcome& outcome) {
  dda::Model model = bonded_blocks(grid);
  load_free_end(grid.beam, load, model);
  load_held_end(grid.beam, load, model);
  keep_in_place(grid.beam, model);
  return working_deflection(std::move(model), load, outcome);
}

void add_deflection(double poisson, double shape, double tolerance, Outcome& outcome) {
  const exact::Cantilever beam = beam_of(8, poisson);
  const double expected = exact::deflection_with_shear(beam, load);
  const auto error = [&](int rows) {
    return relative_error(end_loaded_deflection(grid_of(beam, rows, shape), outcome), expected);
  };
  const double coarse = error(8);
  const double fine = error(16);
  outcome.assertions.push_back(
      expect(fmt::format("working deflection, 16 blocks across, {} times as long as high, nu = {}", shape, poisson),
             "m")
          .is(expected * (1 + fine))
          .against(expected,
                   "P L^3/(3 E I) + 1.2 P L/(G A): exact for end tractions P (L - x) y/I, P/(2 I) (h^2/4 - y^2) "
                   "(Timoshenko and "
                   "Goodier)")
          .off_by(fine)
          .of_order({std::log2(coarse / fine), 2, 0.12})
          .within(tolerance, "measured with a quarter to spare"));
}

Outcome deflection() {
  Outcome outcome;
  for (const double poisson : {0.0, 0.25}) {
    add_deflection(poisson, 1, 2e-3, outcome);
    add_deflection(poisson, 0.5, 3e-3, outcome);
  }
  return outcome;
}

// ---- Deflection of a beam whose end is held.

double clamped_deflection(const Grid& grid, Outcome& outcome) {
  dda::Model model = bonded_blocks(grid);
  clamp(grid, model);
  load_free_end(grid.beam, load, model);
  return working_deflection(std::move(model), load, outcome);
}

Outcome clamped() {
  Outcome outcome;
  const exact::Cantilever short_beam = beam_of(8, 0);
  const double with_shear = exact::deflection_with_shear(short_beam, load);
  const double got = clamped_deflection(grid_of(short_beam, 16), outcome);
  outcome.assertions.push_back(expect("deflection of the load, L/h = 8, held end, 16 blocks across", "m")
                                   .is(got)
                                   .against(with_shear, "P L^3/(3 E I) + 1.2 P L/(G A)")
                                   .within(1.5e-3, "measured 8e-4 (32 blocks across: 3e-4)"));
  const exact::Cantilever slender = beam_of(16, 0);
  const double bending = exact::bending_deflection(slender, load);
  const double bent = clamped_deflection(grid_of(slender, 8), outcome);
  outcome.assertions.push_back(expect("deflection of the load, L/h = 16, held end, 8 blocks across", "m")
                                   .is(bent)
                                   .against(bending, "P L^3/(3 E I)")
                                   .within(7e-3, "shear adds 0.28 %, 8 blocks across 0.35 %"));
  return outcome;
}

// ---- Lowest frequency.

// Starts with the velocities of Euler and Bernoulli's mode, so that hardly any other mode takes part.
dda::Model swinging(const Grid& grid, double dt, int steps) {
  constexpr double speed = 1e-3;  // m/s
  dda::Model model = bonded_blocks(grid);
  clamp(grid, model);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      dda::Block& block = model.blocks[static_cast<std::size_t>(grid.block(column, row))];
      const double x = (column + 0.5) * grid.block_length();
      const double y = grid.bottom(row) + grid.block_height() / 2;
      const double turning = speed * exact::mode_slope(grid.beam, x);
      block.initial_velocity = {-y * turning, speed * exact::mode_deflection(grid.beam, x)};
      block.initial_spin = turning;
    }
  }
  dda::Stage stage = moving_stage(dda::trapezoidal_integrator(), dt, steps * dt);
  stage.kinematics = dda::Kinematics::small;
  model.stages = {stage};
  return model;
}

// The part of the mode in the displacements, up to a factor.
double mode_part(const Grid& grid, const dda::State& state) {
  double part = 0;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      part += exact::mode_deflection(grid.beam, (column + 0.5) * grid.block_length()) *
              state.displacement[static_cast<std::size_t>(grid.block(column, row))](1);
  return part;
}

// Under the trapezoidal rule a mode of angular frequency w turns by theta a step, tan(theta/2) = w dt/2, and its
// samples obey q(n+1) + q(n-1) = 2 cos(theta) q(n): theta by least squares over all steps.
double lowest_frequency(const Grid& grid, Outcome& outcome, double& residual) {
  constexpr int steps_per_period = 100;
  constexpr int periods = 1;
  const double dt = 1 / (exact::bending_frequency(grid.beam) * steps_per_period);
  WatchedRun run(swinging(grid, dt, periods * steps_per_period));
  double before = 0;
  double now = 0;
  double products = 0;
  double squares = 0;
  while (!run.simulation().finished()) {
    run.step();
    const double next = mode_part(grid, run.state());
    products += now * (next + before);
    squares += 2 * now * now;
    before = std::exchange(now, next);
  }
  residual = std::max(residual, run.energy_residual());
  outcome.counters += run.simulation().counters();
  return std::tan(std::acos(products / squares) / 2) / (dt * std::acos(-1.0));
}

Outcome frequency() {
  Outcome outcome;
  double residual = 0;
  const exact::Cantilever short_beam = beam_of(8, 0);
  const double with_shear = exact::timoshenko_frequency(short_beam);
  const double got = lowest_frequency(grid_of(short_beam, 16), outcome, residual);
  outcome.assertions.push_back(expect("lowest frequency, L/h = 8, 16 blocks across", "Hz")
                                   .is(got)
                                   .against(with_shear, "Timoshenko's beam (exact/cantilever)")
                                   .within(5e-4, "measured 2.5e-4, a part of it from the springs of the held end"));
  const exact::Cantilever slender = beam_of(16, 0);
  const double bending = exact::bending_frequency(slender);
  const double swung = lowest_frequency(grid_of(slender, 8), outcome, residual);
  outcome.assertions.push_back(expect("lowest frequency, L/h = 16, 8 blocks across", "Hz")
                                   .is(swung)
                                   .against(bending, "1.8751^2/(2 pi) sqrt(E I/(rho A L^4))")
                                   .within(5e-3, "shear and rotary inertia take 0.26 %, 8 blocks across 0.15 %"));
  outcome.assertions.push_back(energy_assertion("two beams", residual));
  return outcome;
}

}  // namespace

std::vector<Case> cantilever_cases() {
  return {{"cantilever-deflection",
           "Beam of bonded blocks under exact end tractions: converges to elasticity",
           {27},
           CaseLabel::fast,
           deflection},
          {"cantilever-clamped", "Cantilever of bonded blocks: deflection", {27}, CaseLabel::fast, clamped},
          {"cantilever-frequency", "Cantilever of bonded blocks: lowest frequency", {27}, CaseLabel::fast, frequency}};
}

}  // namespace verify
