#include "engine/simulation/integrator_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/model/explicit_conditions.h"
#include "engine/simulation/block_terms.h"
#include "engine/simulation/stability_limit.h"
#include "engine/simulation/stage_cost.h"
#include "engine/simulation/system_matrix.h"
#include "engine/waves/wave_corrections.h"

namespace dda {
namespace {

constexpr double least_share_saved = 1.0 / 3;
constexpr double least_saved = 0.1;        // s of CPU time
constexpr double set_up_per_block = 5e-6;  // s: matrices for the limit of stability, and products with them
constexpr double least_softened = 0.9;     // share of the interfaces
constexpr double close_to_limit = 0.95;    // a dt that is left to the engine
constexpr double most_per_block = 5e-6;    // s: no implicit step costs more, whatever its solver

std::string seconds_in_words(double implicit, double explicit_steps) {
  return fmt::format("roughly {:.2g} s of CPU time in place of {:.2g} s", explicit_steps, implicit);
}

// Whether so little is stepped that nothing can be saved: known before matrices are analysed, which small scenes need
// not pay for.
bool is_soon_done(const Model& model, const Stage& stage) {
  return static_cast<double>(stage.steps()) * static_cast<double>(model.blocks.size()) * most_per_block < least_saved;
}

// Whether the run begins in motion. Settling ends it.
bool begins_in_motion(const Model& model, std::size_t index) {
  const auto before = std::span(model.stages).first(index);
  if (std::ranges::any_of(before, [](const Stage& stage) { return stage.integrator.is_static; })) return false;
  return !std::ranges::all_of(model.blocks, &Block::starts_at_rest);
}

// Whether a load acts on a point of a block while nothing of the sort acts on its neighbours.
bool loads_single_blocks(const Model& model, const ContactSet& contacts) {
  if (model.point_loads.empty()) return false;
  std::vector<bool> is_loaded(model.blocks.size(), false), is_alone(model.blocks.size(), true);
  for (const PointLoad& load : model.point_loads) is_loaded[static_cast<std::size_t>(load.block)] = true;
  for (const Interface& interface : contacts.interfaces) {
    const auto a = static_cast<std::size_t>(interface.block_a), b = static_cast<std::size_t>(interface.block_b);
    if (is_loaded[a] && is_loaded[b]) is_alone[a] = is_alone[b] = false;
  }
  return std::ranges::any_of(model.point_loads,
                             [&](const PointLoad& load) { return is_alone[static_cast<std::size_t>(load.block)]; });
}

// Why errors might be larger with explicit steps; empty where they are not. Waves of a few blocks, which no mesh
// carries, are damped by long implicit steps and by no explicit ones: they stay out where single blocks send them out.
std::string doubt_about_errors(const Model& model, std::size_t index, const ContactSet& contacts) {
  const Stage& stage = model.stages[index];
  const Stage acting = model.with_acting_corrections(stage);
  if (!acting.correct_block_dispersion || !acting.correct_time_dispersion || stage.strain_inertia != 1)
    return "its waves are not corrected for blocks and time steps";
  if (std::ranges::any_of(contacts.elements.kinds(), [](const auto& each) { return each.law == InterfaceLaw::cubic; }))
    return "along chains of cubic joints they gain nothing";
  if (begins_in_motion(model, index)) return "waves of a few blocks, with which motion begins, would ring on";
  if (loads_single_blocks(model, contacts)) return "waves of a few blocks around a loaded point would ring on";
  if (share_softened_for_steps(model, stage, contacts) >= least_softened) return "";
  return "too many joints lie between unlike or concave blocks";
}

class StageChoice {
 public:
  // `factored`: the size of the scene with its factor, which the first stage that asks for it fills in for all.
  StageChoice(std::size_t index, const ContactSet& contacts, std::optional<SceneSize>& factored, Model& model)
      : model_(model), index_(index), contacts_(contacts), factored_(factored) {}

