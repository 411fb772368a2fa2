#include "engine/builder/scheme.h"

namespace dda {
namespace {

// Bonded: damps what the mesh cannot resolve (kinks of a load) and nothing that it can. Where contacts open and close,
// anything above 0 carries contact accelerations into free flight and can gain energy.
constexpr double bonded_rho_inf = 0.85;
constexpr double contact_rho_inf = 0;

}  // namespace

JointMaterial preset_joint(const Scheme& scheme) {
  JointMaterial joint;
  joint.law = InterfaceLaw::cubic;
  joint.spring_over_young = 0;  // by the sizes of the blocks that meet
  if (scheme.name == SchemeName::thesis) {
    joint.law = InterfaceLaw::classical;
    joint.spring_over_young = 10;
    joint.shear_to_normal = 0.4;
  }
  return joint;
}

Stage preset_stage(const Scheme& scheme, Kinematics kinematics, bool all_bonded) {
  Stage stage;
  stage.kinematics = kinematics;
  if (scheme.name == SchemeName::thesis) {
    stage.integrator = thesis_integrator();
    return stage;
  }
  stage.integrator = generalized_alpha_integrator(all_bonded ? bonded_rho_inf : contact_rho_inf);
  stage.correct_block_dispersion = all_bonded && kinematics == Kinematics::small;
  stage.correct_time_dispersion = all_bonded && kinematics == Kinematics::small;
  return stage;
}

}  // namespace dda
