// What one job of a sweep computes: the thesis' bar with one choice of every parameter.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "engine/model/material.h"
#include "engine/model/settings.h"

namespace verify {

enum class Pulse {
  cycle,  // the thesis': one sine cycle, which starts and ends with a kink and so holds many frequencies
  tone,   // six cycles under a sin^2 envelope: nearly one frequency
};

struct JobParameters {
  double block_length = 0;                 // m
  double dt = 0;                           // s
  dda::JointMaterial joint;                // law, spring_over_young, shear_to_normal, penalty
  dda::Stage stage;                        // integrator, strain_inertia, lateral_inertia, correct_time_dispersion
  std::string integrator_name = "thesis";  // with its parameter, e.g. "generalized_alpha 0.8"
  double poisson = 0;                      // -
  Pulse pulse = Pulse::cycle;

  [[nodiscard]] double eta() const;                 // block length over the wavelength of the load
  [[nodiscard]] double cfl() const;                 // sqrt(E/rho) dt / block length
  [[nodiscard]] double samples_per_period() const;  // steps in a period of the load
};

// The thesis' scheme: corner springs of 10 E, Eq. 5; joints bonded, small motion. Block length and time step are not
// set.
[[nodiscard]] JobParameters default_parameters();

// One flat object with every parameter, the columns of the table; two jobs are the same if theirs are.
[[nodiscard]] nlohmann::ordered_json to_json(const JobParameters& parameters);

[[nodiscard]] std::string pulse_name(Pulse pulse);

}  // namespace verify
