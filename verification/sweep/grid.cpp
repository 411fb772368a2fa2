#include "verification/sweep/grid.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "engine/model/law_name.h"
#include "verification/study/grid.h"
#include "verification/thesis/reference.h"

namespace verify {
namespace {

using dda::Dimension;
using dda::Field;
using dda::InterfaceLaw;

double number(const Field& value) { return value.positive(Dimension::dimensionless); }

void set_integrator(const Field& value, JobParameters& job) {
  dda::Integrator& integrator = job.stage.integrator;
  if (value.is_text()) {
    const std::vector<std::string> words = {"thesis", "trapezoidal"};
    job.integrator_name = words[value.choice(words)];
    integrator = job.integrator_name == "thesis" ? dda::thesis_integrator() : dda::trapezoidal_integrator();
  } else if (const auto alpha = value.find("hht")) {
    integrator = dda::hht_integrator(alpha->within(0, 1.0 / 3));
    job.integrator_name = fmt::format("hht {}", alpha->within(0, 1.0 / 3));
  } else if (const auto rho = value.find("generalized_alpha")) {
    integrator = dda::generalized_alpha_integrator(rho->within(0, 1));
    job.integrator_name = fmt::format("generalized_alpha {}", rho->within(0, 1));
  } else {
    value.fail(R"("thesis", "trapezoidal", {"hht": ALPHA} or {"generalized_alpha": RHO_INF})");
  }
}

constexpr double largest_eta = 0.6;  // of longer blocks the bar has too few to measure a wave between

void set_eta(const Field& value, JobParameters& job) {
  job.block_length = value.within(1e-4, largest_eta) * thesis_reference().bar.wavelength();
}

void set_block_length(const Field& value, JobParameters& job) {
  job.block_length = value.positive(Dimension::length);
  if (job.eta() < 1e-4 || job.eta() > largest_eta)
    value.fail(fmt::format("a length from {:.4g} to {:.4g} m", 1e-4 * job.block_length / job.eta(),
                           largest_eta * job.block_length / job.eta()));
}

// s. Beyond these the numbers of a job, such as its samples per period, leave the range of numbers.
constexpr double shortest_step = 1e-15;
constexpr double longest_step = 1e3;

void expect_sensible_step(const Field& value, double dt) {
  if (!(dt >= shortest_step && dt <= longest_step))
    value.fail(fmt::format("a step from {:g} to {:g} s", shortest_step, longest_step));
}

void set_dt(const Field& value, JobParameters& job) {
  job.dt = value.positive(Dimension::time);
  expect_sensible_step(value, job.dt);
}

// Comes after the block length.
void set_cfl(const Field& value, JobParameters& job) {
  job.dt = number(value) * job.block_length / thesis_reference().bar.wave_speed();
  expect_sensible_step(value, job.dt);
}

void set_law(const Field& value, JobParameters& job) {
  constexpr std::array laws = {InterfaceLaw::classical, InterfaceLaw::consistent, InterfaceLaw::cubic};
  job.joint.law = laws.at(value.choice({"classical", "consistent", "cubic"}));
}

void set_penalty(const Field& value, JobParameters& job) {
  job.joint.penalty = number(value);
  if (job.joint.penalty <= 1) value.fail("a number above 1, below which the law is unstable");
}

void set_pulse(const Field& value, JobParameters& job) {
  job.pulse = value.choice({"cycle", "tone"}) == 0 ? Pulse::cycle : Pulse::tone;
}

struct Key {
  const char* name;
  bool numeric;
  void (*set)(const Field& value, JobParameters& job);
};

constexpr std::array keys{
    Key{"eta", true, set_eta},
    Key{"block_length", true, set_block_length},
    Key{"cfl", true, set_cfl},
    Key{"dt", true, set_dt},
    Key{"law", false, set_law},
    Key{"spring_over_young", true, [](const Field& f, JobParameters& j) { j.joint.spring_over_young = number(f); }},
    Key{"shear_to_normal", true, [](const Field& f, JobParameters& j) { j.joint.shear_to_normal = number(f); }},
    Key{"penalty", true, set_penalty},
    Key{"integrator", false, set_integrator},
    Key{"poisson", true, [](const Field& f, JobParameters& j) { j.poisson = f.within(0, 0.49); }},
    Key{"strain_inertia", true, [](const Field& f, JobParameters& j) { j.stage.strain_inertia = number(f); }},
    Key{"lateral_inertia", false, [](const Field& f, JobParameters& j) { j.stage.lateral_inertia = f.truth(); }},
    Key{"correct_time_dispersion", false,
        [](const Field& f, JobParameters& j) { j.stage.correct_time_dispersion = f.truth(); }},
    Key{"pulse", false, set_pulse},
};

// Keys that mean something to one law alone.
constexpr std::array<std::pair<const char*, InterfaceLaw>, 5> keys_of_laws{
    {{"spring_over_young", InterfaceLaw::classical},
     {"shear_to_normal", InterfaceLaw::classical},
     {"penalty", InterfaceLaw::consistent},
     {"lateral_inertia", InterfaceLaw::cubic},
     {"correct_time_dispersion", InterfaceLaw::cubic}}};

void expect_known_keys(const Field& grid) {
  std::vector<std::string> names;
  for (const Key& key : keys) names.emplace_back(key.name);
  for (const auto& [name, values] : grid.members()) {
    if (std::find(names.begin(), names.end(), name) == names.end())
      values.fail("to be a parameter: one of " + fmt::format("{}", fmt::join(names, ", ")));
    if (values.items().empty()) values.fail("at least one value");
  }
}

void expect_one_of(const Field& grid, const char* first, const char* second) {
  if (grid.has(first) == grid.has(second))
    grid.fail(grid.has(first) ? "both" : "neither", fmt::format("one of the keys \"{}\" and \"{}\", not {}", first,
                                                                second, grid.has(first) ? "both" : "none"));
}

void expect_used(const Field& grid, const std::vector<JobParameters>& jobs) {
  for (const auto& [name, law] : keys_of_laws) {
    const auto values = grid.find(name);
    const bool idle =
        std::any_of(jobs.begin(), jobs.end(), [only = law](const JobParameters& j) { return j.joint.law != only; });
    if (values && idle)
      values->fail(fmt::format("to be left out unless every \"law\" of the grid is \"{}\"", dda::law_name(law)));
  }
}

}  // namespace

std::vector<JobParameters> jobs_of_grid(const Field& grid) {
  expect_known_keys(grid);
  expect_one_of(grid, "eta", "block_length");
  expect_one_of(grid, "cfl", "dt");
  std::vector<JobParameters> jobs = {default_parameters()};
  for (const Key& key : keys) {
    const auto values = grid.find(key.name);
    if (!values) continue;
    if (jobs.size() * values->items().size() > most_jobs)
      grid.fail("more", fmt::format("a grid of at most {} jobs", most_jobs));
    jobs = with_each(jobs, values->items(), key.set);
  }
  expect_used(grid, jobs);
  return jobs;
}

std::vector<std::string> numeric_parameters() {
  std::vector<std::string> names;
  for (const Key& key : keys)
    if (key.numeric) names.emplace_back(key.name);
  return names;
}

}  // namespace verify
