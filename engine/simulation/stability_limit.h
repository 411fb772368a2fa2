// The longest time step with which central differences are stable: 2 over the largest frequency of a stage's stiffness
// and inertia, by the matrices that its steps use (ADR 49). Dampers that act on velocities leave the limit where it is.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/model/model.h"
#include "engine/simulation/linear_operators.h"
#include "engine/solve/held_unknowns.h"

namespace dda {

// The largest omega^2 with K x = omega^2 M x, x zero in held blocks, by Lanczos' method from fixed random numbers. It
// is found from below, and 1 % of it may be missing, with so many products that more than that is missing once in a
// million times.
struct LargestFrequency {
  double squared = 0;  // 1/s^2
  int products = 0;    // with the stiffness, that it took
};
LargestFrequency largest_frequency(const LinearOperators& operators, const HeldUnknowns& held);

// What is asked of a limit that need not be known to the last percent, s: whether steps of `wanted` are below it, else
// the limit to the share `close` of it, else whether it is above `least`.
struct StepsInQuestion {
  double wanted = 0, least = 0;
  double close = 0.995;
};

// A step that is stable, no longer than the limit, with as many products as tell, and the same doubt: after k products
// it is known how much of omega^2 may be missing, and the frequency found bounds the limit from the other side. 0 where
// steps of `least` are not stable.
double stable_step(const LinearOperators& operators, const HeldUnknowns& held, const StepsInQuestion& steps);

// The limit of a stage of the model, s: 2/omega, and half a percent less for what may be missing. The operators know
// dt, and a longer one softens them (ADR 49): they are those of the stage's dt, or of the limit where that is less.
// Throws InputError where the stage cannot be stepped so.
double stability_limit(const Model& model, std::size_t stage);
double stability_limit(const Model& model, std::size_t stage, const ContactSet& drawn);  // the model's contacts

// The same of a stage with central differences whose contacts are known (those of the model as drawn): a stable step by
// matrices that time steps have not softened, whose limit is below that of all others. 0 where there is none.
double stable_step(const Model& model, std::size_t stage, const ContactSet& contacts, const StepsInQuestion& steps);

// Gives a stage that leaves dt to the engine the longest even division of its duration below a limit (s), in two
// digits.
void shorten_to(double limit, Stage& stage);

// Returns the limits of all stages, s: 0 for those with implicit steps, and those of `known` that are above 0 as they
// are. A stage that leaves dt to the engine keeps what waves and records ask for (step_choice.h) where that is stable,
// and else gets 95 % of its limit in two digits. Throws InputError for a given dt that is above its limit.
std::vector<double> kept_stability_limits(const ContactSet& drawn, Model& model, std::vector<double> known = {});

}  // namespace dda
