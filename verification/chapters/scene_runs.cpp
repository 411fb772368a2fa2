#include "verification/chapters/scene_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <stdexcept>

#include "engine/core/read_file.h"
#include "engine/record/atomic_file.h"
#include "verification/study/process_pool.h"

namespace verify {
namespace {

using Json = SceneFolder::Scene;

Json json_file(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) return nullptr;
  return Json::parse(dda::read_file(path), nullptr, false);
}

}  // namespace

const std::vector<double>& SceneRun::at(const std::string& column) const {
  const auto found = std::ranges::find(histories.columns, column, &dda::HistoryColumn::name);
  if (found == histories.columns.end()) throw std::out_of_range("run " + name + " has no history \"" + column + "\"");
  return found->values;
}

std::vector<double> SceneRun::size_of(const std::string& quantity) const {
  const std::vector<double>& x = at(quantity + "_x");
  const std::vector<double>& y = at(quantity + "_y");
  std::vector<double> size(x.size());
  for (std::size_t row = 0; row < x.size(); ++row) size[row] = std::hypot(x[row], y[row]);
  return size;
}

std::size_t SceneRun::settled_row() const {
  std::size_t row = 0;
  while (row + 1 < times().size() && times()[row + 1] == times().front()) ++row;
  return row;
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
  // As many runs as there are cores go on at once, so each has one thread.
  carry_out(names, {"run", "--frames", "10", "--threads", "1"}, "summary.json");
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
  if (run.ok()) run.histories = dda::read_histories(results(name) / "histories.csv");
  return run;
}

std::string SceneFolder::picture(const std::string& name) const {
  const std::filesystem::path file = results(name) / "last.svg";
  const Command command{program_.string(), "view", results(name).string(), "--svg",        "last",  "--crosses",
                        "--forces",        "none", "--quantity",           "displacement", "--out", file.string()};
  return failure_of(command).empty() && std::filesystem::exists(file) ? dda::read_file(file) : "";
}

Json SceneFolder::key_blocks(const std::string& name) const {
  const Json file = json_file(results(name) / "keyblocks.json");
  return file.is_object() ? file.value("blocks", Json::array()) : Json::array();
}

}  // namespace verify
