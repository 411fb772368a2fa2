#include "engine/app/run_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <iterator>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/advice/remarks.h"
#include "engine/advice/ringing_weight.h"
#include "engine/app/branch_origin.h"
#include "engine/app/frame_clock.h"
#include "engine/app/idle_processes.h"
#include "engine/app/lining_report.h"
#include "engine/app/run_files.h"
#include "engine/app/run_options.h"
#include "engine/app/run_position.h"
#include "engine/app/run_request.h"
#include "engine/app/run_verdict.h"
#include "engine/app/run_warnings.h"
#include "engine/app/stage_end_report.h"
#include "engine/app/static_drag_remark.h"
#include "engine/app/stop_signal.h"
#include "engine/app/unsettled_report.h"
#include "engine/core/error.h"
#include "engine/core/parallel.h"
#include "engine/core/phase_clock.h"
#include "engine/record/folder_lock.h"
#include "engine/record/profile.h"
#include "engine/record/progress.h"
#include "engine/record/run_folder.h"
#include "engine/scene/scene.h"
#include "engine/scene/scene_parts.h"
#include "engine/simulation/branch.h"
#include "engine/simulation/probes.h"
#include "engine/simulation/run_so_far.h"
#include "engine/simulation/simulation.h"

namespace dda {
namespace {

constexpr int exit_ended_early = 3;

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double cpu_seconds() { return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC); }

class Run {
 public:
  explicit Run(const RunOptions& options)
      : options_(options),
        clock_(options.profile ? std::make_unique<PhaseClock>() : nullptr),
        setting_up_(Phase::set_up),
        scene_text_(scene_text(options.scene)),
        simulation_(simulation_of_scene()),
        begun_from_(begin_from_origin()),
        probes_(checked_probes()),
        lock_(checked_folder()),
        resumed_(position_to_resume()) {
    if (!options.from)
      for (std::string& sentence : ringing_weight(simulation_.model(), simulation_.contacts()))
        remarks_.push_back(std::move(sentence));
    phases_.emplace_back("read and set up", wall_seconds() - began_);
    setting_up_.reset();
  }

  int run(std::ostream& out, std::ostream& errors) {
    const StopSignal stop_signal(!options_.quiet && terminal() != nullptr);
    prepare_folder();
    RunFiles files(simulation_, probes_, file_options(), resumed_);
    simulation_.watch().at_end = [&] { files.at_end_of_stage(); };
    simulation_.watch().between = [&] { files.after_stage(); };
    if (!options_.quiet) announce(out);
    Status status = step_to_the_end(files);
    const RunVerdict verdict = judge_run(simulation_);
    if (status == Status::ok) status = verdict.status;
    const std::string message = reason(status, verdict);
    finish(files, status, message);
    if (!message.empty() && status != Status::stopped)
      errors << fmt::format("dda: {}: {}\n", options_.scene.string(), message);
    if (!options_.quiet) conclude(status, out);
    if (clock_) profile(out);
    if (status == Status::stopped) return 128 + StopSignal::received();
    return status == Status::ok ? 0 : exit_ended_early;
  }

 private:
  [[nodiscard]] Simulation simulation_of_scene() {
    try {
      SceneParts scene = parse_scene_parts(scene_text_, options_.scene.string(), options_.scene.parent_path());
      cut_remarks_ = std::move(scene.remarks);
      return Simulation(std::move(scene.model));
    } catch (const InputError& error) {
      throw error.in_file(options_.scene.string());
    }
  }

  [[nodiscard]] std::vector<std::string> remarks_on_scene() {
    std::vector<std::string> remarks = std::move(cut_remarks_);
    std::ranges::move(remarks_on(simulation_.model(), simulation_.contacts()), std::back_inserter(remarks));
    if (std::string remark = remark_on_idle_processes(simulation_.model()); !remark.empty())
      remarks.push_back(std::move(remark));
    return remarks;
  }

