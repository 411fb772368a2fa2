#include "engine/advice/ringing_weight.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "engine/geometry/segment.h"
#include "engine/model/held_flags.h"
#include "engine/model/step_choice.h"

namespace dda {
namespace {

constexpr double damped_in_a_period = 0.2;  // of the amplitude; measured: 8 % leaves a creep of 3 mm, 30 % of 10 um
constexpr double least_slope = 0.02;        // sine of the angle between joint and level, and joint and plumb line

std::size_t at(int index) { return static_cast<std::size_t>(index); }

bool begins_under_stress(const Model& model) {
  return std::ranges::any_of(model.blocks, [](const Block& block) { return !block.initial_stress.isZero(0); });
}

bool damps_ringing(const Stage& stage) {
  return stage.integrator.is_static || stage.velocity_factor < 1 || stage.damping_rate > 0;
}

// Blocks that friction alone keeps from sliding under their own weight.
bool rubs_on_a_slope(const Model& model, const std::vector<bool>& held, const Interface& interface) {
  const JointMaterial& joint = model.joints[at(interface.joint)];
  if (joint.bonded || joint.friction_angle == 0 || joint.cohesion > 0) return false;
  if (held[at(interface.block_a)] && held[at(interface.block_b)]) return false;
  const Vec2 down = model.gravity.normalized();
  const double along = std::abs(cross(down, interface.normal)), across = std::abs(down.dot(interface.normal));
  return along > least_slope && across > least_slope && along <= std::tan(joint.friction_angle) * across;
}

// rad/s, of a block with uniform strain and a foot that stays where it is: its ends move apart by h e, its mass feels
// rho h^2/3 of that, and E resists it.
double swing_of(const Model& model, const Block& block) {
  const Material& rock = model.materials[at(block.material)];
  return std::sqrt(3 * rock.young / rock.density / block.moments.area);
}

// The slowest, of all blocks that rub on a slope; 0 where none does.
double slowest_swing(const Model& model, const ContactSet& contacts) {
  const std::vector<bool> held = held_flags(model);
  double slowest = 0;
  for (const Interface& interface : contacts.interfaces) {
    if (!rubs_on_a_slope(model, held, interface)) continue;
    for (const int block : {interface.block_a, interface.block_b})
      if (const double swing = swing_of(model, model.blocks[at(block)]); !held[at(block)])
        slowest = slowest > 0 ? std::min(slowest, swing) : swing;
  }
  return slowest;
}

}  // namespace

std::vector<std::string> ringing_weight(const Model& model, const ContactSet& contacts) {
  const Stage& stage = model.stages.front();
  if (model.gravity.isZero(0) || damps_ringing(stage) || begins_under_stress(model)) return {};
  const double swing = slowest_swing(model, contacts);
  if (swing == 0) return {};
  const double lost = stage.integrator.is_explicit() ? 0 : step_errors(stage.integrator, swing * stage.dt).amplitude;
  if (lost > damped_in_a_period) return {};
  return {fmt::format(
      "stage \"{}\": weight acts at once on blocks that lie on inclined joints, and steps of {:.2g} s let them ring "
      "(about {:.2g} Hz): pressures come and go, and blocks that friction holds creep meanwhile; begin with a static "
      "stage",
      stage.name, stage.dt, swing / (2 * std::numbers::pi))};
}

}  // namespace dda
