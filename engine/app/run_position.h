// The checkpoint of a run by the program: the simulation, and how far its output files had got.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "engine/simulation/simulation.h"

namespace dda {

struct RunPosition {
  std::int64_t history_rows = 0;
  std::vector<double> frame_times;  // s
  std::int64_t energy_rows = 0;
  double energy_time = 0;        // s, of the last of them
  std::vector<std::byte> peaks;  // what PeakMotion has seen; empty where nobody asked
};

// std::runtime_error naming path and reason when it cannot be written.
void save_run(const std::filesystem::path& path, const Simulation& simulation, const RunPosition& position);

// Brings a simulation of the same scene to where it was saved. InputError naming the file when that is missing, damaged
// or of another scene.
RunPosition load_run(const std::filesystem::path& path, Simulation& simulation);

}  // namespace dda
