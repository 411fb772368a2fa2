#include "engine/app/run_position.h"

#include <cstddef>
#include <cstring>
#include <span>
#include <utility>

#include "engine/core/error.h"
#include "engine/record/checkpoint.h"
#include "engine/simulation/snapshot.h"

namespace dda {
namespace {

// Before the snapshot: these, the times of frames, and the peaks.
struct Sizes {
  std::int64_t rows;
  std::int64_t frames;
  std::int64_t energy_rows;
  double energy_time;
  std::int64_t peak_bytes;
};

std::size_t frame_bytes(const Sizes& sizes) { return static_cast<std::size_t>(sizes.frames) * sizeof(double); }

}  // namespace

void save_run(const std::filesystem::path& path, const Simulation& simulation, const RunPosition& position) {
  const Sizes sizes{position.history_rows, static_cast<std::int64_t>(position.frame_times.size()), position.energy_rows,
                    position.energy_time, static_cast<std::int64_t>(position.peaks.size())};
  const std::vector<std::byte> snapshot = save(simulation);
  save_checkpoint(
      path, simulation.model(), simulation.state(),
      {std::as_bytes(std::span(&sizes, 1)), std::as_bytes(std::span(position.frame_times)), position.peaks, snapshot});
}

RunPosition load_run(const std::filesystem::path& path, Simulation& simulation) {
  Checkpoint checkpoint = load_checkpoint(path, simulation.model());
  std::span<const std::byte> bytes = checkpoint.extra;
  const auto refuse_if = [&](bool refused) {
    if (refused) throw InputError(path.string(), "checkpoint", "of another program", "one that dda run has written");
  };
  Sizes sizes{};
  refuse_if(bytes.size() < sizeof sizes);
  std::memcpy(&sizes, bytes.data(), sizeof sizes);
  bytes = bytes.subspan(sizeof sizes);
  refuse_if(sizes.frames < 0 || bytes.size() / sizeof(double) < static_cast<std::size_t>(sizes.frames));
  RunPosition position{sizes.rows,
                       std::vector<double>(static_cast<std::size_t>(sizes.frames)),
                       sizes.energy_rows,
                       sizes.energy_time,
                       {}};
  if (sizes.frames > 0) std::memcpy(position.frame_times.data(), bytes.data(), frame_bytes(sizes));
  bytes = bytes.subspan(frame_bytes(sizes));
  refuse_if(sizes.peak_bytes < 0 || bytes.size() < static_cast<std::size_t>(sizes.peak_bytes));
  const auto peaks = bytes.first(static_cast<std::size_t>(sizes.peak_bytes));
  position.peaks.assign(peaks.begin(), peaks.end());
  try {
    restore(simulation, std::move(checkpoint.state), bytes.subspan(position.peaks.size()));
  } catch (const InputError& error) {
    throw error.in_file(path.string());
  }
  return position;
}

}  // namespace dda
