#include "verification/sweep/spec.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/scene/field.h"
#include "engine/scene/json_text.h"
#include "verification/sweep/grid.h"

namespace verify {
namespace {

using dda::Field;

const std::vector<std::string> spec_keys = {"title", "grid", "closed_form", "plots"};

std::string axis(const Field& field) {
  const std::vector<std::string> names = numeric_parameters();
  return names[field.choice(names)];
}

// An axis of a plot must be what every grid lists: only then its values fall on lines.
std::string axis(const Field& field, const Field& grids) {
  std::string name = axis(field);
  for (const Field& grid : grids.is_array() ? grids.items() : std::vector<Field>{grids})
    if (!grid.has(name)) field.fail("a parameter that every grid lists");
  return name;
}

SweepPlot read_plot(const Field& field, const Field& grids) {
  for (const auto& [name, value] : field.members())
    if (name != "x" && name != "y") value.fail("to be left out: a plot has an \"x\" and may have a \"y\"");
  SweepPlot plot{axis(field.at("x"), grids), ""};
  if (const auto y = field.find("y")) {
    plot.y = axis(*y, grids);
    if (plot.y == plot.x) y->fail("another parameter than \"x\"");
  }
  return plot;
}

std::vector<JobParameters> read_jobs(const Field& grids) {
  if (!grids.is_array()) return jobs_of_grid(grids);
  std::vector<JobParameters> jobs;
  for (const Field& grid : grids.items()) {
    const std::vector<JobParameters> more = jobs_of_grid(grid);
    jobs.insert(jobs.end(), more.begin(), more.end());
    if (jobs.size() > most_jobs) grids.fail("more", fmt::format("at most {} jobs", most_jobs));
  }
  if (jobs.empty()) grids.fail("at least one grid");
  return jobs;
}

SweepSpec read(const Field& document) {
  for (const auto& [name, value] : document.members())
    if (std::find(spec_keys.begin(), spec_keys.end(), name) == spec_keys.end())
      value.fail(fmt::format("to be one of the keys {}", fmt::join(spec_keys, ", ")));
  SweepSpec spec;
  spec.title = value_or(document, "title", std::string("sweep"), [](const Field& f) { return f.text(); });
  spec.closed_form = value_or(document, "closed_form", spec.closed_form, [](const Field& f) { return f.truth(); });
  spec.jobs = read_jobs(document.at("grid"));
  if (const auto plots = document.find("plots"))
    for (const Field& plot : plots->items()) spec.plots.push_back(read_plot(plot, document.at("grid")));
  return spec;
}

}  // namespace

SweepSpec parse_spec(std::string_view text, const std::string& name_for_errors) {
  try {
    const nlohmann::json document = dda::parse_json(text);
    return read(Field(document, document.is_object() ? "" : "the sweep"));
  } catch (const dda::InputError& error) {
    throw error.in_file(name_for_errors);
  }
}

std::string spec_text(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    const bool exists = std::filesystem::exists(file, ignored);
    throw dda::InputError(file.string(), "the sweep's file", exists ? "no file" : "missing", "a JSON file");
  }
  return dda::read_file(file);
}

SweepSpec read_spec(const std::filesystem::path& file) { return parse_spec(spec_text(file), file.string()); }

}  // namespace verify
