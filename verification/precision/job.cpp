#include "verification/precision/job.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "dda/simulation/block_terms.h"
#include "verification/precision/bar_run.h"
#include "verification/precision/plane_run.h"

namespace verify {

std::string PrecisionScheme::name() const {
  std::string text = law + ", " + integrator;
  if (strain_inertia != 1) text += fmt::format(", strain inertia {:g}", strain_inertia);
  if (spring_over_young != 10) text += fmt::format(", springs {:g} E", spring_over_young);
  return corrected ? text + ", corrected" : text;
}

bool PrecisionScheme::is_engine() const { return law == "classical" || law == "consistent" || law == "cubic"; }

std::string PrecisionJob::key() const {
  return fmt::format("{}; {}; {:.6g} m; {:.6g} s", name_of(problem), scheme.name(), size, dt);
}

double PrecisionResult::passes() const { return cells * std::max({steps, solves, iterations}); }

std::string_view name_of(Problem problem) {
  if (problem == Problem::plane) return "plane";
  return problem == Problem::bar ? "bar" : "bar_cycle";
}

dda::Integrator integrator_named(const std::string& name) {
  if (name == "thesis") return dda::thesis_integrator();
  if (name == "trapezoidal") return dda::trapezoidal_integrator();
  if (name == "energy_conserving") return dda::energy_conserving_integrator();
  if (name == "hht 0.1") return dda::hht_integrator(0.1);
  if (name == "generalized_alpha 0.8") return dda::generalized_alpha_integrator(0.8);
  if (name == "generalized_alpha 0") return dda::generalized_alpha_integrator(0);
  throw std::invalid_argument("there is no integrator \"" + name + "\"");
}

// In a plate the cubic law is the consistent one and there is nothing to correct.
PrecisionScheme accurate_scheme(Problem problem) {
  const bool plane = problem == Problem::plane;
  return {plane ? "consistent" : "cubic", "generalized_alpha 0.8", plane ? dda::mesh_strain_inertia : 1, !plane};
}

PrecisionScheme thesis_scheme() { return {"classical", "thesis", 1, false}; }

PrecisionResult run_job(const PrecisionJob& job) {
  return job.problem == Problem::plane ? run_plane(job) : run_bar(job);
}

}  // namespace verify
