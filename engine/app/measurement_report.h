// Measurements in words, for dda check.
#pragma once

#include <string>

#include "engine/model/model.h"

namespace dda {

// "NAME [UNIT]: QUANTITY PLACE".
std::string describe(const Model& model, const Measurement& measurement);

}  // namespace dda
