// dda-verify: the verification studies from the command line.
#include <iostream>

#include "verification/cases/all_cases.h"
#include "verification/chapters/thesis_command.h"
#include "verification/differential/differential_command.h"
#include "verification/precision/precision_command.h"
#include "verification/rocks/rocks_command.h"
#include "verification/stability/stability_command.h"
#include "verification/study/command_line.h"
#include "verification/suite/run_command.h"
#include "verification/suite/table_command.h"
#include "verification/sweep/sweep_command.h"
#include "verification/thesis/blast_command.h"
#include "verification/thesis/calibrate_command.h"

int main(int argc, char** argv) {
  using namespace verify;
  std::vector<StudyCommand> commands{calibrate_command(), blast_command(), run_command(all_cases),
                                     table_command(all_cases)};
  for (StudyCommand& command : sweep_commands()) commands.push_back(std::move(command));
  for (const auto& make : {precision_command, thesis_command, stability_command, differential_command, rocks_command})
    commands.push_back(make());
  return run_command_line("dda-verify", "Verification studies of the dda engine.", commands, argc, argv, std::cout,
                          std::cerr);
}
