#include "verification/precision/job.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <stdexcept>
#include <system_error>

namespace verify {
namespace {

// The number in a name that is `word` and a number.
std::optional<double> number_after(std::string_view word, const std::string& name) {
  if (!name.starts_with(word)) return std::nullopt;
  const std::string_view rest = std::string_view(name).substr(word.size());
  double number = 0;
  const auto [end, fault] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  return fault == std::errc{} && end == rest.data() + rest.size() ? std::optional(number) : std::nullopt;
}

}  // namespace

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
  if (name == "central_difference") return dda::central_difference_integrator();
  if (name == "energy_conserving") return dda::energy_conserving_integrator();
  if (const auto alpha = number_after("hht ", name)) return dda::hht_integrator(*alpha);
  if (const auto rho_inf = number_after("generalized_alpha ", name)) return dda::generalized_alpha_integrator(*rho_inf);
  throw std::invalid_argument("there is no integrator \"" + name + "\"");
}

// In a plate the cubic law is the consistent one.
PrecisionScheme accurate_scheme(Problem problem) {
  const bool plane = problem == Problem::plane;
  return {plane ? "consistent" : "cubic", "generalized_alpha 0.85", 1, true};
}

PrecisionScheme explicit_scheme() { return {"consistent", "central_difference", 1, true}; }

PrecisionScheme thesis_scheme() { return {"classical", "thesis", 1, false}; }

}  // namespace verify
