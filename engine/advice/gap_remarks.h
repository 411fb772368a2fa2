// What is legal of blocks that lie close but odd: a gap too narrow to be seen in a drawing.
#pragma once

#include <string>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/model/model.h"

namespace dda {

std::vector<std::string> gap_remarks(const Model& model, const ContactSet& contacts);

}  // namespace dda
