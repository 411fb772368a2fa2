// What acts at a place as if something else were not there: supports that move one point in two ways, viscous
// boundaries on joints.
#pragma once

#include <string>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/model/model.h"

namespace dda {

// At most one sentence for supports and one for viscous boundaries, of the first such place and with the number of the
// others, without a full stop.
std::vector<std::string> remarks_on_odds(const Model& model, const ContactSet& contacts);

}  // namespace dda
