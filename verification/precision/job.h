// One run of the study: a problem, a scheme, a block size and a time step; and what comes out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/model/settings.h"

namespace verify {

enum class Problem {
  bar,        // the thesis' bar under one 100 Hz sine cycle in a sin^2 envelope
  bar_cycle,  // the same under the thesis' own sine cycle, which starts and ends with a kink
  plane,      // a P and an S wave from a smooth source in a plate
};

inline constexpr std::string_view yardstick_law = "explicit finite elements";
inline constexpr std::string_view central_differences = "central differences";
inline constexpr std::string_view limit_differences =
    "central differences at c dt = h";  // exact in a uniform bar alone

struct PrecisionScheme {
  std::string law;         // "classical", "consistent", "cubic", or yardstick_law
  std::string integrator;  // "thesis", "trapezoidal", "hht 0.1", "generalized_alpha 0.8" (rho_inf), ...
  double strain_inertia = 1;
  bool corrected = false;         // correct_time_dispersion and correct_block_dispersion
  double spring_over_young = 10;  // classical law; the thesis has 10

  [[nodiscard]] std::string name() const;
  [[nodiscard]] bool is_yardstick() const { return law == yardstick_law; }
  [[nodiscard]] bool is_engine() const;  // neither the yardstick nor another program
  friend bool operator==(const PrecisionScheme&, const PrecisionScheme&) = default;
};

struct PrecisionJob {
  Problem problem = Problem::bar;
  PrecisionScheme scheme;
  double size = 0;  // m, of a block or element
  double dt = 0;    // s

  [[nodiscard]] std::string key() const;  // the same for the same job only
};

struct PrecisionResult {
  double error = 0;    // relative L2 norm over time (and receivers), see README.md
  double reading = 0;  // bar: the larger of the errors of velocity and amplitude; plane: NaN
  int cells = 0;       // blocks or elements
  double steps = 0;
  double solves = 0;      // of linear systems; 0 for the yardstick
  double iterations = 0;  // of the iterative solver
  double cpu_s = 0;       // of setting up and stepping, with reading the receivers

  // Passes over a cell, which do not depend on the machine: cells times steps, solves or iterations, whichever are
  // most.
  [[nodiscard]] double passes() const;
};

[[nodiscard]] std::string_view name_of(Problem problem);

// Throws std::invalid_argument for a name that is none of the integrators above.
[[nodiscard]] dda::Integrator integrator_named(const std::string& name);

// What a scene gets that leaves scheme, joints and steps unsaid, and what the thesis did.
[[nodiscard]] PrecisionScheme accurate_scheme(Problem problem);
[[nodiscard]] PrecisionScheme thesis_scheme();
// The accurate one of a plate in explicit steps, whose passes are shorter.
[[nodiscard]] PrecisionScheme explicit_scheme();

}  // namespace verify
