#include "engine/reaction/unloading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "engine/core/error.h"
#include "engine/model/free_field_side.h"
#include "engine/simulation/loads_in_joints.h"

namespace dda {
namespace {

// s, of the last stage. It is a fade that a static stage has behind it from its first step on; the time is so short
// that nothing else changes in it.
constexpr double fade = 1e-6;
constexpr double asked_balance = 1e-9;  // as of static stages that find their own steps

Stage static_stage(const std::string& name, const Stage& like) {
  Stage stage;
  stage.name = name;
  stage.integrator = static_integrator();
  stage.kinematics = like.kinematics;
  stage.solver = like.solver;
  stage.equilibrium = like.integrator.is_static && like.equilibrium > 0 ? like.equilibrium : asked_balance;
  stage.unlimited_strength = like.integrator.is_static && like.unlimited_strength;
  stage.limits.open_close_iterations = like.limits.open_close_iterations;
  stage.limits.step_reductions = like.limits.step_reductions;
  return stage;
}

bool has(const std::vector<int>& blocks, int block) { return std::ranges::find(blocks, block) != blocks.end(); }

std::string blocks_counted(std::size_t count) { return fmt::format("{} block{}", count, count == 1 ? "" : "s"); }

// Returns the stage that takes the opening out, or the number of stages where none does.
std::size_t stage_of(const std::vector<int>& opening, const Model& model) {
  const auto is_of_opening = [&](int block) { return has(opening, block); };
  for (std::size_t i = 0; i < model.stages.size(); ++i) {
    const auto common = static_cast<std::size_t>(std::ranges::count_if(model.stages[i].removal.blocks, is_of_opening));
    if (common == 0) continue;
    if (common != opening.size())
      throw InputError("", "the opening",
                       fmt::format("of {}, of which stage \"{}\" removes {}", blocks_counted(opening.size()),
                                   model.stages[i].name, common),
                       "one that a single stage removes");
    return i;
  }
  return model.stages.size();
}

// What the stage that takes the opening out removes beside it.
std::vector<int> removed_with(const std::vector<int>& opening, const Stage& stage) {
  std::vector<int> others = stage.removal.blocks;
  std::erase_if(others, [&](int block) { return has(opening, block); });
  return others;
}

// Returns how many of the scene's own stages are kept.
int keep_stages_in_situ(const std::vector<int>& opening, Model& model) {
  std::size_t kept = stage_of(opening, model);
  const bool is_taken_out = kept < model.stages.size();
  const Stage like = is_taken_out ? model.stages[kept] : model.stages.front();
  if (!is_taken_out) {
    const auto moves = [](const Stage& stage) { return !stage.integrator.is_static || !stage.removal.blocks.empty(); };
    kept = static_cast<std::size_t>(std::ranges::find_if(model.stages, moves) - model.stages.begin());
  }
  model.stages.resize(kept);
  if (model.stages.empty()) model.stages.push_back(static_stage("in situ", like));
  // The stage by which weight and stress get into the rock may be one of unlimited strength. Where the scene does not
  // say itself what comes then, the joints get their own strength before the opening is made: its curve is that of rock
  // that slides.
  if (!is_taken_out && model.stages.back().unlimited_strength) {
    model.stages.push_back(static_stage("own strength", model.stages.back()));
    model.stages.back().unlimited_strength = false;
  }
  Stage last = static_stage(is_taken_out ? like.name : "opening", is_taken_out ? like : model.stages.back());
  last.duration = fade;
  last.removal = {is_taken_out ? like.removal.blocks : opening, fading_to(1)};
  if (is_taken_out) last.rock = like.rock;
  model.stages.push_back(std::move(last));
  return static_cast<int>(kept);
}

// What is put in with the first stage that is not kept, or later. What is there from the beginning stays, also where
// no stage is kept.
template <typename Support>
void leave_out_support(int kept, std::vector<Support>& supports, std::vector<std::string>& names) {
  const auto is_late = [kept](const Support& support) { return support.first_stage >= std::max(kept, 1); };
  for (const Support& support : supports)
    if (is_late(support)) names.push_back(support.name);
  std::erase_if(supports, is_late);
}

// What the scene lets go of with the opening or later holds the rock while the opening is made. By number of stage that
// is any that is not kept: a stage of ours has the number of one of those.
void keep_if_let_go_later(int kept, PointSupport& support) {
  if (support.last_stage < kept) return;
  support.last_stage = -1;
  support.takes_force_along = false;
}

template <typename Support>
void keep_if_taken_out_later(int kept, std::vector<Support>& supports) {
  for (Support& support : supports)
    if (support.withdrawal.last_stage >= kept) support.withdrawal = {};
}

// Loads that come with the opening or later, as a pressure on its wall, are support as well.
template <typename Load>
void leave_out_late_loads(int kept, const Model& model, std::vector<Load>& loads, std::vector<std::string>& names) {
  const auto is_late = [kept](const Load& load) { return load.stages.first >= std::max(kept, 1); };
  const auto late = std::ranges::find_if(loads, is_late);
  if (late == loads.end()) return;
  names.push_back(fmt::format("the load on \"{}\"", model.blocks[static_cast<std::size_t>(late->block)].name));
  std::erase_if(loads, is_late);
}

template <typename Load>
void keep_if_over_later(int kept, std::vector<Load>& loads) {
  for (Load& load : loads)
    if (load.stages.last >= kept) load.stages.last = -1;
}

// Water in the joints of an opening that no stage of the scene takes out goes with it.
void end_with_last_stage_in_situ(const std::vector<int>& opening, Model& model) {
  const std::vector<bool> in_joints = loads_in_joints_of(opening, model);
  const auto opened = static_cast<std::size_t>(model.stages.size() - 1);
  for (std::size_t i = 0; i < in_joints.size(); ++i) {
    StageSpan& stages = model.edge_loads[i].stages;
    if (in_joints[i] && stages.has(opened)) stages.last = static_cast<int>(opened) - 1;
  }
}

}  // namespace

TimeFunction fading_to(double share) { return PiecewiseLinear{{0, fade / 2}, {1, share}}; }

Unloading unloading_of(Model model, const std::vector<int>& opening) {
  refuse_free_field_sides(model);
  Unloading unloading;
  const bool scene_takes_it_out = stage_of(opening, model) < model.stages.size();
  const int kept = keep_stages_in_situ(opening, model);
  unloading.removed_with_it = removed_with(opening, model.stages.back());
  leave_out_support(kept, model.bolts, unloading.left_out);
  leave_out_support(kept, model.linings, unloading.left_out);
  leave_out_late_loads(kept, model, model.point_loads, unloading.left_out);
  leave_out_late_loads(kept, model, model.edge_loads, unloading.left_out);
  keep_if_over_later(kept, model.point_loads);
  keep_if_over_later(kept, model.edge_loads);
  if (!scene_takes_it_out) end_with_last_stage_in_situ(opening, model);
  keep_if_taken_out_later(kept, model.bolts);
  keep_if_taken_out_later(kept, model.linings);
  for (PointSupport& support : model.supports) keep_if_let_go_later(kept, support);
  std::erase_if(model.viscous_edges, [kept](const ViscousEdge& edge) { return edge.first_stage > kept; });
  model.measurements.clear();
  model.peaks.reset();
  finish_model(model);
  unloading.model = std::move(model);
  return unloading;
}

}  // namespace dda
