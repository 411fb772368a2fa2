#include "verification/thesis/schemes.h"

#include <array>
#include <stdexcept>

#include "engine/builder/scheme.h"

namespace verify {
namespace {

constexpr std::array<std::string_view, 5> names = {"thesis", "classical_trapezoidal", "consistent", "accurate",
                                                   "accurate_strip"};

dda::JointMaterial joint_of(const ThesisBar& bar, dda::InterfaceLaw law, bool bonded) {
  dda::JointMaterial joint;
  joint.name = "joint";
  joint.law = law;
  joint.bonded = bonded;
  joint.friction_angle = bar.friction_angle;
  joint.cohesion = bar.cohesion;
  joint.tensile_strength = bar.tensile_strength;
  joint.spring_over_young = 10;  // chapter 6 of the thesis says so of its g0
  joint.shear_to_normal = 0.4;
  return joint;
}

dda::Stage small_motion(const dda::Integrator& integrator) {
  dda::Stage stage;
  stage.integrator = integrator;
  stage.kinematics = dda::Kinematics::small;
  return stage;
}

SchemeSettings thesis(const ThesisBar& bar) {
  return {"thesis",
          "thesis",
          "Corner springs of 10 E (shear 0.4 of it) with the joint strength of Table 3.1 judged at every step, time "
          "integration of Eq. 5 of the thesis; σₓ of the block to the right of 50 m.",
          joint_of(bar, dda::InterfaceLaw::classical, false),
          small_motion(dda::thesis_integrator()),
          dda::Quantity::stress_xx,
          AmplitudeReading::half_range};
}

SchemeSettings classical_trapezoidal(const ThesisBar& bar) {
  return {"classical_trapezoidal",
          "classical, trapezoidal",
          "The same corner springs, bonded, with the trapezoidal rule in place of Eq. 5: what is left is the error of "
          "the springs and of the block length.",
          joint_of(bar, dda::InterfaceLaw::classical, true),
          small_motion(dda::trapezoidal_integrator()),
          dda::Quantity::stress_xx,
          AmplitudeReading::half_range};
}

SchemeSettings consistent(const ThesisBar& bar) {
  return {"consistent", "consistent, trapezoidal",
          "Nitsche's method on bonded edges in place of springs, trapezoidal rule; stress at 50 m between two blocks.",
          joint_of(bar, dda::InterfaceLaw::consistent, true), small_motion(dda::trapezoidal_integrator())};
}

SchemeSettings accurate(const ThesisBar& bar) {
  SchemeSettings scheme{"accurate", "accurate",
                        "Cubic reconstruction across bonded edges, generalized-α (ρ∞ = 0.85) with its period error "
                        "corrected in the inertia, no lateral inertia (elementary bar theory, as the analytic "
                        "solution has it); stress of the reconstruction at 50 m.",
                        joint_of(bar, dda::InterfaceLaw::cubic, true),
                        small_motion(dda::preset_stage({}, dda::Kinematics::small, true).integrator)};
  scheme.stage.correct_time_dispersion = true;
  scheme.stage.lateral_inertia = false;
  return scheme;
}

SchemeSettings accurate_strip(const ThesisBar& bar) {
  SchemeSettings scheme = accurate(bar);
  scheme.name = "accurate_strip";
  scheme.title = "accurate, strip";
  scheme.description =
      "The accurate scheme with lateral inertia: the bar as the strip of 1 m that it is. It disperses "
      "sideways, at low frequencies as Love's bar does, which elementary bar theory leaves out.";
  scheme.stage.lateral_inertia = true;
  return scheme;
}

}  // namespace

std::span<const std::string_view> scheme_names() { return names; }

SchemeSettings scheme_settings(std::string_view name, const ThesisBar& bar) {
  if (name == "thesis") return thesis(bar);
  if (name == "classical_trapezoidal") return classical_trapezoidal(bar);
  if (name == "consistent") return consistent(bar);
  if (name == "accurate") return accurate(bar);
  if (name == "accurate_strip") return accurate_strip(bar);
  throw std::invalid_argument("there is no scheme \"" + std::string(name) + "\"");
}

}  // namespace verify
