// Whether what a program printed has arrived where it went, such as a file on a disk that is full.
#pragma once

#include <iosfwd>
#include <string>

namespace dda {

// Flushes `out`. Where that or anything before it failed, says so on `errors` as PROGRAM and returns 1 in place of a
// `code` of 0.
int exit_code_once_printed(int code, const std::string& program, std::ostream& out, std::ostream& errors);

}  // namespace dda
