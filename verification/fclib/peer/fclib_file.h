// Problems in files of FCLIB (HDF5). FCLIB's law is rigid, so a spring becomes an unknown of its own, the way v_s that
// it gives: M is 1/D on its diagonal and H is 1 in its row, so v_s = D r, and H^T v has D r in it. Nothing is lost.
#pragma once

#include <string>

#include "verification/fclib/friction_problem.h"

namespace verify {

// Replaces a file of that name. Throws std::runtime_error, in a sentence.
void write_fclib(const FrictionProblem& problem, const std::string& title, const std::string& file);

// Springs are taken back where all numbers of contacts have one; else D is zero.
[[nodiscard]] FrictionProblem read_fclib(const std::string& file);

}  // namespace verify
