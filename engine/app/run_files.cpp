#include "engine/app/run_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "engine/app/lining_report.h"
#include "engine/core/phase_clock.h"
#include "engine/model/quantity_names.h"
#include "engine/record/atomic_file.h"
#include "engine/record/energy_terms.h"
#include "engine/record/peaks_file.h"
#include "engine/record/run_folder.h"
#include "engine/simulation/archive.h"
#include "engine/simulation/run_so_far.h"

namespace dda {
namespace {

std::vector<Column> columns_of(const Model& model) {
  std::vector<Column> columns;
  for (const Measurement& measurement : model.measurements)
    for (const HistoryFacts& history : histories_of(measurement.quantity))
      columns.push_back({measurement.name + std::string(history.suffix), std::string(history.unit)});
  return columns;
}

// Where rows of energies.csv begin to be left out: they are for looking at, and a thousand show all there is to see.
constexpr std::int64_t most_energy_rows = 1000;

constexpr std::size_t energy_values = stored_terms.size() + flow_terms.size() + 2;

std::vector<Column> columns_of_energies() {
  std::vector<Column> columns;
  for (const StoredTerm& term : stored_terms) columns.push_back({term.name, "J/m"});
  for (const FlowTerm& term : flow_terms) columns.push_back({term.name, "J/m"});
  columns.push_back({"residual", "J/m"});
  columns.push_back({"largest", "J/m"});
  return columns;
}

std::unique_ptr<HistoryWriter> open_rows(const std::filesystem::path& path, const std::vector<Column>& columns,
                                         std::optional<std::int64_t> rows) {
  if (rows) return std::make_unique<HistoryWriter>(path, columns, *rows);
  return std::make_unique<HistoryWriter>(path, columns);
}

std::vector<ContactPoint> contact_points_of(const Simulation& simulation) {
  const ContactSet& contacts = simulation.contacts();
  std::vector<ContactPoint> points;
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i)
    append_contact_points(simulation.model(), simulation.state(), contacts.interfaces[i], contacts.elements[i],
                          simulation.interface_state(i), points);
  return points;
}

BoltCondition condition_of(const LinkState& link) {
  if (link.ruptured) return BoltCondition::broken;
  if (link.waits) return BoltCondition::waiting;
  return link.plastic.isZero(0) ? BoltCondition::elastic : BoltCondition::yielded;
}

std::vector<BoltLinkValues> bolt_links_of(const Simulation& simulation) {
  const std::vector<Bolt>& bolts = simulation.model().bolts;
  std::vector<BoltLinkValues> values;
  for (std::size_t i = 0; i < bolts.size(); ++i) {
    for (std::size_t j = 0; j < bolts[i].links.size(); ++j) {
      const int bolt = static_cast<int>(i);
      const LinkState& link = simulation.bolts().state(bolt, j);
      values.push_back({bolts[i].spacing * link.force, simulation.bolts().elongation(bolt, j), condition_of(link)});
    }
  }
  return values;
}

// Whether the stage that comes is yet to take its first step: the row of the end of the one before is there.
bool stands_between_stages(const Simulation& simulation) {
  const std::vector<StageTimes> spans = stage_spans(simulation.model());
  const std::size_t done = stages_done(simulation);
  if (simulation.is_settling() || done >= spans.size()) return done >= spans.size();
  return std::abs(simulation.state().time - spans[done].begin_s) < 0.25 * simulation.model().stages[done].shortest_dt();
}

}  // namespace

RunFiles::RunFiles(const Simulation& simulation, const Probes& probes, FileOptions options,
                   const std::optional<RunPosition>& resumed)
    : simulation_(simulation),
      probes_(probes),
      options_(std::move(options)),
      columns_(columns_of(simulation.model())),
      values_(columns_.size()),
      energies_every_(std::max(options_.rows_every, steps_in_all_stages(simulation) / most_energy_rows)),
      settles_(simulation.is_settling()) {
  std::filesystem::create_directories(options_.folder);
  const auto rows = [&](std::int64_t RunPosition::*count) {
    return resumed ? std::optional((*resumed).*count) : std::nullopt;
  };
  histories_ = open_rows(in_folder(histories_name), columns_, rows(&RunPosition::history_rows));
  energies_ = open_rows(in_folder(energies_name), columns_of_energies(), rows(&RunPosition::energy_rows));
  if (resumed) {
    frame_times_ = resumed->frame_times;
    energy_time_ = resumed->energy_time;
    if (stands_between_stages(simulation)) written_step_ = simulation.state().step;
  }
  if (options_.frame_interval) {
    frames_ = std::make_unique<FrameWriter>(simulation.model(), in_folder(frames_name));
    frames_->go_on_after(frame_times_);
    contact_frames_ = std::make_unique<ContactFrameWriter>(in_folder(contacts_name));
    contact_frames_->go_on_after(frame_times_);
    if (!simulation.bolts().empty()) open_bolt_frames();
    if (!linings_of(simulation).empty()) open_lining_frames();
    frame_clock_.emplace(simulation.model(), *options_.frame_interval);
    if (!frame_times_.empty()) frame_clock_->taken(frame_times_.back());
  }
  if (simulation.model().peaks) follow_peaks(resumed);
  if (!resumed) {
    sample();
    sample_energies();
    write_frame_when_due();
  }
  write_checkpoint();
}

void RunFiles::open_bolt_frames() {
  bolt_frames_ = std::make_unique<BoltFrameWriter>(simulation_.model(), in_folder(bolts_name));
  bolt_frames_->go_on_after(frame_times_);
}

void RunFiles::open_lining_frames() {
  lining_frames_ = std::make_unique<LiningFrameWriter>(simulation_.model(), in_folder(linings_name));
  lining_frames_->go_on_after(frame_times_);
}

