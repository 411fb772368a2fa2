#include "verification/cases/slope_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <utility>

#include "engine/safety/factor_of_safety.h"
#include "verification/cases/contact_rig.h"
#include "verification/cases/limit_search.h"
#include "verification/exact/plane_failure.h"
#include "verification/exact/toppling_slope.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

constexpr double degree = std::numbers::pi / 180;

// ---- Goodman and Bray's slope. Its base is drawn level and gravity turned.

dda::Model toppling_slope(const exact::TopplingSlope& slope, double young, double friction) {
  dda::Model model;
  model.title = fmt::format("toppling slope, tan f = {}", friction);
  model.materials = {{"rock", 1e3 * slope.unit_weight / standard_gravity, young, 0.2, dda::PlaneState::stress}};
  model.joints = {dry_joint(std::atan(friction))};
  model.gravity = -standard_gravity * dda::Vec2(std::sin(slope.dip), std::cos(slope.dip));
  const double right = slope.columns * slope.width;
  dda::Ring ground = {{-40, -30}, {right + 20, -30}, {right + 20, slope.columns * slope.base_step}};
  ground.emplace_back(right, slope.columns * slope.base_step);
  for (int column = slope.columns; column >= 1; --column) {
    const double base = (column - 1) * slope.base_step;
    ground.emplace_back(column * slope.width, base);
    if (column > 1) ground.emplace_back((column - 1) * slope.width, base);
  }
  ground.emplace_back(-40, 0);
  model.blocks.emplace_back().shape.outer = ground;
  hold_firmly(model, 0);
  for (int column = 1; column <= slope.columns; ++column) {
    const double base = (column - 1) * slope.base_step;
    add_box(model, (column - 1) * slope.width, base, column * slope.width, base + slope.height(column));
  }
  return model;
}

bool slope_stands(double young, double friction, Outcome& outcome) {
  dda::Model model = toppling_slope(exact::goodman_bray_slope(), young, friction);
  let_stand(model, 0.1, 300);
  // One that stands gives way by 0.4 mm at 100 GPa.
  return stands(std::move(model), 0.4e9 / young, outcome);
}

Outcome toppling() {
  Outcome outcome;
  const double expected = exact::limiting_friction(exact::goodman_bray_slope());
  struct Rock {
    double young, tolerance;
  };
  for (const Rock& rock : {Rock{100e9, 2e-3}, Rock{10e9, 7e-3}}) {
    const Bracket got = bisect({0.95 * expected, 1.05 * expected}, 2e-4 * expected,
                               [&](double friction) { return slope_stands(rock.young, friction, outcome); });
    outcome.assertions.push_back(
        bracketed(
            expect(
                fmt::format("coefficient of friction with which the slope just stands, {:.0f} GPa", rock.young / 1e9),
                "-"),
            got, expected, "limit equilibrium column by column, 0.7855 (Goodman and Bray 1976; exact/toppling_slope)")
            .within(rock.tolerance,
                    "columns that give way need more friction than rigid ones: measured +0.1 % (100 GPa), +0.5 % (10 "
                    "GPa)"));
  }
  return outcome;
}

// The factor of safety that strength reduction finds is what the friction has to spare over that which just holds.
Outcome toppling_safety() {
  Outcome outcome;
  const exact::TopplingSlope slope = exact::goodman_bray_slope();
  const double least_friction = exact::limiting_friction(slope);
  for (const double degrees : {30.0, 37.0, 45.0}) {
    const double friction = std::tan(degrees * degree);
    const dda::SafetyReport report = dda::factor_of_safety(toppling_slope(slope, 100e9, friction), {.width = 1e-3});
    const double expected = friction / least_friction;
    outcome.assertions.push_back(
        expect(fmt::format("factor of safety, friction {:.0f} deg, 100 GPa", degrees), "-")
            .is(report.factor())
            .against(expected, "tan f/0.7855, limit equilibrium (Goodman and Bray 1976; exact/toppling_slope)")
            .within(2.5e-3,
                    "columns that give way need 0.1 % more friction than rigid ones, and the factor is "
                    "known to 0.1 %"));
  }
  return outcome;
}

// ---- Plane failure: a slice with upright sides, so that its weight passes through the middle of its foot.

constexpr double foot = 4;    // m, along the plane
constexpr double height = 3;  // m, of the upright sides
constexpr double density = 2500;

