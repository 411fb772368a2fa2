#include "verification/stability/cell.h"

#include <algorithm>
#include <ctime>
#include <memory>

#include "engine/advice/remarks.h"
#include "engine/app/run_verdict.h"
#include "engine/app/run_warnings.h"
#include "engine/core/error.h"
#include "engine/scene/scene.h"
#include "engine/simulation/probes.h"
#include "engine/simulation/run_so_far.h"
#include "engine/simulation/simulation.h"

namespace verify {
namespace {

class Watcher {
 public:
  Watcher(const Setting& setting, const dda::Simulation& simulation)
      : answer_(answer_of(setting)),
        probes_(simulation),
        sample_(probes_.size()),
        begins_after_(simulation.model().stages.size() - 1) {
    look(simulation);
  }

  void look(const dda::Simulation& simulation) {
    if (dda::stages_done(simulation) < begins_after_) return;
    probes_.sample(simulation, sample_);
    answer_->look(simulation, sample_);
  }

  [[nodiscard]] std::vector<Check> checks(const dda::Simulation& simulation) const {
    return answer_->checks(simulation);
  }

 private:
  std::unique_ptr<Answer> answer_;
  dda::Probes probes_;
  std::vector<double> sample_;
  std::size_t begins_after_;  // stages: the last one moves
};

// Ended early, or with a balance that does not add up. Both must say why.
void stop(dda::Status status, const std::string& why, Cell& cell) {
  cell.outcome = why.empty() ? RunOutcome::silent : RunOutcome::stopped;
  cell.message = std::string(to_string(status)) + ": " + why;
}

// On the scene as drawn, as `dda run` has them before its first step.
std::vector<std::string> remarks_before(const dda::Simulation& simulation) {
  std::vector<std::string> remarks = dda::remarks_on(simulation.model(), simulation.contacts());
  for (std::string& remark : remarks) remark.insert(0, "remark: ");
  return remarks;
}

void judge(const dda::Simulation& simulation, const Watcher& watcher, const std::vector<std::string>& remarks,
           Cell& cell) {
  const dda::RunVerdict verdict = dda::judge_run(simulation);
  if (verdict.status != dda::Status::ok) return stop(verdict.status, verdict.message, cell);
  cell.said = dda::warnings_of(simulation);
  if (!verdict.message.empty()) cell.said.push_back(verdict.message);
  cell.said.insert(cell.said.end(), remarks.begin(), remarks.end());
  cell.checks = watcher.checks(simulation);
  if (std::ranges::all_of(cell.checks, &Check::holds))
    cell.outcome = RunOutcome::right;
  else
    cell.outcome = cell.said.empty() ? RunOutcome::silent : RunOutcome::warned;
}

void run(const Setting& setting, const std::string& scene, Cell& cell) {
  dda::Simulation simulation(dda::parse_scene(scene, "scene.json"));
  const std::vector<std::string> remarks = remarks_before(simulation);
  Watcher watcher(setting, simulation);
  while (!simulation.finished()) {
    if (const dda::Status status = simulation.step(); status != dda::Status::ok)
      return stop(status, simulation.message(), cell);
    watcher.look(simulation);
  }
  judge(simulation, watcher, remarks, cell);
}

}  // namespace

const OutcomeNames& cell_outcomes() {
  static const OutcomeNames names = {{RunOutcome::right, "correct"},
                                     {RunOutcome::warned, "warned"},
                                     {RunOutcome::stopped, "stopped"},
                                     {RunOutcome::refused, "refused"},
                                     {RunOutcome::silent, "silently wrong"}};
  return names;
}

Cell run_cell(const Setting& setting, const nlohmann::ordered_json& scene) {
  Cell cell;
  cell.setting = setting;
  const std::clock_t begin = std::clock();
  try {
    run(setting, scene.dump(), cell);
  } catch (const dda::InputError& error) {
    cell.outcome = RunOutcome::refused;
    cell.message = error.what();
  }
  cell.cpu_s = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return cell;
}

}  // namespace verify
