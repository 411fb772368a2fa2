// What is legal of blocks that spin but odd: the stress that the centrifugal force puts into them.
#pragma once

#include <string>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/model/model.h"

namespace dda {

std::vector<std::string> spin_remarks(const Model& model, const ContactSet& contacts);

}  // namespace dda
