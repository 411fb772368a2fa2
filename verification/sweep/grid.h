// Every combination of the listed values.
#pragma once

#include <vector>

#include "engine/scene/field.h"
#include "verification/sweep/parameters.h"

namespace verify {

// `grid` is an object of lists; a key that is left out has its default. The last key of the README's table varies
// fastest. Throws dda::InputError for a key or value that is none, for a length or a time step given twice or not at
// all, and for parameters that one of the laws does not have.
[[nodiscard]] std::vector<JobParameters> jobs_of_grid(const dda::Field& grid);

// Names of the parameters that can be an axis of a plot.
[[nodiscard]] std::vector<std::string> numeric_parameters();

inline constexpr std::size_t most_jobs = 100'000;

}  // namespace verify
