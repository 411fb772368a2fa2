#include <fmt/format.h>

#include <cmath>
#include <cstddef>

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
  item.positive("max open-close iterations", stage.limits.open_close_iterations);
  item.within("max step reductions", stage.limits.step_reductions, 0, 60);
}

// What `strain_inertia` must exceed for a block to have inertia in all motion. With second moments X and Y about the
// principal axes, rotation w has the inertia X + Y, shear g the factor s on (X + Y)/4, and both together the product
// (X - Y) w g, which the factor leaves as it is: s (X + Y)^2 > (X - Y)^2.
double least_strain_inertia(const AreaMoments& moments) {
  return (std::pow(moments.xx - moments.yy, 2) + std::pow(2 * moments.xy, 2)) / std::pow(moments.xx + moments.yy, 2);
}

void check_strain_inertia(const Item& item, const Model& model, const Stage& stage) {
  item.not_negative("strain inertia", stage.strain_inertia);
  if (stage.strain_inertia >= 1) return;
  double least = 0;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const double own = least_strain_inertia(model.blocks[i].moments);
    if (model.is_held(static_cast<int>(i)) || own <= least) continue;
    least = own;
    longest = i;
  }
  constexpr double round_off = 1e-9;  // of the whole inertia: a square needs none of it
  if (stage.strain_inertia > least + round_off) return;
  item.fail("strain inertia", fmt::format("{:g}", stage.strain_inertia),
            fmt::format("above {:.3g}: with less, block \"{}\", the longest for its width, has no inertia against "
                        "shearing while it turns",
                        least, model.blocks[longest].name));
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
    check_strain_inertia(item, model, model.stages[i]);
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
