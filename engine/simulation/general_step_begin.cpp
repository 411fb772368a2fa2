// How a step that follows contacts begins a stage.
#include "engine/contact/projected_stretch.h"
#include "engine/simulation/force_balance.h"
#include "engine/simulation/general_step.h"
#include "engine/simulation/initial_acceleration.h"
#include "engine/simulation/kinematic_update.h"

namespace dda {
namespace {

// What projected stretches take off their blocks has the directions in which stresses were held last, and their gaps
// are those of the kinematics of the stage before.
void change_kinematics(BlockSystem& s, GeneralStep& step) {
  if (!step.follows_contacts() || s.contacts.outline_compliance.empty() || s.clock.stage == 0) return;
  const Kinematics before = s.model.stages[s.clock.stage - 1].kinematics;
  if (before == s.stage().kinematics) return;
  if (before == Kinematics::small) keep_gaps(s.model, s.state, s.contacts);
  step.place_geometry(0);
}

}  // namespace

void GeneralStep::begin() {
  cushion_ = {};
  given_friction_ = {};
  solver_.begin_bolts_anew();
  change_kinematics(system_, *this);
  for (Vec3& force : system_.terms.centrifugal) force.setZero();
  if (system_.plan.is_static) return;
  if (feels_spin(system_.plan)) set_centrifugal_forces(system_.model, system_.state, system_.terms);
  set_initial_acceleration(changing_, system_);
}

}  // namespace dda
