// The solver that shares a system among processes, where the program brings one along (engine/distributed): the engine
// itself knows nothing of MPI.
#pragma once

#include <memory>

#include "engine/linear/pcg_solver.h"
#include "engine/linear/solver.h"

namespace dda {

struct OverProcesses {
  std::unique_ptr<LinearSolver> (*make)(const PcgOptions&) = nullptr;  // none: a program without PETSc
  int processes = 1;
};

// To be told before the first scene is read; what the program was started with does not change.
void share_over_processes(const OverProcesses& given);

[[nodiscard]] const OverProcesses& over_processes();

}  // namespace dda
