// `dda-verify calibrate`: runs the study and writes its files.
#pragma once

#include <filesystem>

#include "verification/study/command.h"

namespace verify {

struct CalibrateCommand {
  std::filesystem::path folder;
  bool quick = false;
};

// Writes calibration.json, calibration.md, calibration.html and plots/ into the folder, which is made if need be.
// Returns the exit code of the program: 0, or 1 if a promise is broken or the plots could not be made, with a sentence
// on standard error for each. Throws std::runtime_error if a run fails or a file cannot be written.
int calibrate(const CalibrateCommand& command);

[[nodiscard]] StudyCommand calibrate_command();

}  // namespace verify
