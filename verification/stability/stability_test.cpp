#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "verification/stability/cell.h"
#include "verification/stability/scenes.h"

namespace verify {
namespace {

Setting ordinary(ChartProblem problem) {
  Setting setting;
  setting.problem = problem;
  setting.dt = problem == ChartProblem::pulse ? 1e-5 : 1e-3;
  return setting;
}

// So what is said in other cells comes of what is extreme in them.
TEST(Stability, OrdinaryScenesAreCorrectAndNothingIsSaidOfThem) {
  for (const ChartProblem problem : all_problems) {
    const Cell cell = run_cell(ordinary(problem), scene_of(ordinary(problem)));
    EXPECT_EQ(cell.outcome, RunOutcome::right) << name_of(problem) << ": " << cell.message;
    EXPECT_TRUE(cell.said.empty()) << name_of(problem) << ": " << cell.said.front();
  }
}

// Answers that could not fail would make every cell green: each scene with one thing wrong that no run can know of.
TEST(Stability, AWrongRunIsSilentlyWrong) {
  const auto outcome = [](ChartProblem problem, const auto& spoil) {
    const Setting setting = ordinary(problem);
    nlohmann::ordered_json scene = scene_of(setting);
    spoil(scene);
    const Cell cell = run_cell(setting, scene);
    EXPECT_TRUE(cell.message.empty()) << cell.message;
    return cell.outcome;
  };
  EXPECT_EQ(outcome(ChartProblem::pulse, [](auto& scene) { scene["materials"]["heavy"]["young"] = 14e9; }),
            RunOutcome::silent);
  EXPECT_EQ(outcome(ChartProblem::wall, [](auto& scene) { scene["gravity"] = 9.7; }), RunOutcome::silent);
  EXPECT_EQ(
      outcome(ChartProblem::incline, [](auto& scene) { scene["joints"]["default"]["friction_angle"] = "15.2 deg"; }),
      RunOutcome::silent);
  EXPECT_EQ(outcome(ChartProblem::pile, [](auto& scene) { scene["gravity"] = 11; }), RunOutcome::silent);
}

TEST(Stability, RefusedAndStoppedRunsKeepTheirReason) {
  Setting setting = ordinary(ChartProblem::incline);
  nlohmann::ordered_json scene = scene_of(setting);
  scene["joints"]["default"]["spring_over_young"] = -1;
  const Cell refused = run_cell(setting, scene);
  EXPECT_EQ(refused.outcome, RunOutcome::refused);
  EXPECT_NE(refused.message.find("spring_over_young"), std::string::npos) << refused.message;

  scene = scene_of(setting);
  scene["steps"] = {{{"integrator", "static"}}};  // with the joints' own strength: blocks that slide find no rest
  const Cell stopped = run_cell(setting, scene);
  EXPECT_EQ(stopped.outcome, RunOutcome::stopped);
  EXPECT_NE(stopped.message.find("not_in_equilibrium"), std::string::npos) << stopped.message;
}

TEST(Stability, ANumberThatIsNoneDoesNotHold) {
  EXPECT_FALSE((Check{"", std::numeric_limits<double>::quiet_NaN(), 1}.holds()));
  EXPECT_FALSE((Check{"", std::numeric_limits<double>::infinity(), 1}.holds()));
  EXPECT_TRUE((Check{"", 1, 1}.holds()));
}

}  // namespace
}  // namespace verify
