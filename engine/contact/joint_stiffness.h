// Stiffness of classical joints, and the errors it brings.
//
// A joint may give the spring of a contact (N/m, or in multiples of Young's modulus), a stiffness per area (Pa/m), or
// leave the choice to the engine. Where it says nothing a spring is, with E of the softer block,
//   k_n = E min(max(10, S/s), 300), k_s = shear_to_normal sqrt(10 E k_n)
// S, s: sizes of the larger and the smaller block. What presses a splinter goes by the size of the blocks beside it,
// p S, and would close a spring of 10 E by p S/(10 E) whatever the splinter measures: 10 % of one of a thousandth of S
// under p = E/1000. With E S/s it is p/E of the splinter, as between blocks that are alike (ADR 88). With "auto" chosen
// is, per area,
//   k_n = max(E / (compliance_target t), p / (penetration_target t)), but k_n share dt^2 / m at most largest_chi
// E: Young's modulus of the softer block; t, m: the smaller thickness and mass; p: Expected::pressure; dt: the
// longest step of any stage that is not static; share: the length for which the contact stands. The first term makes a
// joint add at most compliance_target to the compliance of the blocks beside it, the second lets it be pressed in by at
// most penetration_target of a block whatever lies above. The limit keeps half of the digits of a solve.
#pragma once

#include "engine/contact/interface.h"
#include "engine/model/model.h"

namespace dda {

inline constexpr double compliance_target = 0.01;
inline constexpr double penetration_target = 1e-4;
inline constexpr double largest_chi = 1e8;

struct Springs {
  double normal = 0, shear = 0;  // N/m per m of thickness, of one spring
};

Springs springs_of(const Model& model, const Interface& interface);

// Whether blocks meet at such a joint by springs wherever they do so in finite kinematics: at dry joints, but for those
// of the projected law, which stay what was drawn until their blocks part.
inline bool is_springs_where_blocks_move(const JointMaterial& joint) {
  return is_dry(joint) && joint.law != InterfaceLaw::projected;
}
// The same in the kinematics of a stage.
inline bool is_springs(const JointMaterial& joint, Kinematics kinematics) {
  return joint.law == InterfaceLaw::classical ||
         (kinematics == Kinematics::finite && is_springs_where_blocks_move(joint));
}

// What the springs of a stretch under the classical law do to the result, to first order.
struct StiffnessErrors {
  // The joint's, over that of the two half blocks beside it where these cannot give way sideways, the most: M/(k_n L)
  // between equal blocks, with M = E (1 - nu)/((1 + nu) (1 - 2 nu)) in plane strain.
  double compliance = 0;
  double penetration = 0;  // under Expected::pressure, over the size of the smaller block
};

// Stretches only.
StiffnessErrors stiffness_errors(const Model& model, const Interface& interface);

// Size of a block, m: the side of the square with its area.
double block_size(const Block& block);

}  // namespace dda
