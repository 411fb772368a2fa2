#include "engine/model/check_parts.h"
#include "engine/model/checks.h"
#include "engine/model/explicit_conditions.h"

namespace dda::model_checks {
namespace {

void check_integrator(const Item& item, const Integrator& integrator) {
  item.not_negative("integrator beta", integrator.beta);
  if (integrator.is_explicit() && (integrator.gamma != 0.5 || integrator.alpha_m != 0 || integrator.alpha_f != 0))
    item.fail("integrator beta", "0", "a positive number, or central differences: gamma 1/2 and no alpha");
  item.within("integrator gamma", integrator.gamma, 0, 2);
  item.within("integrator alpha_m", integrator.alpha_m, -1, 0.5);
  item.within("integrator alpha_f", integrator.alpha_f, 0, 0.5);
}

void check_stage(const Item& item, const Stage& stage) {
  constexpr double most_steps = 1e12;  // far beyond what a run can do, far below where step counts lose exactness
  if (stage.integrator.is_static && stage.paces_itself()) {
    item.not_negative("duration", stage.duration);
    item.positive("equilibrium", stage.equilibrium);  // what ends it
  } else {
    item.positive("dt", stage.dt);
    item.positive("duration", stage.duration);
    item.within("duration in steps", stage.duration / stage.dt, 0.5, most_steps);
  }
  check_integrator(item, stage.integrator);
  item.within("velocity factor", stage.velocity_factor, 0, 1);
  item.not_negative("damping rate", stage.damping_rate);
  item.not_negative("mass damping", stage.material_damping.mass);
  item.not_negative("stiffness damping", stage.material_damping.stiffness);
  item.within("equilibrium", stage.equilibrium, 0, 1);
  item.not_negative("strain inertia", stage.strain_inertia);
  item.positive("max open-close iterations", stage.max_open_close_iterations);
  item.within("max step reductions", stage.max_step_reductions, 0, 60);
}

void check_explicit_stage(const Item& item, const Model& model, const Stage& stage) {
  if (const auto obstacle = explicit_obstacle(model, stage))
    item.fail("integrator", "\"central_difference\" " + obstacle->where, obstacle->expected);
}

}  // namespace

void check_stages(const Model& model) {
  for (std::size_t i = 0; i < model.stages.size(); ++i) {
    const Item item("stages", i, model.stages[i].name);
    check_stage(item, model.stages[i]);
    if (model.stages[i].integrator.is_explicit()) check_explicit_stage(item, model, model.stages[i]);
    if (model.stages[i].material_damping.acts() && !model.stays_linear())
      item.fail("damping", "given",
                "none: it is for scenes without bolts, whose joints are all bonded and whose stages all "
                "have small kinematics; elsewhere there are damping_rate and contact_damping");
    if (model.stages[i].paces_itself() && !model.free_field_sides.empty())
      item.fail("dt", "left out", "a time step: beside free-field sides columns are stepped along");
  }
}

}  // namespace dda::model_checks
