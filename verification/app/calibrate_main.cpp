// dda-calibrate: what `dda-verify calibrate` does, in a program that needs no verification case and is soon compiled.
#include <iostream>

#include "verification/study/command_line.h"
#include "verification/thesis/calibrate_command.h"

int main(int argc, char** argv) {
  const verify::StudyCommand calibrate = verify::calibrate_command();
  return verify::run_command_line("dda-calibrate", calibrate.description, {calibrate}, argc, argv, std::cout,
                                  std::cerr);
}
