#include "verification/precision/scheme_settings.h"

#include <stdexcept>

namespace verify {
namespace {

dda::InterfaceLaw law_named(const std::string& name) {
  if (name == "classical") return dda::InterfaceLaw::classical;
  if (name == "consistent") return dda::InterfaceLaw::consistent;
  if (name == "cubic") return dda::InterfaceLaw::cubic;
  throw std::invalid_argument("there is no interface law \"" + name + "\"");
}

}  // namespace

dda::JointMaterial joint_of(const PrecisionScheme& scheme) {
  dda::JointMaterial joint;
  joint.name = "joint";
  joint.law = law_named(scheme.law);
  joint.bonded = true;
  joint.spring_over_young = scheme.spring_over_young;
  joint.shear_to_normal = 0.4;
  return joint;
}

dda::Stage stage_of(const PrecisionScheme& scheme) {
  dda::Stage stage;
  stage.integrator = integrator_named(scheme.integrator);
  stage.kinematics = dda::Kinematics::small;
  stage.strain_inertia = scheme.strain_inertia;
  stage.correct_block_dispersion = scheme.corrected;
  stage.correct_time_dispersion = scheme.corrected;
  return stage;
}

PrecisionResult result_of(const RecordedRun& run, const dda::Model& model, const HistoryErrors& errors) {
  return {errors.l2,
          errors.reading,
          static_cast<int>(model.blocks.size()),
          static_cast<double>(run.counters.steps),
          static_cast<double>(run.counters.solves),
          static_cast<double>(run.counters.solver_iterations),
          run.setup_cpu_s + run.cpu_s};
}

}  // namespace verify
