// Rock cut at random settles and stands: seeded scenes of two or three joint sets, full lines and persistent joints,
// between held walls. What is asked of each: it ends ok, nothing gains energy, nothing is pressed in.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "engine/app/command_line_test_support.h"

namespace dda {
namespace {

class RandomRock : public CommandLine, public testing::WithParamInterface<int> {
 protected:
  void expect_to_settle_and_stand(const nlohmann::json& stages);
};

nlohmann::json polygon(const std::string& name, double left, double bottom, double right, double top) {
  return {{"polygon", {{"name", name}, {"vertices", {{left, bottom}, {right, bottom}, {right, top}, {left, top}}}}}};
}

nlohmann::json random_rock(int seed, const nlohmann::json& stages) {
  std::mt19937_64 random(static_cast<unsigned>(seed));
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11U) * 0x1p-53;
  };
  const auto degrees = [&](double low, double high) { return fmt::format("{:.2f} deg", between(low, high)); };
  const double spacing = between(1.0, 2.2);
  nlohmann::json steep = {{"dip", {{"mean", degrees(35, 80)}, {"deviation", degrees(0, 8)}}},
                          {"spacing", {{"mean", spacing}, {"deviation", 0.3 * spacing}}},
                          {"name", "steep"},
                          {"joint", "dry"}};
  nlohmann::json flat = {{"dip", {{"mean", degrees(-25, 25)}, {"deviation", degrees(0, 8)}}},
                         {"spacing", {{"mean", spacing}, {"distribution", "exponential"}}},
                         {"joint", "dry"}};
  if (seed % 2 == 1) {
    flat["trace_length"] = between(2, 5);
    flat["persistence"] = between(0.5, 0.95);
    flat["ends_at"] = {"steep"};
  }
  const nlohmann::json rock = {
      {"boundary", {{0, 0}, {10, 0}, {10, 10}, {0, 10}}}, {"joint_sets", {steep, flat}}, {"seed", seed}};
  return {{"dda", 1},
          {"materials", {{"rock", {{"density", 2600}, {"young", 10e9}, {"poisson", 0.2}}}}},
          {"joints", {{"default", {{"friction_angle", "30 deg"}}}, {"dry", {{"friction_angle", degrees(25, 40)}}}}},
          {"blocks",
           {{{"rock", rock}},
            polygon("bottom", -1, -1, 11, 0),
            polygon("left", -1, 0, 0, 10),
            polygon("right", 10, 0, 11, 10)}},
          {"fixed", {"bottom", "left", "right"}},
          {"gravity", 9.81},
          {"steps", stages}};
}

void RandomRock::expect_to_settle_and_stand(const nlohmann::json& stages) {
  write("rock.json", random_rock(GetParam(), stages).dump());
  const Outcome run = call({"run", path("rock.json"), "--out", path("out"), "--quiet"});
  ASSERT_EQ(run.code, 0) << run.errors;
  const nlohmann::json summary = nlohmann::json::parse(text("out/summary.json"));
  EXPECT_EQ(summary["status"], "ok");
  const nlohmann::json& energy = summary["energy"];
  // What comes from nowhere would be numerical and negative; the ledger holds to 1e-9 besides.
  EXPECT_GT(energy["numerical"].get<double>(), -1e-3 * energy["gravity_work"].get<double>());
  EXPECT_LT(std::abs(energy["residual_relative"].get<double>()), 1e-9);
}

TEST_P(RandomRock, SettlesAndStands) {
  expect_to_settle_and_stand(
      {{{"integrator", "static"}, {"strength", "unlimited"}, {"equilibrium", 1e-6}, {"dt", 1.0}, {"duration", 200.0}},
       {{"dt", 1e-3}, {"duration", 0.05}}});
}

// Nothing is stated: neither penalty nor time step nor how far from balance, and joints have their own strength.
TEST_P(RandomRock, SettlesAndStandsByDefault) {
  expect_to_settle_and_stand({{{"integrator", "static"}}, {{"duration", 0.05}}});
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomRock, testing::Range(1, 17));

}  // namespace
}  // namespace dda
