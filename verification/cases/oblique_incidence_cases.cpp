#include "verification/cases/oblique_incidence_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "engine/simulation/block_terms.h"
#include "verification/cases/bar_case.h"
#include "verification/cases/edge_reflection.h"
#include "verification/harness/histories.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

using exact::PlaneWave;

constexpr double pi = std::numbers::pi;
const dda::Material rock{"rock", 2650, 50e9, 0.25, dda::PlaneState::strain};

MeshEdge edge_of(const PeriodicMesh& mesh, double ratio) {
  dda::JointMaterial bond;
  bond.bonded = true;
  return {mesh, rock, bond, false, ratio, ratio};
}

exact::Reflection exact_reflection(const MeshEdge& edge, PlaneWave incident, double angle) {
  return exact::reflect({dda::p_wave_speed(rock), dda::s_wave_speed(rock), edge.across, edge.along}, incident, angle);
}

EdgeReflection mesh_reflection(const MeshEdge& edge, PlaneWave incident, double degrees, double blocks_in_s_wave) {
  const double omega = 2 * pi * dda::s_wave_speed(rock) / (blocks_in_s_wave * edge.mesh.longest_side());
  return reflect(edge, incident, degrees * pi / 180, omega);
}

std::string name_of(PlaneWave wave) { return wave == PlaneWave::p ? "P" : "S"; }

// Largest errors of the roots of the shares: of amplitudes, counted in energy.
struct Errors {
  double p = 0, s = 0, balance = 0;
};

Errors errors_of(const MeshEdge& edge, PlaneWave incident, double blocks_in_s_wave) {
  Errors errors;
  for (double degrees = 0; degrees <= 80; degrees += 5) {
    const EdgeReflection mesh = mesh_reflection(edge, incident, degrees, blocks_in_s_wave);
    const exact::Reflection exact = exact_reflection(edge, incident, degrees * pi / 180);
    keep_largest(errors.p, std::sqrt(mesh.p_energy) - std::sqrt(exact.p_energy));
    keep_largest(errors.s, std::sqrt(mesh.s_energy) - std::sqrt(exact.s_energy));
    keep_largest(errors.balance, mesh.p_energy + mesh.s_energy + mesh.absorbed - 1);
  }
  return errors;
}

double exact_share(const MeshEdge& edge, PlaneWave incident, double angle) {
  const exact::Reflection exact = exact_reflection(edge, incident, angle);
  return exact.p_energy + exact.s_energy;
}

// What the mesh's own speed of waves, Omega^2/24 too fast, makes of a share: the wave meets the edge at an angle larger
// by tan(angle) Omega^2/24, and amplitudes are off by Omega^2/48 of the shorter wave as at normal incidence.
double expected_error(const MeshEdge& edge, PlaneWave incident, double angle, double blocks_in_s_wave) {
  const double s_omega = 2 * pi / blocks_in_s_wave;
  const double omega = incident == PlaneWave::s ? s_omega : s_omega * dda::s_wave_speed(rock) / dda::p_wave_speed(rock);
  const double turned = angle + std::tan(angle) * omega * omega / 24;
  const double share = exact_share(edge, incident, angle);
  return std::abs(exact_share(edge, incident, turned) - share) + 2 * std::sqrt(share) * s_omega * s_omega / 48;
}

void assert_share(const MeshEdge& edge, PlaneWave incident, double degrees, Outcome& outcome) {
  const EdgeReflection mesh = mesh_reflection(edge, incident, degrees, 20);
  const EdgeReflection fine = mesh_reflection(edge, incident, degrees, 40);
  const EdgeReflection finest = mesh_reflection(edge, incident, degrees, 80);
  const double angle = degrees * pi / 180;
  const double reference = exact_share(edge, incident, angle);
  const double value = mesh.p_energy + mesh.s_energy;
  outcome.assertions.push_back(
      expect(fmt::format("share of energy sent back, {} wave at {} deg (error absolute)", name_of(incident), degrees),
             "-")
          .is(value)
          .against(reference, "waves at a viscous edge (Lysmer & Kuhlemeyer 1969)")
          .absolutely()
          .of_order(Order{
              order(fine.p_energy + fine.s_energy - reference, finest.p_energy + finest.s_energy - reference), 2, 0.1})
          .within(
              1.3 * expected_error(edge, incident, angle, 20),
              "waves of the mesh, 20 blocks an S wavelength, are Omega^2/24 too fast, which turns them by tan(angle) "
              "Omega^2/24; "
              "Omega^2/48 of the amplitude as at normal incidence; 1.3 for the next order"));
}

