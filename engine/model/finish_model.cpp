#include "engine/model/finish_model.h"

#include <algorithm>
#include <utility>

#include "engine/core/error.h"
#include "engine/core/principal_stress.h"
#include "engine/model/check_parts.h"
#include "engine/model/extent.h"
#include "engine/model/model.h"
#include "engine/model/moving_stages.h"
#include "engine/model/rock_change.h"
#include "engine/model/step_choice.h"

namespace dda {
namespace {

// Coordinates carry a round-off of 1e-16 of the extent; those that were computed on the way a little more. The extent
// is the diameter, which is the same whichever way the scene is turned: ends that just touch are told by it.
constexpr double tolerance_of_extent = 1e-9;

void fill_geometry(Model& model) {
  model.blocks.shrink_to_fit();  // they are all there, and stay for the whole run
  for (Block& block : model.blocks) {
    block.shape = normalized(std::move(block.shape));
    block.moments = area_moments(block.shape);
  }
  const double size = diameter(model);
  model.length_tolerance = tolerance_of_extent * size;
  model.origin = local_origin(model, size);
}

// Weight of the heaviest rock above, the largest initial stress and the largest traction, together.
double expected_pressure(const Model& model) {
  Box depths;
  double density = 0;
  double stress = 0;
  double traction = 0;
  const double gravity = model.gravity.norm();
  const Vec2 down = gravity > 0 ? Vec2(model.gravity / gravity) : Vec2::Zero();
  for (const Block& block : model.blocks) {
    for (const Vec2& vertex : block.shape.outer) depths = expanded(depths, Vec2(down.dot(vertex), 0));
    density = std::max(density, model.materials[static_cast<std::size_t>(block.material)].density);
    stress = std::max(stress, largest_stress(block.initial_stress));
  }
  for (const EdgeLoad& load : model.edge_loads) traction = std::max(traction, load.traction.norm() + load.rise.norm());
  return density * gravity * (depths.upper - depths.lower).x() + stress + traction;
}

// Blocks that part from a projected joint meet others by springs: as stiff as the engine chooses them.
void choose_springs_of_parted_joints(Model& model) {
  if (!has_finite_kinematics(model)) return;
  const auto choose = [](std::vector<JointMaterial>& joints) {
    for (JointMaterial& joint : joints)
      if (joint.law == InterfaceLaw::projected && !joint.bonded && joint.normal_stiffness == 0)
        joint.automatic_stiffness = true;
  };
  choose(model.joints);
  for (Stage& stage : model.stages) choose(stage.rock.joints);
}

void check_gravity(const Model& model) {
  if (!model.gravity.allFinite()) throw InputError("", "gravity", "not finite", "two finite numbers");
}

}  // namespace

void finish_blocks(Model& model) {
  using namespace model_checks;
  check_materials(model.materials);
  check_blocks(model);
  if (model.joints.empty()) model.joints.emplace_back().name = "default";
  check_joints(model);
  check_gravity(model);
  fill_geometry(model);
  check_overlaps(model);
}

void finish_around_blocks(Model& model) {
  using namespace model_checks;
  check_joints(model);  // with the lines that say where they are
  check_initial_state(model);
  check_loads(model);
  check_supports(model);
  check_viscous_edges(model);
  check_held_blocks(model);
  check_free_field_sides(model);
  check_bolts(model);
  check_linings(model);
  check_measurements(model);
  model.expected.pressure = expected_pressure(model);
  choose_time_steps(model);
  check_stages(model);
  check_peaks(model);
  check_projected_joints(model);
  choose_springs_of_parted_joints(model);
  check_removals(model);
  check_rock_changes(model);
  keep_rock_at_start(model);
}

void finish_model(Model& model) {
  finish_blocks(model);
  finish_around_blocks(model);
}

}  // namespace dda
