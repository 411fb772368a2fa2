// What `dda check` calls the contacts of blocks.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "engine/app/command_line_test_support.h"
#include "engine/app/random_rock_test_support.h"

namespace dda {
namespace {

using nlohmann::json;

json polygon(const char* name, const json& vertices) { return {{"polygon", {{"name", name}, {"vertices", vertices}}}}; }

std::string scene_of(const json& blocks) {
  const json scene = {
      {"dda", 1},
      {"materials", {{"rock", {{"density", 2600}, {"young", 20e9}, {"poisson", 0.2}}}}},
      {"joints", {{"default", {{"law", "classical"}, {"normal_stiffness", "auto"}, {"friction_angle", "35 deg"}}}}},
      {"blocks", blocks},
      {"fixed", {"below"}},
      {"steps", {{"dt", 1e-4}, {"duration", 1e-3}}}};
  return scene.dump();
}

// Two blocks with so many teeth between them, by lot: each face is held by a spring at each of its ends.
TEST_F(CommandLine, CallsSpringsOfFacesWhatTheyAre) {
  for (int seed = 0; seed < 12; ++seed) {
    RockByLot lot(seed);
    const int faces = 2 * static_cast<int>(lot.between(1, 7));
    json line;
    for (int i = 0; i <= faces; ++i) line.push_back({i, i % 2 == 0 ? 0.0 : lot.between(0.2, 0.6)});
    json below = {{0, -2}, {faces, -2}}, above = line;
    for (auto point = line.rbegin(); point != line.rend(); ++point) below.push_back(*point);
    above.push_back({faces, 3});
    above.push_back({0, 3});
    write("scene.json", scene_of({polygon("below", below), polygon("above", above)}));
    const Outcome outcome = call({"check", path("scene.json")});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    const std::string told = fmt::format("{0} interfaces, {0} of them springs at ends of faces", 2 * faces);
    EXPECT_TRUE(contains(outcome.out, told)) << told << " not in " << outcome.out;
    EXPECT_FALSE(contains(outcome.out, "in a point")) << outcome.out;
  }
}

TEST_F(CommandLine, CallsACornerOnAFaceAPoint) {
  write("scene.json", scene_of({polygon("below", {{0, -2}, {4, -2}, {4, 0}, {0, 0}}),
                                polygon("above", {{2, 0}, {3, 1}, {2, 2}, {1, 1}})}));
  const Outcome outcome = call({"check", path("scene.json")});
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_TRUE(contains(outcome.out, "1 interface, 1 of them in a point")) << outcome.out;
}

}  // namespace
}  // namespace dda
