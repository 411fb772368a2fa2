#include "engine/model/explicit_conditions.h"

#include "engine/model/rock_change.h"

namespace dda {

std::optional<ExplicitObstacle> explicit_obstacle(const Model& model, const Stage& stage) {
  if (!model.stays_linear())
    return {{"where blocks can part or move far",
             "another one: it is for scenes without bolts, whose joints are all bonded and whose stages all have small "
             "kinematics"}};
  if (stage.material_damping.stiffness > 0)
    return {{"with damping in proportion to stiffness",
             "no \"damping\" (there is \"damping_rate\"), or another integrator"}};
  if (changes_materials(model)) return {{"where a stage changes materials", "another one"}};
  if (changes_springs(model)) return {{"where a stage changes springs of joints", "another one"}};
  if (!model.linings.empty()) return {{"with linings", "another one"}};
  if (!model.free_field_sides.empty()) return {{"beside free-field sides", "another one"}};
  if (!stage.lateral_inertia)
    return {{"with lateral_inertia false", "true: strains without inertia need implicit steps"}};
  if (stage.strain_inertia == 0) return {{"with strain inertia 0", "a positive one"}};
  return std::nullopt;
}

}  // namespace dda
