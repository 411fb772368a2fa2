// The program's commands called as from a shell, for the tests of this folder.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "engine/app/app_test_support.h"
#include "engine/app/command_line.h"

namespace dda {

struct Outcome {
  int code;
  std::string out;
  std::string errors;
};

inline Outcome call(const std::vector<std::string>& arguments) {
  std::vector<const char*> argv = {"dda"};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  std::ostringstream out;
  std::ostringstream errors;
  const int code = run_command_line(static_cast<int>(argv.size()), argv.data(), out, errors);
  return {code, out.str(), errors.str()};
}

inline std::ptrdiff_t lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

inline bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

class CommandLine : public FolderTest {
 protected:
  // Writes FOLDER.json and runs it into FOLDER.
  [[nodiscard]] Outcome run_scene(const std::string& scene, const std::string& folder,
                                  const std::vector<std::string>& options = {}) const {
    write(folder + ".json", scene);
    std::vector<std::string> arguments = {"run", path(folder + ".json"), "--out", path(folder), "--quiet"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return call(arguments);
  }

  // All that a run left, but its times and, because one file may hold them, the list of files.
  [[nodiscard]] std::map<std::string, std::string> results_without_times(const std::string& folder) const {
    auto files = files_below(folder);
    auto summary = nlohmann::ordered_json::parse(files.at("summary.json"));
    for (const char* changing : {"cpu_s", "wall_s", "phases", "outputs"}) EXPECT_EQ(summary.erase(changing), 1U);
    files["summary.json"] = summary.dump();
    return files;
  }

  void expect_refusal(const std::vector<std::string>& arguments, std::string_view part) {
    const Outcome outcome = call(arguments);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(lines(outcome.errors), 1) << outcome.errors;
    EXPECT_TRUE(contains(outcome.errors, part)) << outcome.errors;
    EXPECT_FALSE(exists("out"));
  }
};

}  // namespace dda
