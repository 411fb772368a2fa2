#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "verification/sweep/plots.h"

namespace verify {
namespace {

// Round-off of eta and cfl made of lengths and time steps must not tell jobs apart.
std::string shown(const nlohmann::ordered_json& value) {
  if (value.is_number()) return fmt::format("{:.6g}", value.get<double>());
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::set<std::string> values_of(const SweepSpec& spec, const std::string& name) {
  std::set<std::string> values;
  for (const JobParameters& job : spec.jobs) values.insert(shown(to_json(job).at(name)));
  return values;
}

// Two names of one thing tell jobs apart; the one with fewer values is what the grid lists, and the other is idle.
std::string idle_name(const SweepSpec& spec, const std::string& first, const std::string& second) {
  return values_of(spec, first).size() <= values_of(spec, second).size() ? second : first;
}

constexpr std::pair<const char*, const char*> twins[] = {{"eta", "block_length"}, {"cfl", "dt"}};

std::vector<std::string> telling_parameters(const SweepSpec& spec, const SweepPlot& plot) {
  std::set<std::string> idle = {plot.x, plot.y};
  for (const auto& [first, second] : twins) {
    if (idle.contains(first) || idle.contains(second)) {
      idle.insert({first, second});
    } else {
      idle.insert(idle_name(spec, first, second));
    }
  }
  std::vector<std::string> telling;
  const nlohmann::ordered_json all = to_json(JobParameters{});
  for (const auto& [name, value] : all.items())
    if (!idle.contains(name) && values_of(spec, name).size() > 1) telling.push_back(name);
  return telling;
}

std::string title_of(const JobParameters& job, const std::vector<std::string>& telling) {
  const nlohmann::ordered_json parameters = to_json(job);
  std::string title;
  for (const std::string& name : telling)
    title += fmt::format("{}{} {}", title.empty() ? "" : ", ", name, shown(parameters.at(name)));
  std::replace(title.begin(), title.end(), '_', ' ');
  return title;
}

std::size_t titles_of(const SweepSpec& spec, const std::vector<std::string>& telling) {
  std::set<std::string> titles;
  for (const JobParameters& job : spec.jobs) titles.insert(title_of(job, telling));
  return titles.size();
}

// Parameters that go with others are left out: the first ones tell the groups apart as well.
std::vector<std::string> shortest(const SweepSpec& spec, std::vector<std::string> telling) {
  const std::size_t groups = titles_of(spec, telling);
  for (std::size_t i = telling.size(); i-- > 0;) {
    std::vector<std::string> fewer = telling;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (titles_of(spec, fewer) == groups) telling = fewer;
  }
  return telling;
}

}  // namespace

std::vector<PlotGroup> groups_of(const SweepSpec& spec, const SweepPlot& plot) {
  const std::vector<std::string> telling = shortest(spec, telling_parameters(spec, plot));
  std::vector<PlotGroup> groups;
  for (std::size_t i = 0; i < spec.jobs.size(); ++i) {
    const std::string title = title_of(spec.jobs[i], telling);
    const auto same = [&](const PlotGroup& group) { return group.title == title; };
    auto group = std::find_if(groups.begin(), groups.end(), same);
    if (group == groups.end()) group = groups.insert(groups.end(), PlotGroup{title, {}});
    group->jobs.push_back(i);
  }
  return groups;
}

}  // namespace verify
