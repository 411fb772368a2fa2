// Loads and prescribed motions that jump. A jump holds all frequencies, of which blocks carry only the lower ones: the
// wave behind it overshoots and rings whatever the mesh and the time step, although its mean speed and size are right.
#pragma once

#include <vector>

#include "engine/advice/load_finding.h"
#include "engine/advice/load_history.h"
#include "engine/model/model.h"

namespace dda {

// One for every history that jumps in a stage that runs in time without damping velocities from step to step: constant
// loads that such a run begins with, unless they balance the stress that its blocks begin with; what comes or goes with
// a stage; steps of tables, ends
// of sines and records, decays without a rise. Of motions the velocity counts, as a wave carries it; that of a place
// which begins to swing as a sine jumps once, and the swing that follows is as foretold.
std::vector<LoadFinding> sudden_loads(const Model& model);

// Where the displacement of a place is given: how much of its velocity, squared and over all the time, is in half a
// step beside each jump of it. A wave is read in rows of dt, and what a row has of a jump depends on how it is read: so
// do amplitude and speed by about this share. 0 for loads.
double share_of_jumps(const SceneLoad& load, double dt);

}  // namespace dda
