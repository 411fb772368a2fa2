// Dashpots of contacts that cannot set how blocks rebound.
#pragma once

#include <string>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/model/model.h"

namespace dda {

// A sentence, without a full stop, for each joint whose contact_damping is beside springs so stiff that a block which
// hits it gives way itself, where blocks hit each other from the start: some are thrown, or fall.
std::vector<std::string> rebound_remarks(const Model& model, const ContactSet& contacts);

}  // namespace dda
