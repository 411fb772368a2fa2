#include "verification/cases/spin_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/geometry/rotation.h"
#include "engine/terms/inertia.h"
#include "verification/cases/every_integrator.h"
#include "verification/exact/centrifugal_stress.h"
#include "verification/harness/histories.h"
#include "verification/harness/recorded_run.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

const dda::Material rock{"rock", 2500, 20e9, 0.25, dda::PlaneState::stress};

// A rectangle around the origin that stands askew and flies off while it spins.
dda::Model spinning_block(double width, double height, double spin, const dda::Integrator& integrator, double dt,
                          int steps) {
  const auto [c, s] = std::array{std::cos(0.3), std::sin(0.3)};
  dda::Model model;
  model.materials = {rock};
  dda::Block& block = model.blocks.emplace_back();
  for (const auto& [x, y] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    block.shape.outer.emplace_back((c * x * width - s * y * height) / 2, (s * x * width + c * y * height) / 2);
  block.initial_velocity = {3, 1};
  block.initial_spin = spin;
  dda::Stage stage;
  stage.integrator = integrator;
  stage.dt = dt;
  stage.duration = steps * dt;
  stage.solver = dda::SolverRequest::cholesky;
  model.stages = {stage};
  dda::finish_model(model);
  return model;
}

double angular_momentum(const dda::Simulation& simulation) {
  const dda::Model& model = simulation.model();
  const dda::Vec3 squares =
      dda::deformed_mean_squares(dda::mean_squares(model.blocks[0].moments), simulation.state().deformation[0]);
  return dda::momentum({model.mass_of(0), squares, 1}, simulation.state().velocity[0])(2);
}

struct Spun {
  double most_energy = 0;   // kinetic and strain, largest of all steps over that of the start
  double least_energy = 0;  // at the end over that of the start
  double momentum = 0;      // largest relative change
  double residual = 0;
};

Spun spin(const dda::Model& model, Outcome& outcome) {
  dda::Simulation simulation(model);
  const double start = simulation.energy().kinetic;
  const double momentum = angular_momentum(simulation);
  Spun spun;
  while (!simulation.finished()) {
    advance(simulation, 1);
    const double energy = (simulation.energy().kinetic + simulation.energy().strain) / start;
    spun.most_energy = std::max(spun.most_energy, energy);
    spun.least_energy = energy;
    spun.momentum = std::max(spun.momentum, std::abs(angular_momentum(simulation) / momentum - 1));
    spun.residual = std::max(spun.residual, std::abs(simulation.energy().relative_residual()));
  }
  outcome.counters += simulation.counters();
  return spun;
}

struct Worst {
  double gain = 0;      // of energy, over the spin's energy times the square of the strain
  double momentum = 0;  // largest relative change
};

// What free spins gain under an integrator in units of what the linear law leaves out: energies are not told apart
// beyond the square of the strain that the centrifugal force makes.
Worst worst_of_spins(const dda::Integrator& integrator, Outcome& outcome, double& residual) {
  constexpr double width = 1.4;
  constexpr double height = 0.8;
  constexpr int steps = 8000;
  Worst worst;
  for (const double spin_rate : {20.0, 200.0}) {
    const double strain = exact::mean_centrifugal_stress(rock.density, spin_rate, width, height)[0] / rock.young;
    for (const double turn : {0.1, 0.01, 0.002}) {
      const Spun spun = spin(spinning_block(width, height, spin_rate, integrator, turn / spin_rate, steps), outcome);
      worst.gain = std::max(worst.gain, (spun.most_energy - 1) / (strain * strain));
      worst.momentum = std::max(worst.momentum, spun.momentum);
      residual = std::max(residual, spun.residual);
    }
  }
  return worst;
}

Outcome no_gain() {
  const std::string spins = "20 and 200 rad/s, 0.002 to 0.1 rad a step, ";
  Outcome outcome;
  double residual = 0;
  for (const dda::Integrator& integrator : every_integrator()) {
    const auto [gain, momentum] = worst_of_spins(integrator, outcome, residual);
    outcome.assertions.push_back(
        expect("energy gained over the spin's times the strain squared, " + spins + integrator.name, "-")
            .is(gain)
            .against(0, "free motion: none comes in (error absolute)")
            .absolutely()
            .within(8, "theory: energies of second order in the strains are not told apart"));
    outcome.assertions.push_back(expect("largest change of angular momentum, " + spins + integrator.name, "-")
                                     .is(momentum)
                                     .against(0, "free motion (error absolute)")
                                     .absolutely()
                                     .within(1e-10, "a few roundings a step; measured up to 6e-12"));
  }
  outcome.assertions.push_back(expect("largest energy residual over the largest term", "-")
                                   .is(residual)
                                   .against(0, "the ledger (error absolute)")
                                   .absolutely()
                                   .within(1e-9, "target of the project"));
  return outcome;
}

// Stress in the directions of the drawing's sides.
dda::Vec3 stress_in_block(const dda::State& state) {
  return dda::rotate_stress(state.stress[0], -state.displacement[0](2) - 0.3);
}

Outcome stress_at_rest_in_the_block() {
  constexpr int steps = 4000;
  Outcome outcome;
  for (const auto& [width, height] : {std::array{1.0, 1.0}, {1.4, 0.8}, {0.5, 2.0}}) {
    for (const double spin_rate : {20.0, 200.0}) {
      const dda::Model model =
          spinning_block(width, height, spin_rate, dda::generalized_alpha_integrator(0), 0.01 / spin_rate, steps);
      dda::Simulation simulation(model);
      advance_to_end(simulation);
      outcome.counters += simulation.counters();
      const dda::Vec3 stress = stress_in_block(simulation.state());
      const double spin_now = simulation.state().velocity[0](2);
      const auto [along, across] = exact::mean_centrifugal_stress(rock.density, spin_now, width, height);
      const double strain = std::max(along, across) / rock.young;
      const std::string name = fmt::format("{} x {} m at {} rad/s", width, height, spin_rate);
      const std::string reason = "theory: the block is larger than drawn by its strain, which counts four times";
      const std::string source = "rho omega^2 L^2/12 of the side's length L: virial theorem";
      outcome.assertions.push_back(expect("stress along the width, " + name, "Pa")
                                       .is(stress(0))
                                       .against(along, source)
                                       .within(1e-7 + 8 * strain, reason));
      outcome.assertions.push_back(expect("stress along the height, " + name, "Pa")
                                       .is(stress(1))
                                       .against(across, source)
                                       .within(1e-7 + 8 * strain, reason));
      outcome.assertions.push_back(expect("shear stress, " + name, "Pa")
                                       .is(stress(2))
                                       .against(0, "mirror symmetry (error over the largest)")
                                       .off_by(stress(2) / std::max(along, across))
                                       .within(1e-7 + 8 * strain, reason));
    }
  }
  return outcome;
}

}  // namespace

std::vector<Case> spin_cases() {
  return {{"spin-energy", "Free spin of elastic blocks: no integrator gives energy", {3}, CaseLabel::fast, no_gain},
          {"spin-stress", "Centrifugal stress of blocks that spin", {3}, CaseLabel::fast, stress_at_rest_in_the_block}};
}

}  // namespace verify
