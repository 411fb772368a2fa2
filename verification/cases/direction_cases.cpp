#include "verification/cases/direction_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "dda/simulation/block_terms.h"
#include "verification/cases/bar_case.h"
#include "verification/cases/bloch.h"
#include "verification/exact/wave_speeds.h"

namespace verify {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double density = 2650;
constexpr double young = 50e9;
constexpr double poisson = 0.25;

const dda::Material rock{"rock", density, young, poisson, dda::PlaneState::stress};

dda::JointMaterial bond(dda::InterfaceLaw law) {
  dda::JointMaterial joint;
  joint.law = law;
  joint.bonded = true;
  return joint;
}

// Errors of the speeds in their worst directions, with sign.
struct Errors {
  double s = 0, p = 0;
};

void keep_largest_of(double error, double& largest) {
  if (!(std::abs(error) <= std::abs(largest))) largest = error;
}

Errors worst(const PeriodicMesh& mesh, double strain_inertia, double blocks_per_wavelength) {
  const dda::JointMaterial joint = bond(dda::InterfaceLaw::consistent);
  const double exact_s = exact::s_speed(young, poisson, density);
  const double exact_p = exact::p_speed_plane_stress(young, poisson, density);
  const double q = 2 * pi / (blocks_per_wavelength * mesh.longest_side());
  Errors errors;
  for (double degrees = 0; degrees < 180; degrees += 7.5) {
    const double angle = degrees * pi / 180;
    const PhaseSpeeds speeds =
        phase_speeds(mesh, rock, joint, q * dda::Vec2(std::cos(angle), std::sin(angle)), strain_inertia);
    keep_largest_of(relative_error(speeds.s, exact_s), errors.s);
    keep_largest_of(relative_error(speeds.p, exact_p), errors.p);
  }
  return errors;
}

struct Mesh {
  std::string name;
  PeriodicMesh mesh;
};

std::vector<Mesh> meshes() {
  return {{"squares", square_mesh()},
          {"bricks in running bond", brick_mesh()},
          {"triangles", triangle_mesh()},
          {"irregular quadrilaterals, first draw", irregular_mesh(1)},
          {"irregular quadrilaterals, second draw", irregular_mesh(2)},
          {"rhomboids of 60 degrees", sheared_mesh()}};
}

void assert_speeds(const Mesh& given, double strain_inertia, double tolerance, const std::string& reason,
                   Outcome& outcome) {
  const Errors coarse = worst(given.mesh, strain_inertia, 20);
  const Errors fine = worst(given.mesh, strain_inertia, 40);
  const auto of = [&](const std::string& wave, double speed, double error, double finer) {
    outcome.assertions.push_back({fmt::format("{} speed, worst direction, {}", wave, given.name), "m/s",
                                  speed * (1 + error), speed, "isotropic continuum, plane stress", error, tolerance,
                                  reason, Order{order(error, finer), 2, 0.1}});
  };
  of("S", exact::s_speed(young, poisson, density), coarse.s, fine.s);
  of("P", exact::p_speed_plane_stress(young, poisson, density), coarse.p, fine.p);
}

// What a scene gets that leaves everything unsaid (ADR 18).
Outcome as_preset() {
  Outcome outcome;
  for (const Mesh& mesh : meshes())
    assert_speeds(mesh, dda::mesh_strain_inertia, 5e-3, "promised; squares along their sides: Omega^2/48 = 2.1e-3",
                  outcome);
  return outcome;
}

Outcome consistent_inertia() {
  Outcome outcome;
  for (const Mesh& mesh : meshes())
    assert_speeds(mesh, 1, 6e-3, "squares along their sides: Omega^2/24 = 4.1e-3; rhomboids measured", outcome);
  return outcome;
}

// What the classical law makes of the same: stiff at 45 degrees, and stiffer with stiffer springs.
Outcome corner_springs() {
  Outcome outcome;
  dda::JointMaterial joint = bond(dda::InterfaceLaw::classical);
  for (const auto& [springs, published] : {std::pair{10.0, 0.26}, std::pair{40.0, 0.89}}) {
    joint.spring_over_young = springs;
    joint.shear_to_normal = 1;
    dda::Material prototype = rock;
    prototype.poisson = 0.333;
    const double q = 2 * pi / 20;
    const PhaseSpeeds speeds =
        phase_speeds(square_mesh(), prototype, joint, q * dda::Vec2(std::sqrt(0.5), std::sqrt(0.5)));
    const double exact = exact::s_speed(young, 0.333, density);
    const double error = relative_error(speeds.s, exact);
    outcome.assertions.push_back(
        {fmt::format("error of the S speed at 45 degrees, corner springs of {} E (error absolute)", springs), "-",
         error, published, "an independent prototype, two digits", error - published, 6e-3,
         "half of the last digit, and a bit"});
  }
  return outcome;
}

}  // namespace

std::vector<Case> direction_cases() {
  return {{"plane-wave-direction",
           "Plane waves in every direction, consistent law as scenes have it, 20 blocks a wavelength",
           {42},
           CaseLabel::fast,
           as_preset},
          {"plane-wave-strain-inertia", "The same with strain_inertia 1", {42}, CaseLabel::fast, consistent_inertia},
          {"plane-wave-corner-springs",
           "Plane waves at 45 degrees, classical springs",
           {42},
           CaseLabel::fast,
           corner_springs}};
}

}  // namespace verify
