#include "engine/safety/standing.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/model/free_field_side.h"
#include "engine/model/rock_change.h"
#include "engine/simulation/simulation.h"

namespace dda {
namespace {

Stage static_stage(const char* name, double duration, bool unlimited_strength) {
  Stage stage;
  stage.name = name;
  stage.integrator = static_integrator();
  stage.duration = duration;
  stage.equilibrium = 1e-9;
  stage.unlimited_strength = unlimited_strength;
  return stage;
}

// All that the model's own stages remove.
std::vector<int> removed_blocks(const Model& model) {
  std::vector<int> blocks;
  for (const Stage& stage : model.stages)
    blocks.insert(blocks.end(), stage.removal.blocks.begin(), stage.removal.blocks.end());
  return blocks;
}

// In sizes of the blocks: the square root of their areas.
double largest_share(const Model& model, const std::vector<Vec2>& movement) {
  double largest = 0;
  for (std::size_t block = 0; block < movement.size(); ++block)
    largest = std::max(largest, movement[block].norm() / std::sqrt(model.blocks[block].moments.area));
  return largest;
}

// Follows what the blocks do from the end of the first stage on.
class Watch {
 public:
  explicit Watch(const Simulation& simulation) : simulation_(simulation) {}

  void look() {
    const State& state = simulation_.state();
    if (start_.empty() && is_loaded()) start_ = state.displacement;
    standing_.movement.assign(state.displacement.size(), Vec2::Zero());
    for (std::size_t block = 0; block < start_.size(); ++block)
      standing_.movement[block] = (state.displacement[block] - start_[block]).head<2>();
    standing_.largest_movement = largest_share(simulation_.model(), standing_.movement);
  }

  [[nodiscard]] bool has_failed() const { return standing_.largest_movement > movement_of_failure; }

  Standing judge(Status status) {
    const std::vector<UnbalancedBlock> loose = loose_while_stuck();
    standing_.status = status;
    standing_.is_loaded = is_loaded() && loose.empty() && is_balanced_while_stuck();
    standing_.stands = status == Status::ok && standing_.is_loaded && !has_failed();
    if (!standing_.stands) standing_.reason = reason(loose);
    return std::move(standing_);
  }

 private:
  [[nodiscard]] bool is_loaded() const { return !std::isnan(simulation_.results().out_of_balance.front()); }

  [[nodiscard]] bool is_balanced_while_stuck() const {
    return std::ranges::none_of(simulation_.results().unbalanced,
                                [](const UnbalancedBlock& block) { return block.stage == 0; });
  }

  [[nodiscard]] std::vector<UnbalancedBlock> loose_while_stuck() const {
    std::vector<UnbalancedBlock> loose = simulation_.results().loose;
    std::erase_if(loose, [](const UnbalancedBlock& block) { return block.stage > 0; });
    return loose;
  }

  [[nodiscard]] std::string reason(const std::vector<UnbalancedBlock>& loose) const {
    if (!loose.empty()) return "nothing holds " + named_with_places(simulation_.model(), loose);
    return has_failed() ? "blocks move" : simulation_.message();
  }

  const Simulation& simulation_;
  std::vector<Vec6> start_;  // displacements at the end of the first stage; empty before
  Standing standing_;
};

// Those that act in the end, on walls that are there from our second stage on.
template <typename Load>
void keep_last_loads(std::size_t stages, std::vector<Load>& loads) {
  std::erase_if(loads, [stages](const Load& load) { return load.stages.is_over_in(stages - 1); });
  for (Load& load : loads) load.stages = {std::min(load.stages.first, 1), -1};
}

}  // namespace

Standing standing_of(Model model, double time, const std::stop_token& stop) {
  refuse_free_field_sides(model);
  Stage stand = static_stage("stand", 0, false);
  stand.removal.blocks = removed_blocks(model);
  const RockOfStage last{materials_in(model, model.stages.size()), joints_in(model, model.stages.size())};
  keep_last_loads(model.stages.size(), model.point_loads);
  keep_last_loads(model.stages.size(), model.edge_loads);
  model.materials = last.materials;
  model.joints = last.joints;
  model.stages = {static_stage("load", time, true), stand};
  for (Bolt& bolt : model.bolts) bolt.first_stage = 0;
  for (Bolt& bolt : model.bolts) bolt.withdrawal = {};
  for (Lining& lining : model.linings) lining.withdrawal = {};
  for (Lining& lining : model.linings) lining.first_stage = std::min(lining.first_stage, 1);  // on walls that are there
  model.peaks.reset();
  finish_model(model);
  Simulation simulation(std::move(model));
  Watch watch(simulation);
  Status status = Status::ok;
  while (!simulation.finished() && status == Status::ok && !watch.has_failed() && !stop.stop_requested()) {
    status = simulation.step();
    watch.look();
  }
  return watch.judge(status);
}

}  // namespace dda
