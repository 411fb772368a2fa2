// What is noted, and what ends, at the end of a stage.
#pragma once

#include <cstddef>
#include <string>

#include "engine/model/model.h"
#include "engine/simulation/stage_results.h"

namespace dda {

struct BlockSystem;

// Friction limits what contacts carry again; what they carried beyond it goes without a trace in the motion.
void release_shear_of_contacts(BlockSystem& system);

// Does the same at the end of a stage of unlimited strength. What has settled under it is shown first: it is in
// equilibrium, and what is left of it is not.
void give_up_unlimited_strength(BlockSystem& system);

// Books what a stage that is over took of its energies by other means than damping as what it is.
void close_books_of_stage(BlockSystem& system);

// What nothing held is free again.
void let_go_of_loose_blocks(BlockSystem& system);

// Notes the results of the stage under way. `in_situ_force` (N per m of thickness): the largest on a drawn interface.
void note_results(const BlockSystem& system, double in_situ_force, StageResults& results);

// Says why a run is to end with that stage, which is over and no equilibrium; empty where it may go on.
std::string problem_at_end_of(std::size_t stage, const Model& model, const StageResults& ends);

}  // namespace dda