struct Slice {
  double dip = 0;       // rad
  double cohesion = 0;  // Pa
  double friction = 0;  // rad
  dda::InterfaceLaw law = dda::InterfaceLaw::classical;
};

exact::PlaneFailure plane_of(double dip) {
  return {dip, foot, density * standard_gravity * foot * height * std::cos(dip)};
}

// The plane is drawn level and gravity turned. An end of the foot breaks when its half of the shear force exceeds its
// half of the strength, and then the other must carry the rest. So the springs of the classical law are soft: they
// share the shear force evenly, where a slice softer than its springs would load its lower end more.
dda::Model slice_on_plane(const Slice& slice) {
  dda::Model model;
  model.title = "slice on a plane";
  model.materials = {{"rock", density, 20e9, 0, dda::PlaneState::stress}};
  dda::JointMaterial joint = dry_joint(slice.friction);
  joint.law = slice.law;
  joint.cohesion = slice.cohesion;
  joint.spring_over_young = 1e-3;
  model.joints = {joint};
  const dda::Vec2 up(-std::sin(slice.dip), std::cos(slice.dip));
  model.gravity = -standard_gravity * up;
  hold_firmly(model, add_box(model, -10, -2, 20, 0));
  model.blocks.emplace_back().shape.outer = {{0, 0}, {foot, 0}, dda::Vec2(foot, 0) + height * up, height * up};
  let_stand(model, 0.1, 50);
  return model;
}

// One that stands sinks by 4 mm.
bool slice_stands(const Slice& slice, Outcome& outcome) { return stands(slice_on_plane(slice), 0.02, outcome); }

Outcome plane_failure() {
  Outcome outcome;
  constexpr double dip = 40 * degree;
  const exact::PlaneFailure plane = plane_of(dip);
  constexpr auto source = "(c A + W cos psi tan f)/(W sin psi) = 1 (Hoek and Bray)";
  for (const dda::InterfaceLaw law : {dda::InterfaceLaw::classical, dda::InterfaceLaw::consistent}) {
    const bool is_classical = law == dda::InterfaceLaw::classical;
    const std::string name = is_classical ? "classical" : "consistent";
    const double tolerance = is_classical ? 1e-3 : 1.5e-5;
    const std::string reason = is_classical
                                   ? "ends of the foot share shear unevenly by the slice's strain over that of "
                                     "the springs: measured up to 6e-4"
                                   : "bracket of 1e-5";
    for (const double friction : {0.0, 15 * degree, 30 * degree}) {
      const double expected = plane.limiting_cohesion(friction);
      const Bracket got = bisect({0.9 * expected, 1.1 * expected}, 1e-5 * expected, [&](double cohesion) {
        return slice_stands({dip, cohesion, friction, law}, outcome);
      });
      outcome.assertions.push_back(
          bracketed(expect(fmt::format("cohesion that just holds, f = {:.0f} deg, {}", friction / degree, name), "Pa"),
                    got, expected, source)
              .within(tolerance, reason));
    }
    for (const double share : {0.0, 0.3, 0.7}) {
      const double cohesion = share * plane.limiting_cohesion(0);
      const double expected = std::tan(plane.limiting_friction(cohesion));
      const Bracket got = bisect({0.9 * expected, 1.1 * expected}, 1e-5 * expected, [&](double friction) {
        return slice_stands({dip, cohesion, std::atan(friction), law}, outcome);
      });
      outcome.assertions.push_back(
          bracketed(
              expect(fmt::format("coefficient of friction that just holds, c = {:.0f} kPa, {}", cohesion / 1e3, name),
                     "-"),
              got, expected, source)
              .within(tolerance, reason));
    }
  }
  return outcome;
}

}  // namespace

std::vector<Case> slope_cases() {
  return {{"toppling-slope",
           "Goodman and Bray's slope of 16 columns: limiting friction from both sides",
           {18},
           CaseLabel::fast,
           toppling},
          {"toppling-slope-safety",
           "Factor of safety of Goodman and Bray's slope by strength reduction",
           {18},
           CaseLabel::fast,
           toppling_safety},
          {"plane-failure",
           "Slice on a plane: limiting cohesion and friction from both sides",
           {19},
           CaseLabel::fast,
           plane_failure}};
}

}  // namespace verify
