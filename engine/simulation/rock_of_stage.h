// The rock of a stage (model/rock_change.h), brought into a run.
//
// Stresses, the forces of contacts, velocities, and what is broken stay as they are: a change alone moves nothing that
// has room for its forces, but for the weight of another density. Moduli hold for strains from then on, springs for
// gaps, and what stresses, forces and velocities store with the new values instead is external work. A closed contact
// that carries more shear than its new strength slides, and a bond that carries more than its new one breaks, in the
// first step of the stage.
#pragma once

#include "engine/simulation/block_system.h"

namespace dda {

// The strengths of all contacts by the joints of the model. `contacts_move`: see Simulation::follows_contacts.
void renew_strengths(bool contacts_move, BlockSystem& s);

// What blocks' weights, which have changed, make of their tractions at projected joints. Returns by how much what is
// stored has grown, J per m of thickness.
double renew_weights(BlockSystem& s);

// Model, blocks, their weight and what joints see of their stresses become those of the stage in force. Strengths and
// springs, which a run keeps, are left alone.
void take_rock_in_force(BlockSystem& s);

// The same where a stage begins, with strengths and energies.
void change_rock(bool contacts_move, BlockSystem& s);

}  // namespace dda