void assert_curve(const std::string& what, const MeshEdge& edge, PlaneWave incident, double tolerance,
                  Outcome& outcome) {
  const Errors coarse = errors_of(edge, incident, 20);
  const Errors fine = errors_of(edge, incident, 40);
  const Errors finest = errors_of(edge, incident, 80);
  const double error = std::max(coarse.p, coarse.s);
  outcome.assertions.push_back(
      expect(fmt::format("largest error of the root of an energy share, {} wave at 0 to 80 deg, {}", name_of(incident),
                         what),
             "-")
          .is(error)
          .against(0, "waves at the edge of the continuum")
          .absolutely()
          .of_order({order(std::max(fine.p, fine.s), std::max(finest.p, finest.s)), 2, 0.1})
          .within(tolerance,
                  "waves of the mesh are faster by Omega^2/24 and so meet the edge at a larger angle, by tan(angle) "
                  "Omega^2/24; "
                  "measured with margin"));
  const double balance = std::max({coarse.balance, fine.balance, finest.balance});
  outcome.assertions.push_back(
      expect(fmt::format("reflected and absorbed energy but for 1, {} wave, {}", name_of(incident), what), "-")
          .is(balance)
          .against(0, "conservation of energy")
          .absolutely()
          .within(1e-8, "eigenvectors of near-parallel waves lose half of the digits"));
}

struct Edge {
  std::string name;
  MeshEdge edge;
  double p_tolerance, s_tolerance;
};

Outcome curves() {
  PeriodicMesh bricks = brick_mesh();
  std::swap(bricks.first, bricks.second);
  const PeriodicMesh squares = square_mesh();
  MeshEdge preset = edge_of(squares, 1);
  preset.corrected = true;
  Outcome outcome;
  for (const Edge& edge : {Edge{"viscous edge of squares", edge_of(squares, 1), 0.017, 0.04},
                           Edge{"the same, corrected for the size of blocks", preset, 0.0004, 0.0018},
                           Edge{"viscous edge of bricks in running bond", edge_of(bricks, 1), 0.018, 0.05},
                           Edge{"edge of half the impedance, squares", edge_of(squares, 0.5), 0.02, 0.05},
                           Edge{"free edge of squares", edge_of(squares, 0), 0.019, 0.053}}) {
    assert_curve(edge.name, edge.edge, PlaneWave::p, edge.p_tolerance, outcome);
    assert_curve(edge.name, edge.edge, PlaneWave::s, edge.s_tolerance, outcome);
  }
  return outcome;
}

Outcome shares() {
  const MeshEdge edge = edge_of(square_mesh(), 1);
  Outcome outcome;
  for (const double degrees : {30.0, 45.0, 60.0, 70.0, 80.0}) assert_share(edge, PlaneWave::p, degrees, outcome);
  for (const double degrees : {15.0, 30.0, 45.0, 60.0, 70.0, 80.0}) assert_share(edge, PlaneWave::s, degrees, outcome);
  return outcome;
}

}  // namespace

std::vector<Case> oblique_incidence_cases() {
  return {{"oblique-incidence",
           "Energy that a viscous edge sends back of plane waves at an angle",
           {35},
           CaseLabel::fast,
           shares},
          {"oblique-incidence-curve",
           "Plane waves at the edge of a mesh of blocks, 0 to 80 degrees",
           {35},
           CaseLabel::fast,
           curves}};
}

}  // namespace verify
