// What a run says of a static stage that is no equilibrium.
#include "engine/simulation/equilibrium.h"

#include <gtest/gtest.h>

#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

std::string told(const Stage& stage, double out_of_balance) {
  Model model;
  model.stages = {stage};
  return equilibrium_problem(model, {.stage = 0, .out_of_balance = out_of_balance, .loose = {}, .unbalanced = {}});
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Equilibrium, TellsWhatBearsWithTheLittleThatSpringsLeave) {
  const Stage paced = settling_stage(1e-9);
  EXPECT_EQ(told(paced, 1e-9), "");
  EXPECT_TRUE(contains(told(paced, 3.6e-9), "\"equilibrium\": 1e-08")) << told(paced, 3.6e-9);
  EXPECT_TRUE(contains(told(paced, 2e-7), "\"equilibrium\": 1e-06")) << told(paced, 2e-7);
  EXPECT_FALSE(contains(told(paced, 1e-3), "equilibrium\":")) << "that is no hopping";
  Stage given = stage_of(static_integrator(), 1, 10);
  given.equilibrium = 1e-9;
  EXPECT_TRUE(contains(told(given, 3.6e-9), "more steps")) << told(given, 3.6e-9);
}

}  // namespace
}  // namespace dda
