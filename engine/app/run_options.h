// What `dda run` is asked for on its command line.
#pragma once

#include <cstdint>
#include <filesystem>
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

}  // namespace dda