  // How many stages were done before this run.
  std::size_t begin_from_origin() {
    if (!options_.from) return 0;
    if (options_.resume) return stages_before(options_.folder);
    const BranchOrigin origin = parse_origin(*options_.from);
    if (std::filesystem::exists(options_.folder) && std::filesystem::equivalent(origin.folder, options_.folder))
      throw InputError("", "--out", options_.folder.string(), "another folder than --from");
    const Simulation settled = load_origin(origin, options_.scene.parent_path());
    try {
      begin_from(settled, simulation_);
    } catch (const InputError& error) {
      throw error.in_file(options_.scene.string());
    }
    expect_peaks_ahead();
    return stages_done(settled);
  }

  // What was not watched cannot be told.
  void expect_peaks_ahead() const {
    const Model& model = simulation_.model();
    if (!model.peaks || static_cast<std::size_t>(model.peaks->stage) >= stages_done(simulation_)) return;
    throw InputError(options_.scene.string(), "peaks.stage",
                     fmt::format("\"{}\", which is done in {}",
                                 model.stages[static_cast<std::size_t>(model.peaks->stage)].name, *options_.from),
                     "a stage that this run goes through");
  }

  [[nodiscard]] Probes checked_probes() const {
    try {
      return Probes(simulation_);
    } catch (const InputError& error) {
      throw error.in_file(options_.scene.string());
    }
  }

  // Nothing is made, not even the folder, for a run that cannot begin or go on.
  [[nodiscard]] const std::filesystem::path& checked_folder() const {
    const std::filesystem::path& folder = options_.folder;
    if (folder.empty()) throw InputError("", "--out", "empty", "a folder");
    std::error_code unknown;  // what it is, making it tells
    if (std::filesystem::exists(folder, unknown) && !std::filesystem::is_directory(folder, unknown))
      throw InputError("", "--out", folder.string() + ", which is a file", "a folder");
    if (options_.resume && !std::filesystem::exists(folder / checkpoint_name, unknown))
      throw InputError("", "--resume", "asked for without " + (folder / checkpoint_name).string(),
                       "a folder that a run has written to; begin anew without --resume");
    check_run_folder(folder);
    return folder;
  }

  std::optional<RunPosition> position_to_resume() {
    if (!options_.resume) return std::nullopt;
    expect_same_request(options_, request());
    return load_run(options_.folder / checkpoint_name, simulation_);
  }

  [[nodiscard]] nlohmann::json request() const { return run_request(options_, scene_text_, begun_from_); }

  // What `dda view` shows comes from one run: what is older goes first, and the summary of a part of this run too.
  void prepare_folder() const {
    if (resumed_) {
      std::filesystem::remove(options_.folder / summary_name);
    } else {
      clear_run_folder(options_.folder);
      write_request(options_.folder, request());
    }
  }

  [[nodiscard]] FileOptions file_options() const {
    FileOptions files{options_.folder, options_.rows_every, options_.frame_interval, options_.checkpoint_interval,
                      options_.profile};
    const double moving = moving_time(simulation_.model(), begun_from_);
    if (options_.frames) files.frame_interval = (moving > 0 ? moving : 1.0) / static_cast<double>(*options_.frames);
    return files;
  }

  void announce(std::ostream& out) const {
    const Model& model = simulation_.model();
    const bool paces_itself = std::ranges::any_of(model.stages, &Stage::paces_itself);
    out << fmt::format("{}: {} blocks, {} contacts, {} steps{}{}\n",
                       model.title.empty() ? options_.scene.string() : model.title, model.blocks.size(),
                       simulation_.contacts().interfaces.size(), steps_in_all_stages(simulation_),
                       paces_itself ? " and those of static stages that find their own" : "",
                       resumed_ ? fmt::format(", resumed after {}", simulation_.state().step) : "");
    if (options_.from && !resumed_)
      out << fmt::format("goes on from {} at {:.6g} s\n", *options_.from, simulation_.state().time);
    if (simulation_.finished()) out << "the run is over, there is nothing left to step\n";
    out << fmt::format("{}\n", fmt::join(simulation_.plan().describe(), "; "));
    for (const Stage& stage : model.stages)
      if (!stage.chosen.integrator.reason.empty())
        out << fmt::format("stage \"{}\" has {}\n", stage.name, stage.chosen.integrator.reason);
    for (const std::string& remark : remarks_) out << fmt::format("remark: {}\n", remark);
    out << std::flush;
  }

