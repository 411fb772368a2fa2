// Remarks on rock whose blocks are too large for the waves that its loads make.
#pragma once

#include <string>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/model/model.h"

namespace dda {

// A row of blocks has no wave shorter than two of them, and those that are little longer are slow. Waves are those of
// the fastest change of loads and motions (step_choice.h), of P waves, which are longest; blocks the largest tenth.
// Nothing of a few bodies, or of blocks that do not touch, which waves do not cross.
std::vector<std::string> coarse_blocks(const Model& model, const ContactSet& contacts);

}  // namespace dda
