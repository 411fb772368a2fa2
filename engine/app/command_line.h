// The command line of the program `dda`.
#pragma once

#include <iosfwd>

namespace dda {

// Exit codes: 0 done; 1 a result could not be written, or memory ran out; 2 bad input, with one sentence on `errors`;
// 3 a run ended before its time; 128 + signal a run was stopped.
int run_command_line(int argc, const char* const* argv, std::ostream& out, std::ostream& errors);

}  // namespace dda
