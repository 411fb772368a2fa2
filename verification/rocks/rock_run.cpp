#include "verification/rocks/rock_run.h"

#include <algorithm>
#include <ctime>

#include "engine/app/run_verdict.h"
#include "engine/app/run_warnings.h"
#include "engine/core/error.h"
#include "engine/model/current_outline.h"
#include "engine/scene/scene.h"
#include "engine/simulation/run_so_far.h"
#include "engine/simulation/simulation.h"
#include "verification/rocks/rock_checks.h"

namespace verify {
namespace {

using dda::Simulation;
using dda::Status;

class Stopwatch {
 public:
  [[nodiscard]] double seconds() const { return static_cast<double>(std::clock() - begin_) / CLOCKS_PER_SEC; }

 private:
  std::clock_t begin_ = std::clock();
};

void add_checks(const std::string& when, std::vector<Check> checks, RockResult& result) {
  for (Check& check : checks) {
    check.what += ", " + when;
    result.checks.push_back(std::move(check));
  }
}

void judge(const Simulation& simulation, double motion, RockResult& result) {
  add_checks("moved", moved_checks(simulation, motion), result);
  const dda::RunVerdict verdict = dda::judge_run(simulation);
  result.said = dda::warnings_of(simulation);
  if (!verdict.message.empty()) result.said.push_back(verdict.message);
  if (verdict.status != Status::ok) {
    result.outcome = RunOutcome::stopped;
    result.message = std::string(to_string(verdict.status)) + ": " + verdict.message;
    return;
  }
  const bool holds = std::ranges::all_of(result.checks, &Check::holds);
  result.outcome = holds ? RunOutcome::right : result.said.empty() ? RunOutcome::silent : RunOutcome::warned;
}

void end_early(RunOutcome outcome, const std::string& why, RockResult& result) {
  result.outcome = outcome;
  result.message = why;
}

void take_picture(const Simulation& simulation, RockPicture* picture) {
  if (picture == nullptr) return;
  const dda::Model& model = simulation.model();
  picture->moved = dda::current_outlines(model, simulation.state());
  picture->is_loose.assign(model.blocks.size(), false);
  for (const dda::UnbalancedBlock& loose : simulation.results().loose)
    picture->is_loose[static_cast<std::size_t>(loose.block)] = true;
  picture->drawn.clear();
  picture->is_held.clear();
  picture->is_removed.clear();
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    picture->drawn.push_back(model.blocks[i].shape);
    picture->is_held.push_back(model.is_held(static_cast<int>(i)));
    picture->is_removed.push_back(!simulation.absent().empty() && simulation.absent()[i]);
  }
}

void note(const Simulation& simulation, RockResult& result) {
  result.blocks = simulation.model().blocks.size();
  result.loose = simulation.results().loose.size();
  result.steps = simulation.state().step;
  result.passes = simulation.counters().open_close_iterations;
}

// True when it came to its end.
bool go_through(const Stopwatch& watch, double seconds, Simulation& simulation, RockResult& result) {
  while (!simulation.finished()) {
    if (const Status status = simulation.step(); status != Status::ok) {
      end_early(RunOutcome::stopped, std::string(to_string(status)) + ": " + simulation.message(), result);
      return false;
    }
    if (watch.seconds() > seconds) {
      end_early(RunOutcome::late, dda::stages_done(simulation) == 0 ? "still settling" : "still moving", result);
      return false;
    }
  }
  return true;
}

void run(const RandomRock& rock, double seconds, const Stopwatch& watch, RockPicture* picture, RockResult& result) {
  Simulation simulation(dda::parse_scene(rock.scene, "scene.json"));
  simulation.watch().between = [&] {
    if (dda::stages_done(simulation) != 1) return;
    result.settling_s = watch.seconds();
    add_checks("settled", settled_checks(simulation), result);
  };
  if (go_through(watch, seconds, simulation, result)) judge(simulation, rock.motion, result);
  note(simulation, result);
  take_picture(simulation, picture);
}

}  // namespace

const OutcomeNames& rock_outcomes() {
  static const OutcomeNames names = {{RunOutcome::right, "right"},     {RunOutcome::stopped, "stopped"},
                                     {RunOutcome::refused, "refused"}, {RunOutcome::late, "late"},
                                     {RunOutcome::warned, "warned"},   {RunOutcome::silent, "wrong"}};
  return names;
}

RockResult run_rock(const RandomRock& rock, double seconds, RockPicture* picture) {
  RockResult result;
  result.outcome = RunOutcome::right;
  result.seed = rock.seed;
  result.kind = rock.kind;
  const Stopwatch watch;
  try {
    run(rock, seconds, watch, picture, result);
  } catch (const dda::InputError& error) {
    end_early(RunOutcome::refused, error.what(), result);
  }
  result.cpu_s = watch.seconds();
  return result;
}

}  // namespace verify
