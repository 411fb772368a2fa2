#include "verification/thesis/oracle_study.h"

#include <array>
#include <string_view>
#include <utility>

#include "verification/harness/histories.h"
#include "verification/harness/recorded_run.h"
#include "verification/thesis/bar_scene.h"
#include "verification/thesis/closed_form.h"

namespace verify {
namespace {

constexpr std::array<std::pair<dda::InterfaceLaw, std::string_view>, 3> laws = {{
    {dda::InterfaceLaw::classical, "classical"},
    {dda::InterfaceLaw::consistent, "consistent"},
    {dda::InterfaceLaw::cubic, "cubic"},
}};

std::vector<std::pair<dda::Integrator, std::string>> integrators() {
  return {{dda::thesis_integrator(), "thesis Eq. 5"},
          {dda::trapezoidal_integrator(), "trapezoidal"},
          {dda::hht_integrator(0.1), "HHT, α = 0.1"},
          {dda::generalized_alpha_integrator(0.8), "generalized-α, ρ∞ = 0.8"}};
}

SchemeSettings bonded(const ThesisBar& bar, dda::InterfaceLaw law, const dda::Integrator& integrator) {
  SchemeSettings scheme = scheme_settings("accurate", bar);
  scheme.joint.law = law;
  scheme.stage.integrator = integrator;
  scheme.stage.correct_time_dispersion = law == dda::InterfaceLaw::cubic;  // closed forms of the others know none
  if (law == dda::InterfaceLaw::classical) scheme.quantity = dda::Quantity::stress_xx;
  return scheme;
}

double difference(const ThesisBar& bar, const SchemeSettings& scheme, const BarRun& run) {
  const dda::Model model = bar_scene(bar, scheme, run);
  return largest_difference(record_run(model).histories.front(), closed_form_history(model, bar));
}

}  // namespace

std::vector<OracleResult> oracle_study(const ThesisReference& reference, const std::vector<double>& time_steps,
                                       double duration, const std::function<void()>& done) {
  std::vector<OracleResult> results;
  for (const auto& [law, law_name] : laws) {
    for (const auto& [integrator, integrator_name] : integrators()) {
      const SchemeSettings scheme = bonded(reference.bar, law, integrator);
      for (const double dt : time_steps) {
        for (const double length : reference.block_lengths) {
          const BarRun run{dt, length, 2 * reference.bar.length, duration};
          results.push_back(
              {std::string(law_name), integrator_name, dt, length, difference(reference.bar, scheme, run)});
          done();
        }
      }
    }
  }
  return results;
}

std::size_t oracle_runs(const ThesisReference& reference, std::size_t time_steps) {
  return laws.size() * integrators().size() * time_steps * reference.block_lengths.size();
}

}  // namespace verify
