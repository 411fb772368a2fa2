// What the tests of this folder share.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "engine/core/read_file.h"
#include "engine/core/temporary_folder.h"
#include "engine/record/atomic_file.h"

namespace dda {

// A folder of its own for every test, with scene.json and what the program makes of it.
class FolderTest : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
  void write(const std::string& name, std::string_view text) const { write_file(folder_ / name, text); }
  [[nodiscard]] std::string text(const std::string& name) const { return read_file(folder_ / name); }

  // All files below `name` and what is in them.
  [[nodiscard]] std::map<std::string, std::string> files_below(const std::string& name) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / name)) {
      if (!entry.is_regular_file()) continue;
      const auto relative = std::filesystem::relative(entry.path(), folder_.path());
      files[std::filesystem::relative(entry.path(), folder_ / name).string()] = text(relative.string());
    }
    return files;
  }

 private:
  TemporaryFolder folder_;
};

// A bonded bar under a sine, `blocks` of 1 m, for `steps` steps.
inline std::string bar_scene(int blocks, int steps) {
  return fmt::format(R"({{"dda": 1, "title": "bar",
 "materials": {{"rock": {{"density": 2650, "young": "50 GPa", "poisson": 0.25}}}},
 "joints": {{"default": {{"bonded": true}}}},
 "blocks": {{"bar": {{"length": {}, "height": 1, "block_length": 1}}}},
 "loads": [{{"edge": "left", "force": ["1 MN", 0], "history": {{"sine": {{"frequency": "100 Hz"}}}}}}],
 "measurements": [{{"name": "stress", "quantity": "stress_xx", "point": [1.5, 0.5]}},
                  {{"quantity": "traction_normal", "point": [2, 0.5]}}],
 "steps": {{"dt": 1e-5, "duration": {}, "kinematics": "small"}}}})",
                     blocks, steps * 1e-5);
}

// A stone that falls on a floor it does not touch at the start. All joints being bonded, contacts are not followed.
inline constexpr auto falling_stone = R"({"dda": 1,
 "materials": {"rock": {"density": 2600, "young": "10 GPa", "poisson": 0.2}},
 "joints": {"default": {"bonded": true}},
 "blocks": [{"polygon": {"name": "floor", "vertices": [[0, 0], [3, 0], [3, 1], [0, 1]]}},
            {"polygon": {"name": "stone", "vertices": [[1, 1.1], [2, 1.1], [2, 2.1], [1, 2.1]],
                         "initial_velocity": [0, -1]}}],
 "measurements": [{"quantity": "displacement_y", "block": "stone"}],
 "steps": {"dt": "1 ms", "duration": "1 s"}})";

// Gravity switched on at once on a slab that rests on a floor.
inline constexpr auto restless_slab = R"({"dda": 1, "gravity": 9.81,
 "materials": {"rock": {"density": 2600, "young": "10 GPa", "poisson": 0.2}},
 "joints": {"default": {"friction_angle": "30 deg"}},
 "blocks": [{"polygon": {"name": "floor", "vertices": [[-1, -1], [2, -1], [2, 0], [-1, 0]]}},
            {"polygon": {"name": "slab", "vertices": [[0, 0], [1, 0], [1, 0.2], [0, 0.2]]}}],
 "supports": [{"edge": "bottom", "stiffness": 2e12}],
 "steps": {"dt": "1 ms", "duration": "0.2 s", "integrator": {"generalized_alpha": 0.95}}})";

}  // namespace dda
