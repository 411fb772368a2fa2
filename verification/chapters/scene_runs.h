// Scenes that a study writes, runs as a user would, and reads: DIR/scenes/NAME.json, `dda run` into DIR/runs/NAME.
#pragma once

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/view/histories.h"

namespace verify {

struct SceneRun {
  std::string name;
  std::string status;        // as in summary.json; "missing" without one
  std::string message;       // why it is not ok
  dda::Histories histories;  // SI

  [[nodiscard]] bool ok() const { return status == "ok"; }
  [[nodiscard]] const std::vector<double>& times() const { return histories.times; }  // s
  [[nodiscard]] const std::vector<double>& at(const std::string& column) const;       // throws std::out_of_range
  // Length, row by row, of the vector with the columns `quantity`_x and `quantity`_y.
  [[nodiscard]] std::vector<double> size_of(const std::string& quantity) const;
  // The first row behind the stages that take no time: rows of one time are theirs, and the last of them is the settled
  // state.
  [[nodiscard]] std::size_t settled_row() const;
};

class SceneFolder {
 public:
  using Scene = nlohmann::ordered_json;

  // `program` is dda; `at_once` processes run side by side; a line is told of every run that ends.
  SceneFolder(std::filesystem::path folder, std::filesystem::path program, int at_once, std::ostream& out);

  // Writes the scene. A run of another scene under this name is removed, one of the same scene stays.
  void put(const std::string& name, const Scene& scene) const;

  // Runs those that have not ended yet. Run and interrupted runs begin anew.
  void run(const std::vector<std::string>& names) const;
  // `dda keyblocks` of those scenes at the opening, into runs/NAME/keyblocks.json.
  void find_key_blocks(const std::vector<std::string>& names, const std::string& opening) const;

  [[nodiscard]] SceneRun read(const std::string& name) const;
  // The last frame of a run with the principal stresses of its blocks, as SVG; "" where there is none.
  [[nodiscard]] std::string picture(const std::string& name) const;
  [[nodiscard]] Scene key_blocks(const std::string& name) const;  // bodies at free faces; empty if that failed

 private:
  [[nodiscard]] std::filesystem::path scene(const std::string& name) const;
  [[nodiscard]] std::filesystem::path results(const std::string& name) const;
  void carry_out(const std::vector<std::string>& names, const std::vector<std::string>& arguments,
                 const std::string& result) const;

  std::filesystem::path folder_;
  std::filesystem::path program_;
  int at_once_;
  std::ostream& out_;
};

}  // namespace verify
