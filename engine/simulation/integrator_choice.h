// Explicit steps (central differences, ADR 49) for stages that leave their integrator to the engine (ADR 73).
//
// A stage gets them where
//   - nothing stands against them (explicit_obstacle), its waves are corrected for blocks and time steps, by joints of
//     consistent law nearly everywhere: errors are then those of the blocks alone, which implicit steps have as well;
//   - its dt, where the scene gives one, is stable. Where it is left to the engine it may become shorter than that of
//     implicit steps, never longer;
//   - the CPU time that is predicted (stage_cost.h), with what finding the limit takes, is lower by a third and by so
//     much that it matters: small scenes keep what they had.
// All of it follows from the model: a run has the same steps on every machine, with any number of threads, and when it
// is resumed. No scene is refused for what is found here.
#pragma once

#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/model/model.h"

namespace dda {

// Sets integrator, dt and the reason in such stages (Stage::chosen). Returns for every stage that got
// explicit steps a dt up to which they are stable, s; 0 for all others. `contacts`: of the model as drawn.
std::vector<double> choose_integrators(const ContactSet& contacts, Model& model);

}  // namespace dda
