// Whether two histories are the same, value by value.
#pragma once

#include "engine/model/time_function.h"

namespace dda {

// Recordings are when they share their samples.
bool are_same(const TimeFunction& a, const TimeFunction& b);

}  // namespace dda
