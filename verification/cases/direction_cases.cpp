#include "verification/cases/direction_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "engine/simulation/block_terms.h"
#include "verification/cases/bar_case.h"
#include "verification/exact/wave_speeds.h"
#include "verification/lattice/bloch.h"
#include "verification/suite/expect.h"

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

Errors worst(const PeriodicMesh& mesh, bool corrected, double blocks_per_wavelength) {
  const dda::JointMaterial joint = bond(dda::InterfaceLaw::consistent);
  const double exact_s = exact::s_speed(young, poisson, density);
  const double exact_p = exact::p_speed_plane_stress(young, poisson, density);
  const double q = 2 * pi / (blocks_per_wavelength * mesh.longest_side());
  Errors errors;
  for (double degrees = 0; degrees < 180; degrees += 7.5) {
    const double angle = degrees * pi / 180;
    const PhaseSpeeds speeds =
        phase_speeds(mesh, rock, joint, q * dda::Vec2(std::cos(angle), std::sin(angle)), corrected);
    keep_largest_of(relative_error(speeds.s, exact_s), errors.s);
    keep_largest_of(relative_error(speeds.p, exact_p), errors.p);
  }
  return errors;
}

struct Mesh {
  std::string name;
  PeriodicMesh mesh;
  double order = 2;  // of the errors of corrected ones
};

std::vector<Mesh> meshes() {
  return {{"squares", square_mesh(), 4},
          {"bricks in running bond", brick_mesh()},
          {"triangles", triangle_mesh()},
          {"irregular quadrilaterals, first draw", irregular_mesh(1)},
          {"irregular quadrilaterals, second draw", irregular_mesh(2)},
          {"Voronoi polygons, first draw", voronoi_mesh(1)},
          {"Voronoi polygons, second draw", voronoi_mesh(2)},
          {"rhomboids of 60 degrees", sheared_mesh()}};
}

void assert_speeds(const Mesh& given, bool corrected, double tolerance, const std::string& reason, Outcome& outcome) {
  const Errors coarse = worst(given.mesh, corrected, 20);
  const Errors fine = worst(given.mesh, corrected, 40);
  const auto of = [&](const std::string& wave, double speed, double error, double finer) {
    outcome.assertions.push_back(expect(fmt::format("{} speed, worst direction, {}", wave, given.name), "m/s")
                                     .is(speed * (1 + error))
                                     .against(speed, "isotropic continuum, plane stress")
                                     .off_by(error)
                                     .of_order({order(error, finer), corrected ? given.order : 2, 0.1})
                                     .within(tolerance, reason));
  };
  of("S", exact::s_speed(young, poisson, density), coarse.s, fine.s);
  of("P", exact::p_speed_plane_stress(young, poisson, density), coarse.p, fine.p);
}

// What a scene gets that leaves everything unsaid (ADR 24).
Outcome as_preset() {
  Outcome outcome;
  for (const Mesh& mesh : meshes())
    assert_speeds(mesh, true, mesh.order == 4 ? 5e-5 : 5e-3,
                  mesh.order == 4 ? "measured with margin; 5e-3 promised" : "promised", outcome);
  return outcome;
}

// Squares hold what was promised at 20 blocks a wavelength at a quarter of them.
Outcome few_blocks() {
  Outcome outcome;
  const Errors errors = worst(square_mesh(), true, 5);
  for (const auto& [wave, error] : {std::pair("S", errors.s), std::pair("P", errors.p)})
    outcome.assertions.push_back(
        expect(fmt::format("error of the {} speed, worst direction, squares, 5 blocks a wavelength "
                           "(error absolute)",
                           wave),
               "-")
            .is(error)
            .against(0, "isotropic continuum, plane stress")
            .absolutely()
            .within(5e-3, "promised at 20 blocks a wavelength"));
  return outcome;
}

Outcome uncorrected() {
  Outcome outcome;
  for (const Mesh& mesh : meshes())
    assert_speeds(mesh, false, 6e-3, "squares along their sides: Omega^2/24 = 4.1e-3; rhomboids measured", outcome);
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
        expect(fmt::format("error of the S speed at 45 degrees, corner springs of {} E (error absolute)", springs), "-")
            .is(error)
            .against(published, "an independent prototype, two digits")
            .absolutely()
            .within(6e-3, "half of the last digit, and a bit"));
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
          {"plane-wave-few-blocks", "The same with 5 blocks a wavelength", {42}, CaseLabel::fast, few_blocks},
          {"plane-wave-uncorrected", "The same without correct_block_dispersion", {42}, CaseLabel::fast, uncorrected},
          {"plane-wave-corner-springs",
           "Plane waves at 45 degrees, classical springs",
           {42},
           CaseLabel::fast,
           corner_springs}};
}

}  // namespace verify
