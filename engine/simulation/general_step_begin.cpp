// How a step that follows contacts begins a stage.
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "engine/contact/contact_geometry.h"
#include "engine/contact/join_blocks.h"
#include "engine/contact/make_contacts.h"
#include "engine/contact/projected_stretch.h"
#include "engine/simulation/force_balance.h"
#include "engine/simulation/general_step.h"
#include "engine/simulation/initial_acceleration.h"
#include "engine/simulation/kinematic_update.h"

namespace dda {
namespace {

constexpr double harmless_at_start = 1e-4;

// What projected stretches take off their blocks has the directions in which stresses were held last, and their gaps
// are those of the kinematics of the stage before.
void change_kinematics(BlockSystem& s, GeneralStep& step) {
  if (!step.follows_contacts() || s.contacts.outline_compliance.empty() || s.clock.stage == 0) return;
  const Kinematics before = s.model.stages[s.clock.stage - 1].kinematics;
  if (before == s.stage().kinematics) return;
  if (before == Kinematics::small) keep_gaps(s.model, s.state, s.contacts);
  step.place_geometry(0);
}

void leave_out(const std::vector<bool>& absent, BlockSystem& s, std::optional<MovingContacts>& moving,
               ContactRange& range) {
  if (moving) {
    moving->leave_out(absent, s.contacts);
  } else {
    leave_out(absent, s.contacts);
    range.leave_out(absent, s.model, s.contacts.interfaces);
  }
  fit_to_neighbours(s.model, s.contacts);
}

}  // namespace

void GeneralStep::set_blocks(const std::vector<bool>& absent, const std::vector<int>& added, bool at_rest) {
  BlockSystem& s = system_;
  if (added.empty()) {
    leave_out(absent, s, moving_, range_);
    moved_ = std::numeric_limits<double>::infinity();
    return;
  }
  std::vector<bool> comes_in(absent.size(), false);
  for (const int block : added) {
    const auto i = static_cast<std::size_t>(block);
    comes_in[i] = true;
    if (acting_.displacement.empty()) continue;
    acting_.displacement[i] = s.state.displacement[i];
    acting_.deformation[i] = s.state.deformation[i];
  }
  const State acting = s.geometry_moves() ? s.state : initial_state(s.model);
  const ComingBlocks blocks{absent, comes_in, acting};
  if (moving_) {
    moving_->bring_in(s.model, s.state, blocks, s.contacts);
  } else {
    bring_in(s.model, s.state, blocks, at_rest, s.contacts);
    range_.leave_out(absent, s.model, s.contacts.interfaces);
  }
}

// In longer steps within the stage only accelerations begin anew. An impact may be under way then, of which nothing is
// harmless.
void GeneralStep::begin() {
  const bool is_new_stage = system_.clock.step == 0;
  if (is_new_stage) {
    cushion_ = {};
    given_friction_ = {};
    solver_.begin_bolts_anew();
    change_kinematics(system_, *this);
    for (Vec3& force : system_.terms.centrifugal) force.setZero();
    face_loads_.take(system_.load_time(), system_);
  }
  if (system_.plan.is_static) return;
  set_step_size(system_.stage().dt_of(system_.clock.step));
  if (feels_spin(system_.plan)) set_centrifugal_forces(system_.model, system_.state, system_.terms);
  set_initial_acceleration(changing_, is_new_stage ? harmless_at_start : 0, system_);
}

}  // namespace dda
