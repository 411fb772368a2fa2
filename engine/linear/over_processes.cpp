#include "engine/linear/over_processes.h"

namespace dda {
namespace {

OverProcesses& known() {
  static OverProcesses of_program;
  return of_program;
}

}  // namespace

void share_over_processes(const OverProcesses& given) { known() = given; }

const OverProcesses& over_processes() { return known(); }

}  // namespace dda
