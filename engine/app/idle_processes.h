// Processes that mpirun has started and that have nothing to do.
#pragma once

#include <string>

#include "engine/model/model.h"

namespace dda {

// A sentence where several processes were started for a scene that is solved by one, else empty.
std::string remark_on_idle_processes(const Model& model);

}  // namespace dda
