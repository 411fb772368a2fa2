#include "engine/advice/projected_offer.h"

#include "engine/contact/joint_stiffness.h"
#include "engine/model/moving_stages.h"

namespace dda {

// Joints with dashpots can have the law as well, but what is foretold of it knows no dashpots.
bool could_be_projected(const Model& model, const JointMaterial& joint) {
  if (joint.bonded || joint.contact_damping > 0 || joint.dilation_angle > 0) return false;
  return joint.law == InterfaceLaw::classical || (has_finite_kinematics(model) && is_springs_where_blocks_move(joint));
}

}  // namespace dda
