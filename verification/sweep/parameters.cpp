#include "verification/sweep/parameters.h"

#include "engine/model/law_name.h"
#include "verification/thesis/reference.h"

namespace verify {

double JobParameters::eta() const { return thesis_reference().bar.eta(block_length); }

double JobParameters::cfl() const { return thesis_reference().bar.wave_speed() * dt / block_length; }

double JobParameters::samples_per_period() const { return 1 / (thesis_reference().bar.load_frequency * dt); }

JobParameters default_parameters() {
  JobParameters parameters;
  parameters.joint.name = "joint";
  parameters.joint.law = dda::InterfaceLaw::classical;
  parameters.joint.bonded = true;
  parameters.stage.integrator = dda::thesis_integrator();
  parameters.stage.kinematics = dda::Kinematics::small;
  parameters.poisson = thesis_reference().bar.poisson;
  return parameters;
}

std::string pulse_name(Pulse pulse) { return pulse == Pulse::cycle ? "cycle" : "tone"; }

nlohmann::ordered_json to_json(const JobParameters& parameters) {
  return {{"eta", parameters.eta()},
          {"block_length", parameters.block_length},
          {"cfl", parameters.cfl()},
          {"dt", parameters.dt},
          {"law", dda::law_name(parameters.joint.law)},
          {"spring_over_young", parameters.joint.spring_over_young},
          {"shear_to_normal", parameters.joint.shear_to_normal},
          {"penalty", parameters.joint.penalty},
          {"integrator", parameters.integrator_name},
          {"poisson", parameters.poisson},
          {"strain_inertia", parameters.stage.strain_inertia},
          {"lateral_inertia", parameters.stage.lateral_inertia},
          {"correct_time_dispersion", parameters.stage.correct_time_dispersion},
          {"pulse", pulse_name(parameters.pulse)}};
}

}  // namespace verify
