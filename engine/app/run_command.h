// `dda run`: a scene in, a folder of results out.
#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>

namespace dda {

struct RunOptions {
  std::filesystem::path scene;
  std::filesystem::path folder;
  std::optional<std::int64_t> frames;    // over the whole run, besides that of the start
  std::optional<double> frame_interval;  // s
  std::int64_t rows_every = 1;           // steps
  double checkpoint_interval = 10;       // s, of the wall clock
  std::optional<std::string> from;       // DIR or DIR:STAGE of a run of the same blocks to go on from
  bool resume = false;
  int threads = 0;  // that share the work; 0: one for each core
  bool quiet = false;
  bool profile = false;  // say where the time went
};

// Returns the exit code: 0; 3 when the run ended before its time (the reason is in the summary and on `errors`); 128 +
// signal when SIGINT or SIGTERM stopped it. Throws InputError for what is wrong with scene, folder or checkpoint,
// before anything is written, and std::runtime_error when a result cannot be written.
int run_scene(const RunOptions& options, std::ostream& out, std::ostream& errors);

}  // namespace dda
