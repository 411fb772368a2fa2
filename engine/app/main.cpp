#include <iostream>

#include "engine/app/command_line.h"
#include "engine/core/printed.h"
#ifdef DDA_PETSC
#include "engine/distributed/processes.h"
#endif

int main(int argc, char** argv) {
#ifdef DDA_PETSC
  const dda::Processes processes;
  if (!dda::Processes::is_first()) return dda::Processes::follow();
#endif
  const int code = dda::run_command_line(argc, argv, std::cout, std::cerr);
  return dda::exit_code_once_printed(code, "dda", std::cout, std::cerr);
}
