// What is legal of linings but odd: where a thin beam along the wall says little.
#pragma once

#include <string>
#include <vector>

#include "engine/model/model.h"

namespace dda {

std::vector<std::string> lining_remarks(const Model& model);

}  // namespace dda
