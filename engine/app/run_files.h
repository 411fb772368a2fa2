// The files of a run: histories.csv, energies.csv, peaks.csv where the scene asks for it, frames.pvd with frames/,
// contacts.pvd with contacts/, where there are bolts bolts.pvd with bolts/, where there are linings
// linings.pvd with linings/, checkpoint.bin, summary.json.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/frame_clock.h"
#include "engine/app/run_position.h"
#include "engine/record/bolt_frame_writer.h"
#include "engine/record/contact_frame_writer.h"
#include "engine/record/frame_writer.h"
#include "engine/record/history_writer.h"
#include "engine/record/lining_frame_writer.h"
#include "engine/record/summary.h"
#include "engine/simulation/peak_motion.h"
#include "engine/simulation/probes.h"
#include "engine/simulation/simulation.h"

namespace dda {

struct FileOptions {
  std::filesystem::path folder;
  std::int64_t rows_every = 1;           // steps
  std::optional<double> frame_interval;  // s; none: no frames
  double checkpoint_interval = 10;       // s, of the wall clock
  bool profile = false;                  // the run will add one
};

// Creates the folder if need be, and writes to it what a run should leave. Other files there are left alone. All errors
// are std::runtime_error naming path and reason.
class RunFiles {
 public:
  // `resumed`: what load_run returned; nothing for a run from the start, of which a first row, frame and checkpoint are
  // written at once. Both must outlive the object.
  RunFiles(const Simulation& simulation, const Probes& probes, FileOptions options,
           const std::optional<RunPosition>& resumed);

  // To be called after every step: writes the row, frame and checkpoint that are due.
  void after_step();

  // To be called at the end of every stage (StageWatch), within its last step: writes its row, and the
  // frame that is due of that step, while all is there that they show.
  void at_end_of_stage();

  // To be called between two stages and after the last one. Keeps the state between two for other runs to begin from.
  void after_stage();

  // What there is not yet of the state that a run ended in before its time. To be called after the last checkpoint,
  // which does not count it: a run that goes on from there writes it anew, or steps beyond it.
  void write_last_state();

  // Rows reach the disk before the checkpoint that counts them.
  void write_checkpoint();

  // Completes histories.csv, and adds what lies in the folder to the summary before writing it.
  void close(RunSummary summary);

 private:
  void open_bolt_frames();
  void open_lining_frames();
  void follow_peaks(const std::optional<RunPosition>& resumed);
  void write_what_is_due();
  void sample();
  void sample_energies();
  [[nodiscard]] RunPosition position() const;
  void write_frame_when_due();
  void write_frame();
  [[nodiscard]] std::filesystem::path in_folder(const char* name) const { return options_.folder / name; }

  const Simulation& simulation_;
  const Probes& probes_;
  FileOptions options_;
  std::vector<Column> columns_;
  std::vector<double> values_;
  std::unique_ptr<HistoryWriter> histories_;
  std::unique_ptr<HistoryWriter> energies_;
  std::int64_t energies_every_;  // steps
  double energy_time_ = 0;       // s, of the last row
  std::unique_ptr<FrameWriter> frames_;
  std::unique_ptr<ContactFrameWriter> contact_frames_;
  std::unique_ptr<BoltFrameWriter> bolt_frames_;
  std::unique_ptr<LiningFrameWriter> lining_frames_;
  std::optional<PeakMotion> peaks_;
  std::vector<double> frame_times_;
  std::optional<FrameClock> frame_clock_;
  bool settles_ = false;            // after the last step, see Simulation::is_settling()
  std::int64_t ended_step_ = -1;    // the last of a stage
  std::int64_t written_step_ = -1;  // of the last row
  std::chrono::steady_clock::time_point last_checkpoint_;
};

}  // namespace dda
