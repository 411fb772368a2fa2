#include "engine/app/idle_processes.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/linear/over_processes.h"

namespace dda {

std::string remark_on_idle_processes(const Model& model) {
  const int processes = over_processes().processes;
  const auto is_shared = [](const Stage& stage) { return stage.solver == SolverRequest::petsc; };
  if (processes == 1 || std::ranges::any_of(model.stages, is_shared)) return "";
  return fmt::format("of {} processes one does all the work, as no stage has \"solver\": \"petsc\"", processes);
}

}  // namespace dda
