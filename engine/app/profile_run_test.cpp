// dda run --profile: the same results with it and without, and a file for trace viewers.
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/app/command_line_test_support.h"

namespace dda {
namespace {

using Json = nlohmann::json;

// Gravity is switched on at once on a slab that can lift off and slide.
constexpr auto slab_on_floor = R"({"dda": 1, "gravity": 9.81,
 "materials": {"rock": {"density": 2600, "young": "10 GPa", "poisson": 0.2}},
 "joints": {"default": {"friction_angle": "30 deg"}},
 "blocks": [{"polygon": {"name": "floor", "vertices": [[-1, -1], [2, -1], [2, 0], [-1, 0]]}},
            {"polygon": {"name": "slab", "vertices": [[0, 0], [1, 0], [1, 0.2], [0, 0.2]]}}],
 "supports": [{"edge": "bottom", "stiffness": 2e12}],
 "steps": {"dt": "1 ms", "duration": "0.2 s"}})";

class ProfiledRun : public CommandLine {
 protected:
  Outcome run(const std::string& folder, std::vector<std::string> options = {}) {
    options.insert(options.begin(), {"run", path("scene.json"), "--out", path(folder), "--frames", "3"});
    return call(options);
  }

  [[nodiscard]] std::map<std::string, std::string> results(const std::string& folder) const {
    auto files = results_without_times(folder);
    files.erase("profile.json");
    return files;
  }
};

TEST_F(ProfiledRun, LeavesTheSameBytes) {
  for (const std::string& scene : {bar_scene(12, 30), std::string(slab_on_floor)}) {
    write("scene.json", scene);
    ASSERT_EQ(run("plain").code, 0);
    ASSERT_EQ(run("profiled", {"--profile"}).code, 0);
    EXPECT_FALSE(exists("plain/profile.json"));
    EXPECT_EQ(results("plain"), results("profiled"));
  }
}

TEST_F(ProfiledRun, PrintsItsPhasesAndWritesATrace) {
  write("scene.json", slab_on_floor);
  const Outcome outcome = run("results", {"--profile"});
  ASSERT_EQ(outcome.code, 0);
  for (const char* phase : {"reading and setting up", "contact search", "contact judging", "assembly",
                            "update and energies", "frames", "other", "open_close_iterations"})
    EXPECT_NE(outcome.out.find(phase), std::string::npos) << phase << " in\n" << outcome.out;
  const Json trace = Json::parse(text("results/profile.json"));
  const Json& profile = trace.at("otherData");
  const std::int64_t steps = profile.at("counters").at("steps");
  EXPECT_GE(steps, 200);  // more where steps were cut
  for (const Json& phase : profile.at("phases"))
    if (phase.at("name") == "update and energies") {
      EXPECT_EQ(phase.at("calls"), steps);
    }
  EXPECT_GT(trace.at("traceEvents").size(), 1000U);
  const Json summary = Json::parse(text("results/summary.json"));
  EXPECT_EQ(summary.at("outputs").back(), "profile.json");
}

TEST_F(ProfiledRun, QuietOnesPrintNothing) {
  write("scene.json", bar_scene(3, 5));
  EXPECT_EQ(run("results", {"--profile", "--quiet"}).out, "");
  EXPECT_TRUE(exists("results/profile.json"));
}

}  // namespace
}  // namespace dda
