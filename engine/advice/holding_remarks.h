// Blocks that touch nothing that is held, and what becomes of them in static stages.
#pragma once

#include <string>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/model/model.h"

namespace dda {

// A sentence where nothing at all is held and there is gravity, and up to three for each static stage: on what falls,
// on what turns ever further, and on bodies whose loads are in balance, which nothing keeps where they are.
std::vector<std::string> holding_remarks(const Model& model, const ContactSet& contacts);

}  // namespace dda