  // Decides, and writes it into the stage. Returns a stable dt, 0 where steps stay implicit.
  double make() {
    Stage& stage = model_.stages[index_];
    const char* const saves_too_little = "as explicit ones would save too little";
    if (is_soon_done(model_, stage)) return stay_implicit(saves_too_little, stage);
    const std::string doubt = doubt_about_errors(model_, index_, contacts_);
    if (!doubt.empty()) return stay_implicit("as " + doubt, stage);
    find_costs(stage);
    StepsInQuestion steps{stage.dt, dt_that_pays(stage)};
    if (steps.least > stage.dt) return stay_implicit(saves_too_little, stage);
    if (may_be_shortened(stage)) {
      steps.close = close_to_limit;
    } else {
      steps.least = stage.dt;
    }
    const Integrator implicit = std::exchange(stage.integrator, central_difference_integrator());
    const double stable = stable_step(model_, index_, contacts_, steps);
    if (stable > 0) return become_explicit(stable, stage);
    stage.integrator = implicit;
    return stay_implicit("as explicit ones would not be stable at a length that pays", stage);
  }

 private:
  // What damps velocities once a step damps more in shorter ones.
  static bool may_be_shortened(const Stage& stage) { return stage.chosen.dt.automatic && stage.velocity_factor == 1; }

  static double stay_implicit(const std::string& why, Stage& stage) {
    stage.chosen.integrator.reason = "implicit steps, " + why;
    return 0;
  }

  double become_explicit(double stable, Stage& stage) const {
    if (stage.dt > stable) {
      shorten_to(stable, stage);
      stage.chosen.dt.reason = fmt::format("explicit steps, which are stable up to {:.3g} s here", stable);
    }
    stage.chosen.integrator.reason =
        "explicit steps, " + seconds_in_words(implicit_, set_up_ + stage.duration / stage.dt * explicit_step_);
    return stable;
  }

  void find_costs(const Stage& stage) {
    SceneSize size;
    size.blocks = static_cast<std::int64_t>(model_.blocks.size());
    size.interfaces = static_cast<std::int64_t>(contacts_.interfaces.size());
    size.coupled_pairs = size.interfaces;
    const StiffnessNumbers chi = stiffness_numbers(contacts_, make_block_terms(model_, stage), stage.dt);
    StepPlan plan = make_plan(model_, index_, contacts_, static_cast<int>(size.coupled_pairs), chi);
    if (!is_iterative(plan.solver)) {
      if (!factored_) factored_ = size_of(contacts_, make_system_matrix(static_cast<int>(size.blocks), contacts_));
      size = *factored_;
    }
    implicit_ = cost_of(size, plan, stage.steps()).seconds;
    plan.explicit_steps = true;
    explicit_step_ = cost_of(size, plan, 1).seconds;
    set_up_ = set_up_per_block * static_cast<double>(size.blocks);
  }

  // The shortest; infinite where none does.
  [[nodiscard]] double dt_that_pays(const Stage& stage) const {
    const double most = std::min((1 - least_share_saved) * implicit_, implicit_ - least_saved) - set_up_;
    if (most <= 0) return std::numeric_limits<double>::infinity();
    return stage.duration * explicit_step_ / most;
  }

  Model& model_;
  std::size_t index_;
  const ContactSet& contacts_;
  std::optional<SceneSize>& factored_;
  double implicit_ = 0, explicit_step_ = 0, set_up_ = 0;  // s: of the stage, of a step, before the first one
};

}  // namespace

std::vector<double> choose_integrators(const ContactSet& contacts, Model& model) {
  std::vector<double> stable(model.stages.size(), 0);
  std::optional<SceneSize> factored;
  for (std::size_t i = 0; i < stable.size(); ++i) {
    const Stage& stage = model.stages[i];
    const bool is_open =
        stage.chosen.integrator.automatic && !stage.integrator.is_static && !stage.integrator.is_explicit();
    if (is_open && !explicit_obstacle(model, stage)) stable[i] = StageChoice(i, contacts, factored, model).make();
  }
  return stable;
}

}  // namespace dda
