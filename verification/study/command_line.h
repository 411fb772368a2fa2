// A command line of commands.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "verification/study/command.h"

namespace verify {

// The program `name` with one of these commands to be chosen, or with none to be chosen where there is only one.
// Returns the exit code: the command's own; 2, after a sentence on `errors` that begins with the program's name, for a
// wrong command line or dda::InputError; 1 for what else is thrown.
[[nodiscard]] int run_command_line(const std::string& name, const std::string& description,
                                   const std::vector<StudyCommand>& commands, int argc, const char* const* argv,
                                   std::ostream& out, std::ostream& errors);

}  // namespace verify
