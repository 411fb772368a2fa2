// Energy that the first steps of a stage make of its first accelerations, and lose again.
//
// A step takes the velocity at its end from d, v0 and a0: gamma/beta d/dt + (1 - gamma/beta) v0 + kappa a0 dt with
// kappa = 1 - gamma/(2 beta). Where a block is let go and something far stiffer than a step can resolve catches it at
// once, d is next to nothing, and kappa a0 dt is what is left of a fall that never came to be. For rho_inf = 0 kappa is
// 1/4. It is no motion that lasts: such a mode of generalized-alpha has the double root -rho_inf, so that after n steps
// n rho_inf^(n-1) of it are there at most, and with rho_inf = 0 nothing after the second step. (A single mode of any
// frequency was followed step by step: what it gains is at most kappa^2 (n rho_inf^(n-1))^2 of a0 dt's kinetic energy,
// for rho_inf of 0 to 0.75.) A run that ends in these first steps shows it all the same.
#pragma once

namespace dda {

struct BlockSystem;

// Kinetic energy of the velocities that the accelerations of now would make in one step, J per m of thickness.
double energy_of_a_free_step(const BlockSystem& system);

// The most that may be there of it at the end of the first step, or of a part of it, J per m of thickness; 0 in static
// and explicit stages.
double gain_of_first_step(const BlockSystem& system);

// The same at the end of the last step.
double gain_at_start(const BlockSystem& system);

}  // namespace dda
