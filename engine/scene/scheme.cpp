#include "dda/scene/scheme.h"

namespace dda {
namespace {

// Damps what the mesh cannot resolve (kinks of a load, contacts that change) and nothing that it can.
constexpr double accurate_rho_inf = 0.8;

}  // namespace

JointMaterial preset_joint(const Scheme& scheme) {
  JointMaterial joint;
  joint.law = InterfaceLaw::cubic;
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
  stage.integrator = generalized_alpha_integrator(accurate_rho_inf);
  stage.correct_time_dispersion = all_bonded && kinematics == Kinematics::small;
  return stage;
}

}  // namespace dda
