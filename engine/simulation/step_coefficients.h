// The numbers by which one time step of an Integrator multiplies mass, damping, stiffness and loads.
//
// With d the displacement increment, the step solves
//   (mass M + damping C + stiffness K) d
//     = load_new F1 + load_old F0 - Fint0 + M (mass_v v0 + mass_a a0) - C (damping_v v0 + damping_a a0)
// which is the integrator's balance (settings.h) with a1 and v1 written in d, v0, a0. Explicit steps, whose d follows
// from v0 and a0 alone, have the weights of forces and velocities and no such system (explicit_step.h).
#pragma once

#include "engine/model/settings.h"

namespace dda {

struct StepCoefficients {
  double dt = 0;
  double mass = 0, mass_v = 0, mass_a = 0;
  double damping = 0, damping_v = 0, damping_a = 0;
  double stiffness = 0;
  double load_new = 0, load_old = 0;
  double a_d = 0, a_v = 0, a_a = 0;    // a1 = a_d d + a_v v0 + a_a a0
  double v_v = 0, v_a0 = 0, v_a1 = 0;  // v1 = v_v v0 + v_a0 a0 + v_a1 a1
  double weight_new_a = 0;             // acceleration in the balance: weight_new_a a1 + (1 - weight_new_a) a0
  double acts_at = 0;                  // moment in the step, as a share of it, to which that acceleration belongs
};

StepCoefficients step_coefficients(const Integrator& integrator, double dt);

}  // namespace dda
