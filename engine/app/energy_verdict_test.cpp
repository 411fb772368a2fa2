// Runs whose energies say that the result is wrong.
#include <nlohmann/json.hpp>

#include "engine/app/command_line_test_support.h"

namespace dda {
namespace {

class Verdict : public CommandLine {};

// A support that moves off at once pushes a damped bar.
nlohmann::json pushed_bar(const char* dt) {
  return {{"dda", 1},
          {"materials", {{"rock", {{"density", 2500}, {"young", 20e9}, {"poisson", 0}}}}},
          {"joints", {{"default", {{"bonded", true}}}}},
          {"blocks", {{"bar", {{"length", 20}, {"height", 1}, {"block_length", 0.5}}}}},
          {"supports",
           {{{"name", "piston"}, {"edge", "left"}, {"hold", "x"}, {"velocity", {0.1, 0}}},
            {{"point", {0.25, 0}}, {"hold", "y"}},
            {{"point", {20, 0}}, {"hold", "y"}}}},
          {"steps",
           {{"dt", dt},
            {"duration", "2 ms"},
            {"kinematics", "small"},
            {"damping", {{"ratio", 0.02}, {"frequency", "100 Hz"}}}}}};
}

TEST_F(Verdict, DampersThatGiveEnergyMakeARunInaccurate) {
  write("bar.json", pushed_bar("1e-4 s").dump());
  const Outcome outcome = call({"run", path("bar.json"), "--out", path("out"), "--quiet"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_TRUE(contains(outcome.errors, "damping gave")) << outcome.errors;
  EXPECT_TRUE(contains(outcome.errors, "take a smaller dt")) << outcome.errors;
}

TEST_F(Verdict, DampersThatTakeEnergyAreFine) {
  write("bar.json", pushed_bar("1e-6 s").dump());
  const Outcome outcome = call({"run", path("bar.json"), "--out", path("out"), "--quiet"});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_FALSE(contains(outcome.errors, "damping gave"));
}

}  // namespace
}  // namespace dda