  // A run that has ended because a stage is no equilibrium has ended for whoever resumes it too.
  [[nodiscard]] Status status_at_start() const {
    return unbalanced_end(simulation_).empty() ? Status::ok : Status::not_in_equilibrium;
  }

  Status step_to_the_end(RunFiles& files) {
    Progress progress(simulation_.state().time, stage_spans(simulation_.model()).back().end_s,
                      options_.quiet ? nullptr : terminal());
    const double begin = wall_seconds();
    double writing = 0;
    Status status = status_at_start();
    while (!simulation_.finished() && status == Status::ok) {
      const std::int64_t steps_before = simulation_.state().step;
      time_before_ = simulation_.state().time;
      status = simulation_.step();
      if (simulation_.state().step > steps_before) {
        const double before_writing = wall_seconds();
        files.after_step();
        writing += wall_seconds() - before_writing;
        time_before_ = simulation_.state().time;
      }
      progress.update(simulation_.state().time, simulation_.state().step);
      if (status == Status::ok && StopSignal::received() != 0 && !simulation_.finished()) status = Status::stopped;
    }
    progress.finish(simulation_.state().time, simulation_.state().step);
    phases_.emplace_back("steps", wall_seconds() - begin - writing);
    phases_.emplace_back("write", writing);
    return status;
  }

  [[nodiscard]] std::string reason(Status status, const RunVerdict& verdict) const {
    if (status == Status::ok) return warnings(verdict.message);
    if (status == Status::stopped) return "stopped by the user; --resume goes on";
    if (status == verdict.status) return fmt::format("{}: {}", to_string(status), verdict.message);
    return fmt::format("{} after step {} at {:.6g} s: {}", to_string(status), simulation_.state().step,
                       simulation_.state().time,
                       status == Status::not_in_equilibrium ? unbalanced_end(simulation_) : simulation_.message());
  }

  [[nodiscard]] std::string warnings(const std::string& energy_warning) const {
    std::vector<std::string> warnings = warnings_of(simulation_);
    if (!energy_warning.empty()) warnings.insert(warnings.begin(), energy_warning);
    return fmt::format("{}", fmt::join(warnings, "; "));
  }

  void finish(RunFiles& files, Status status, const std::string& message) {
    // A step that failed half-way leaves a state between steps, from which a run cannot go on: the last checkpoint
    // stays.
    if (simulation_.state().time == time_before_) files.write_checkpoint();
    if (status != Status::ok && status != Status::stopped) files.write_last_state();
    files.close(summary(status, message));
  }

  [[nodiscard]] RunSummary summary(Status status, const std::string& message) const {
    RunSummary summary;
    summary.status = status;
    summary.message = message;
    summary.title = simulation_.model().title;
    summary.from = options_.from.value_or("");
    summary.time_s = simulation_.state().time;
    summary.steps = simulation_.state().step;
    summary.counters = simulation_.counters();
    summary.energy = simulation_.energy();
    for (const EnergyLedger& energy : energy_at_ends_of_stages(simulation_))
      summary.energy_at_end.emplace_back(simulation_.model().stages[summary.energy_at_end.size()].name, energy);
    summary.cpu_s = cpu_seconds();
    summary.wall_s = wall_seconds() - began_;
    summary.phases = phases_;
    summary.stages = stage_spans(simulation_.model());
    for (std::size_t i = 0; i < summary.stages.size(); ++i)
      summary.stages[i].stable_dt_s = simulation_.stability_limit(i);
    summary.out_of_balance = static_stages();
    const StepPlan& plan = simulation_.plan();
    summary.solver = plan.explicit_steps ? "explicit" : to_string(plan.solver);
    summary.blocks =
        static_cast<std::int64_t>(simulation_.model().blocks.size()) - std::ranges::count(simulation_.absent(), true);
    summary.contacts = static_cast<std::int64_t>(simulation_.contacts().interfaces.size());
    summary.loose_blocks = unbalanced_json(simulation_.results().loose, simulation_.model());
    summary.blocks_out_of_balance = unbalanced_json(simulation_.results().unbalanced, simulation_.model());
    summary.energy_release_rates = energy_release_rates_json(simulation_);
    summary.excess_shear = excess_shear_json(simulation_);
    summary.penetration = penetration();
    if (!linings_of(simulation_).empty()) summary.linings = linings_json(simulation_);
    summary.unsettled_steps = unsettled_json(simulation_);
    summary.remarks = remarks_;
    std::ranges::move(remarks_at_end(), std::back_inserter(summary.remarks));
    return summary;
  }

