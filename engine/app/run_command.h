// `dda run`: a scene in, a folder of results out.
#pragma once

#include <iosfwd>

#include "engine/app/run_options.h"

namespace dda {

// Returns the exit code: 0; 3 when the run ended before its time (the reason is in the summary and on `errors`); 128 +
// signal when SIGINT or SIGTERM stopped it. Throws InputError for what is wrong with scene, folder or checkpoint,
// before anything is written, and std::runtime_error when a result cannot be written.
int run_scene(const RunOptions& options, std::ostream& out, std::ostream& errors);

}  // namespace dda
