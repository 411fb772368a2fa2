#include "engine/advice/stages_on_the_way.h"

#include <algorithm>
#include <vector>

#include "engine/model/rock_change.h"
#include "engine/model/stage_times.h"

namespace dda {
namespace {

bool have_same_steps(const Model& model, std::size_t a, std::size_t b) {
  const Stage& one = model.stages[a];
  const Stage& other = model.stages[b];
  const auto figures = [](const Stage& stage) {
    const Integrator& steps = stage.integrator;
    return std::vector<double>{stage.dt,
                               steps.beta,
                               steps.gamma,
                               steps.alpha_m,
                               steps.alpha_f,
                               static_cast<double>(steps.is_static),
                               static_cast<double>(stage.kinematics),
                               stage.velocity_factor,
                               stage.damping_rate,
                               stage.material_damping.mass,
                               stage.material_damping.stiffness,
                               stage.strain_inertia,
                               static_cast<double>(stage.correct_block_dispersion),
                               static_cast<double>(stage.correct_time_dispersion),
                               static_cast<double>(stage.lateral_inertia)};
  };
  return figures(one) == figures(other);
}

// Whether rock or what joins it is another one, or another part of it is there. Strengths are judged with the joints.
bool has_other_rock(const Model& model, std::size_t a, std::size_t b) {
  const auto same = [](const Material& one, const Material& other) {
    return have_same_moduli(one, other) && have_same_density(one, other);
  };
  return !std::ranges::equal(materials_in(model, a), materials_in(model, b), same) ||
         !std::ranges::equal(joints_in(model, a), joints_in(model, b), have_same_springs);
}

}  // namespace

std::string why_steps_change(const Model& model, std::size_t stage, const SceneLoad& load, double window) {
  const double from = load.history.start, to = std::min(from + window, end_of_run(model));
  if (has_other_rock(model, 0, stage)) return "the rock is another one by then than the run begins with";
  double begin = 0;
  for (std::size_t i = 0; i < model.stages.size(); ++i) {
    const double end = begin + model.stages[i].duration;
    const double overlap = std::min(end, to) - std::max(begin, from);
    if (i != stage && overlap > model.stages[stage].dt / 2) {
      if (!have_same_steps(model, i, stage)) return "the wave is on its way in a stage of other steps as well";
      if (has_other_rock(model, i, stage) || model.absent_in(i) != model.absent_in(stage))
        return "the wave is on its way in a stage of other rock as well";
    }
    begin = end;
  }
  return "";
}

}  // namespace dda
