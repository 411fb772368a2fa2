// What is legal in a scene but odd: a unit missed, a sign turned, a gap left by rounding. Nothing here changes a run;
// whoever meant it so reads a sentence too many.
#pragma once

#include <string>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/model/model.h"

namespace dda {

// A sentence each, without a full stop: what there is, how much of it, and what was perhaps meant.
std::vector<std::string> remarks_on(const Model& model, const ContactSet& contacts);

}  // namespace dda