void RunFiles::follow_peaks(const std::optional<RunPosition>& resumed) {
  peaks_.emplace(simulation_);
  if (!resumed) return;
  MemoryReader reader(resumed->peaks);
  reader(*peaks_);
  reader.expect_end();
}

// A stage that paces itself has a row and a frame of its end alone. The stage before it has those of its own end, which
// are of the same time.
void RunFiles::after_step() {
  if (peaks_) peaks_->after_step(simulation_);
  if (!settles_ && simulation_.state().step != ended_step_) write_what_is_due();
  settles_ = simulation_.is_settling();
  const std::chrono::duration<double> since_checkpoint = std::chrono::steady_clock::now() - last_checkpoint_;
  if (since_checkpoint.count() > options_.checkpoint_interval) write_checkpoint();
}

// Its row is written whether or not it is one of every K, and so is the frame of the last one: the end is what a stage
// is run for.
void RunFiles::at_end_of_stage() {
  ended_step_ = simulation_.state().step;
  sample();
  sample_energies();
  const bool is_last = stages_done(simulation_) + 1 == simulation_.model().stages.size();
  if (frames_ && is_last)
    write_frame();
  else
    write_frame_when_due();
}

void RunFiles::write_what_is_due() {
  const std::int64_t step = simulation_.state().step;
  if (settles_ || step % options_.rows_every == 0) sample();
  if (settles_ || step % energies_every_ == 0) sample_energies();
  write_frame_when_due();
}

void RunFiles::sample() {
  const PhaseScope scope(Phase::rows);
  probes_.sample(simulation_, values_);
  histories_->append(simulation_.state().time, values_);
  written_step_ = simulation_.state().step;
}

void RunFiles::sample_energies() {
  const PhaseScope scope(Phase::rows);
  const EnergyLedger& energy = simulation_.energy();
  std::array<double, energy_values> values{};
  auto* next = values.data();
  for (const StoredTerm& term : stored_terms) *next++ = energy.*term.now;
  for (const FlowTerm& term : flow_terms) *next++ = energy.*term.sum;
  *next++ = energy.residual();
  *next = energy.scale();
  energy_time_ = simulation_.state().time;
  energies_->append(energy_time_, values);
}

RunPosition RunFiles::position() const {
  RunPosition position{histories_->rows(), frame_times_, energies_->rows(), energy_time_, {}};
  if (!peaks_) return position;
  MemoryWriter writer;
  writer(*peaks_);
  position.peaks = writer.take();
  return position;
}

void RunFiles::write_frame_when_due() {
  if (!frame_clock_ || !frame_clock_->is_due(simulation_.state().time)) return;
  frame_clock_->taken(simulation_.state().time);
  write_frame();
}

// Blocks last: a frame of them that is listed has its contacts, bolts and linings.
void RunFiles::write_frame() {
  const PhaseScope scope(Phase::frames);
  contact_frames_->write(simulation_.state().time, contact_points_of(simulation_));
  if (bolt_frames_) bolt_frames_->write(simulation_.state(), bolt_links_of(simulation_));
  if (lining_frames_) lining_frames_->write(simulation_.state(), lining_values_of(simulation_));
  frames_->write(simulation_.state(), simulation_.absent());
  frame_times_.push_back(simulation_.state().time);
}

void RunFiles::write_last_state() {
  const std::int64_t step = simulation_.state().step;
  const bool is_due = !settles_ && step % options_.rows_every == 0;  // and written, if before this run was resumed
  const bool is_behind = !is_due && written_step_ != step;
  if (is_behind) sample();
  if (frames_ && (is_behind || frame_times_.empty() || frame_times_.back() != simulation_.state().time)) write_frame();
}

void RunFiles::write_checkpoint() {
  const PhaseScope scope(Phase::checkpoint);
  histories_->flush();
  energies_->flush();
  save_run(in_folder(checkpoint_name), simulation_, position());
  last_checkpoint_ = std::chrono::steady_clock::now();
}

void RunFiles::after_stage() {
  const std::size_t ended = stages_done(simulation_) - 1;
  if (peaks_) peaks_->after_stage(simulation_, ended);
  if (simulation_.finished()) return;
  const PhaseScope scope(Phase::checkpoint);
  save_run(in_folder(stage_file_name(ended).c_str()), simulation_, position());
}

void RunFiles::close(RunSummary summary) {
  if (energy_time_ != simulation_.state().time) sample_energies();
  histories_->close();
  energies_->close();
  summary.histories = {{histories_name, histories_->rows(), columns_},
                       {energies_name, energies_->rows(), columns_of_energies()}};
  summary.outputs = {histories_name, energies_name, checkpoint_name, summary_name, request_name};
  if (frames_) summary.outputs.insert(summary.outputs.end(), {frames_name, contacts_name});
  if (bolt_frames_) summary.outputs.emplace_back(bolts_name);
  if (lining_frames_) summary.outputs.emplace_back(linings_name);
  if (options_.profile) summary.outputs.emplace_back(profile_name);
  if (peaks_ && peaks_->has_begun()) {
    const Model& model = simulation_.model();
    summary.peaks = peaks_json(model, peaks_->blocks(), peaks_->is_over());
    write_file(in_folder(peaks_name), peaks_csv(model, peaks_->blocks()));
    summary.outputs.emplace_back(peaks_name);
  }
  for (std::size_t i = 0; i < simulation_.model().stages.size(); ++i)
    if (std::filesystem::exists(in_folder(stage_file_name(i).c_str()))) summary.outputs.push_back(stage_file_name(i));
  write_summary(in_folder(summary_name), summary);
}

}  // namespace dda