  [[nodiscard]] std::vector<std::string> remarks_at_end() const {
    std::vector<std::string> remarks{unasked_balance_remark(simulation_), static_drag_remark(simulation_),
                                     unsettled_remark(simulation_)};
    std::erase(remarks, "");
    return remarks;
  }

  [[nodiscard]] std::optional<DeepestPenetration> penetration() const {
    const Penetration& deepest = simulation_.deepest_penetration();
    if (deepest.block_a < 0) return std::nullopt;
    const auto name = [&](int block) { return simulation_.model().blocks[static_cast<std::size_t>(block)].name; };
    return DeepestPenetration{
        deepest.depth, deepest.share, {name(deepest.block_a), name(deepest.block_b)}, deepest.time};
  }

  // Static stages that are over, and how far from equilibrium they left the blocks.
  [[nodiscard]] std::vector<std::pair<std::string, double>> static_stages() const {
    std::vector<std::pair<std::string, double>> stages;
    for (std::size_t i = 0; i < simulation_.model().stages.size(); ++i)
      if (const double share = simulation_.results().out_of_balance[i]; !std::isnan(share))
        stages.emplace_back(simulation_.model().stages[i].name, share);
    return stages;
  }

  void conclude(Status status, std::ostream& out) const {
    for (const auto& [name, share] : static_stages())
      out << fmt::format("static stage \"{}\": forces out of balance by {:.1e} of the largest force\n", name, share);
    out << unbalanced_lines(simulation_);
    for (const std::string& remark : remarks_at_end()) out << "remark: " << remark << '\n';
    out << fmt::format("{}: {} steps to {:.6g} s in {:.3g} s, energy residual {:.1e}; results in {}\n",
                       to_string(status), simulation_.state().step, simulation_.state().time, wall_seconds() - began_,
                       simulation_.energy().relative_residual(), options_.folder.string());
  }

  void profile(std::ostream& out) const {
    write_profile(options_.folder / profile_name, *clock_, simulation_.counters());
    if (!options_.quiet) out << profile_table(*clock_, simulation_.counters());
  }

  double began_ = wall_seconds();
  const RunOptions& options_;
  std::unique_ptr<PhaseClock> clock_;  // only of runs that are profiled
  std::optional<PhaseScope> setting_up_;
  std::string scene_text_;
  std::vector<std::string> cut_remarks_;
  Simulation simulation_;
  // On the scene as drawn, whose contacts are there only before the run goes on from anywhere else.
  std::vector<std::string> remarks_ = remarks_on_scene();
  std::size_t begun_from_;  // stages
  Probes probes_;
  FolderLock lock_;
  std::optional<RunPosition> resumed_;
  double time_before_ = simulation_.state().time;  // s, at the end of the last whole step
  std::vector<std::pair<std::string, double>> phases_;
};

}  // namespace

int run_scene(const RunOptions& options, std::ostream& out, std::ostream& errors) {
  const ThreadsInUse threads(options.threads > 0 ? options.threads : cores());
  std::optional<Run> run;
  {
    const PassingLine line("reading and setting up " + options.scene.string(), options.quiet ? nullptr : terminal());
    run.emplace(options);
  }
  return run->run(out, errors);
}

}  // namespace dda
