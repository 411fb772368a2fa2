#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "verification/differential/comparison.h"
#include "verification/differential/differential_command.h"
#include "verification/differential/random_scene.h"

namespace verify {
namespace {

TEST(Differential, SeedsGiveTheSameSceneAgainAndAllFeaturesOccur) {
  EXPECT_EQ(random_scene(7), random_scene(7));
  std::set<std::string> keys, laws;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const nlohmann::ordered_json scene = random_scene(seed);
    for (const auto& [key, value] : scene.items()) keys.insert(key);
    laws.insert(scene["joints"]["default"]["law"].get<std::string>());
  }
  for (const char* key : {"bolts", "fixed", "gravity", "loads", "stress_field", "supports", "viscous_boundaries"})
    EXPECT_TRUE(keys.contains(key)) << key;
  EXPECT_EQ(laws, (std::set<std::string>{"classical", "consistent", "cubic", "projected"}));
}

// Stages of different steps in bonded rock, stopped in the second: gravity was that of the first one's inertia.
TEST(Differential, LinearStagesOfDifferentStepsGoOnToTheBit) {
  EXPECT_EQ(compare_runs(random_scene(14)).agreement, Agreement::agreed) << compare_runs(random_scene(14)).what;
}

TEST(Differential, RefusedScenesAreCounted) {
  nlohmann::ordered_json scene = random_scene(1);
  scene["steps"][0]["dt"] = -1;
  const Comparison refused = compare_runs(scene);
  EXPECT_EQ(refused.agreement, Agreement::refused);
  EXPECT_NE(refused.what.find("dt"), std::string::npos) << refused.what;
}

TEST(Differential, CountsEveryScene) {
  std::ostringstream out, errors;
  EXPECT_EQ(compare_scenes({.seed = 1, .count = 5, .folder = {}, .verbose = true}, out, errors), 0) << errors.str();
  EXPECT_NE(out.str().find("seed 5: "), std::string::npos) << out.str();
}

}  // namespace
}  // namespace verify
