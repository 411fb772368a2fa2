#include "verification/chapters/scene_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <ostream>
#include <stdexcept>

#include "engine/core/read_file.h"
#include "engine/record/atomic_file.h"
#include "verification/sweep/process_pool.h"

namespace verify {
namespace {

using Json = SceneFolder::Scene;

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(at, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

double number(std::string_view field) {
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size())
    throw std::runtime_error(fmt::format("histories.csv has \"{}\" where a number was expected", field));
  return value;
}

void add_row(std::string_view row, SceneRun& run) {
  const auto values = split(row, ',');  // names and numbers are not quoted
  if (values.size() != run.columns.size() + 1) throw std::runtime_error("histories.csv has rows of unequal length");
  run.time.push_back(number(values.front()));
  for (std::size_t i = 0; i < run.columns.size(); ++i) run.histories[i].push_back(number(values[i + 1]));
}

Json json_file(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) return nullptr;
  return Json::parse(dda::read_file(path), nullptr, false);
}

}  // namespace

const std::vector<double>& SceneRun::at(const std::string& column) const {
  const auto found = std::ranges::find(columns, column);
  if (found == columns.end()) throw std::out_of_range("run " + name + " has no history \"" + column + "\"");
  return histories[static_cast<std::size_t>(found - columns.begin())];
}

void read_histories(std::string_view text, SceneRun& run) {
  const std::vector<std::string_view> rows = split(text, '\n');
  for (const std::string_view name : split(rows.front(), ','))
    run.columns.emplace_back(name.substr(0, name.rfind(" [")));
  run.columns.erase(run.columns.begin());  // the time
  run.histories.resize(run.columns.size());
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (!rows[i].empty()) add_row(rows[i], run);
}

SceneFolder::SceneFolder(std::filesystem::path folder, std::filesystem::path program, int at_once, std::ostream& out)
    : folder_(std::move(folder)), program_(std::move(program)), at_once_(at_once), out_(out) {
  std::filesystem::create_directories(folder_ / "scenes");
  std::filesystem::create_directories(folder_ / "runs");
}

std::filesystem::path SceneFolder::scene(const std::string& name) const {
  return folder_ / "scenes" / (name + ".json");
}
std::filesystem::path SceneFolder::results(const std::string& name) const { return folder_ / "runs" / name; }

void SceneFolder::put(const std::string& name, const Scene& content) const {
  const std::string text = content.dump(1) + "\n";
  if (std::filesystem::exists(scene(name)) && dda::read_file(scene(name)) == text) return;
  std::filesystem::remove_all(results(name));
  dda::write_file(scene(name), text);
}

void SceneFolder::carry_out(const std::vector<std::string>& names, const std::vector<std::string>& arguments,
                            const std::string& result) const {
  std::vector<PoolTask> open;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (std::filesystem::exists(results(names[i]) / result)) continue;
    std::filesystem::remove_all(results(names[i]));
    Command command{program_.string(), arguments.front(), scene(names[i]).string(), "--out",
                    results(names[i]).string()};
    command.insert(command.end(), arguments.begin() + 1, arguments.end());
    open.push_back({i, std::move(command)});
  }
  std::size_t ended = 0;
  run_processes(open, at_once_, [&](std::size_t index, const std::string& failure) {
    out_ << fmt::format("{} of {}: {} {}\n", ++ended, open.size(), names[index], failure.empty() ? "done" : failure)
         << std::flush;
  });
}

void SceneFolder::run(const std::vector<std::string>& names) const {
  carry_out(names, {"run", "--frames", "10"}, "summary.json");
}

void SceneFolder::find_key_blocks(const std::vector<std::string>& names, const std::string& opening) const {
  carry_out(names, {"keyblocks", "--opening", opening}, "keyblocks.json");
}

SceneRun SceneFolder::read(const std::string& name) const {
  SceneRun run;
  run.name = name;
  const Json summary = json_file(results(name) / "summary.json");
  run.status = summary.is_object() ? summary.value("status", "missing") : "missing";
  run.message = summary.is_object() ? summary.value("message", "") : "it left no summary";
  if (run.ok()) read_histories(dda::read_file(results(name) / "histories.csv"), run);
  return run;
}

Json SceneFolder::key_blocks(const std::string& name) const {
  const Json file = json_file(results(name) / "keyblocks.json");
  return file.is_object() ? file.value("blocks", Json::array()) : Json::array();
}

}  // namespace verify
