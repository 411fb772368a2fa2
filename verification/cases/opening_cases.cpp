#include "verification/cases/opening_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "engine/builder/free_outline.h"
#include "verification/cases/bar_case.h"
#include "verification/cases/cavity_mesh.h"
#include "verification/cases/opening_mesh.h"
#include "verification/harness/recorded_run.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

constexpr double far_xx = -5e6;   // Pa
constexpr double far_yy = -10e6;  // Pa
constexpr FarStress far_stress{far_xx, far_yy};

dda::Vec2 traction(const dda::Vec3& stress, const dda::Vec2& inward) {
  return {-stress[0] * inward.x() - stress[2] * inward.y(), -stress[2] * inward.x() - stress[1] * inward.y()};
}

Outcome kirsch() {
  Outcome outcome;
  double coarser = 0;
  double coarser_wall = 0;
  for (const int sectors : {16, 32, 64}) {
    dda::Model model = opened(sectors, far_stress);
    set_stage(model, dda::static_integrator(), 1, 1);
    dda::Simulation simulation(model);
    advance_to_end(simulation);
    outcome.counters += simulation.counters();
    const double error = mean_error(simulation, far_stress);
    outcome.assertions.push_back(
        expect(fmt::format("stresses from 1.2 to 4 radii, {} sectors (error: rms, of the far stress)", sectors), "MPa")
            .is(error * std::abs(far_yy) / 1e6)
            .against(0, "Kirsch 1898")
            .off_by(error)
            .within(0.012 * std::pow(16.0 / sectors, 2), "measured with margin; falls as their square"));
    if (sectors == 64) outcome.assertions.back().order = Order{order(coarser, error), 2, 0.2};
    const double wall = wall_stress(simulation, static_cast<std::size_t>(sectors));
    const double expected = 3 * far_yy - far_xx;
    outcome.assertions.push_back(
        expect(fmt::format("hoop stress at the wall, extrapolated, {} sectors", sectors), "MPa")
            .is(wall / 1e6)
            .against(expected / 1e6, "3 s_yy - s_xx (Kirsch 1898)")
            .off_by(relative_error(wall, expected))
            .within(0.2 * std::pow(16.0 / sectors, 2), "measured with margin; falls as their square"));
    if (sectors == 64) outcome.assertions.back().order = Order{order(coarser_wall, wall - expected), 2, 0.2};
    coarser_wall = wall - expected;
    coarser = error;
  }
  return outcome;
}

// Largest displacement of any block's centroid, over that of a wall that is let go, p a/(2 G).
Assertion nothing_moves(dda::Model model, const std::string& what, Outcome& outcome) {
  const dda::Vec3 stress(far_xx, far_yy, 2e6);
  for (dda::Block& block : model.blocks) block.initial_stress = stress;
  for (const auto& ring : dda::free_rings(model))
    for (const dda::Stretch& s : ring)
      model.edge_loads.push_back({s.block, s.from, s.to, traction(stress, s.inward), dda::Constant{}});
  set_stage(model, dda::trapezoidal_integrator(), 1e-4, 0.02);
  dda::Simulation simulation(model);
  advance_to_end(simulation);
  outcome.counters += simulation.counters();
  double largest = 0;
  for (const dda::Vec6& u : simulation.state().displacement) largest = std::max(largest, u.head<2>().norm());
  const double let_go = std::abs(far_yy) * (1 + cavity_poisson) / cavity_young;
  return {fmt::format("largest displacement in 200 steps, {} (error: of p a/(2 G))", what),
          "m",
          largest,
          0,
          "the rock taken out is replaced by its tractions",
          largest / let_go,
          1e-9,
          "round-off"};
}

Outcome invariance() {
  Outcome outcome;
  outcome.assertions.push_back(nothing_moves(ring_mesh(32, 5), "ring mesh", outcome));
  outcome.assertions.push_back(nothing_moves(octagon_mesh({.half_width = 10}), "octagon in squares", outcome));
  return outcome;
}

}  // namespace

std::vector<Case> opening_cases() {
  return {{"kirsch", "A circular opening in a biaxial field", {28}, CaseLabel::fast, kirsch},
          {"excavation-invariance", "Rock replaced by its tractions", {31}, CaseLabel::fast, invariance}};
}

}  // namespace verify
