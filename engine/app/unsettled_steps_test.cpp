// Steps whose contacts found no balance as a whole, and were taken in parts: a run says so, since another solver may
// find one. Judged by two solvers that part, and by Painleve's rod, which has no balance while it slides one way.
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "engine/app/command_line_test_support.h"

namespace dda {
namespace {

using nlohmann::json;

class Unsettled : public CommandLine {
 protected:
  json summary_of(json scene, const char* solver) {
    scene["steps"]["solver"] = solver;
    write("scene.json", scene.dump());
    (void)call({"run", path("scene.json"), "--out", path(solver), "--quiet"});
    return json::parse(text(std::string(solver) + "/summary.json"));
  }

  // The rows of its histories.
  std::vector<std::vector<double>> rows_of(const char* solver) {
    std::istringstream lines(text(std::string(solver) + "/histories.csv"));
    std::vector<std::vector<double>> rows;
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
      std::istringstream cells(line);
      std::string cell;
      rows.emplace_back();
      while (std::getline(cells, cell, ',')) rows.back().push_back(std::stod(cell));
    }
    return rows;
  }
};

json rock() { return {{"rock", {{"density", 2600}, {"young", 20e9}, {"poisson", 0.2}}}}; }

json box(const char* name, double left, double bottom, double right, double top) {
  return {{"polygon", {{"name", name}, {"vertices", {{left, bottom}, {right, bottom}, {right, top}, {left, top}}}}}};
}

// A rod of 2 m at `angle` to a floor on which its lower end slides with `speed`.
json sliding_rod(double friction, double angle, double speed) {
  const double c = std::cos(angle), s = std::sin(angle), length = 2, width = 0.1;
  const json outline = {
      {0, 0}, {c * length, s * length}, {c * length - s * width, s * length + c * width}, {-s * width, c * width}};
  return {{"dda", 1},
          {"materials", rock()},
          {"joints", {{"default", {{"friction_angle", std::atan(friction)}}}}},
          {"blocks",
           {box("floor", -20, -1, 20, 0),
            {{"polygon", {{"name", "rod"}, {"vertices", outline}, {"initial_velocity", {speed, 0}}}}}}},
          {"fixed", {"floor"}},
          {"gravity", 9.81},
          {"measurements", {{{"quantity", "displacement_x"}, {"block", "rod"}}}},
          {"steps", {{"dt", "1 ms"}, {"duration", "60 ms"}}}};
}

// A flat box on a plane that falls to the right, both drawn as they lie.
json box_on_plane(double angle, double friction, double young) {
  const double c = std::cos(angle), s = std::sin(angle);
  const auto at = [&](double down, double above) { return json{down * c + above * s, above * c - down * s}; };
  const json plane = {at(-5, 0), at(-5, -3), at(20, -3), at(20, 0)};
  const json flat = {at(-1, 0), at(1, 0), at(1, 0.4), at(-1, 0.4)};
  json scene = {
      {"dda", 1},
      {"materials", {{"rock", {{"density", 2600}, {"young", young}, {"poisson", 0.2}}}}},
      {"joints", {{"default", {{"friction_angle", std::atan(friction)}}}}},
      {"blocks",
       {{{"polygon", {{"name", "plane"}, {"vertices", plane}}}}, {{"polygon", {{"name", "box"}, {"vertices", flat}}}}}},
      {"fixed", {"plane"}},
      {"gravity", 9.81},
      {"measurements", {{{"quantity", "displacement_x"}, {"block", "box"}}}},
      {"steps", {{"dt", "2 ms"}, {"duration", "1 s"}}}};
  return scene;
}

// Stiff springs make forces of the way that a step carries a block along an inclined plane, of which round-off leaves
// more than a balance to 1e-10 of the weight allows: half of the steps were taken in parts.
TEST_F(Unsettled, ABoxThatSlidesDownAPlaneIsSettledAtOnce) {
  for (const double degrees : {15.0, 28.0, 50.0})
    for (const double young : {20e9, 70e9, 300e9}) {
      const double angle = degrees * std::numbers::pi / 180, friction = 0.7 * std::tan(angle);
      const json summary = summary_of(box_on_plane(angle, friction, young), "cholesky");
      EXPECT_FALSE(summary.contains("unsettled_steps")) << degrees << ", " << young;
      EXPECT_LT(summary["counters"]["solves"], 600) << degrees << ", " << young;  // of 500 steps
      const double slid = (std::sin(angle) - friction * std::cos(angle)) * 9.81 / 2;
      EXPECT_NEAR(rows_of("cholesky").back()[1], slid * std::cos(angle), 1e-4 * slid) << degrees << ", " << young;
      const double work = friction * std::cos(angle) * 2600 * 0.8 * 9.81 * slid;
      EXPECT_NEAR(summary["energy"]["friction"].get<double>(), work, 1e-3 * work) << degrees << ", " << young;
    }
}

// A column that topples over its lower corner, which slides: what friction takes is what it does, and not what parts of
// steps make of it (2,600 times as much, by which such runs ended as gained_energy).
TEST_F(Unsettled, ACornerThatSlidesIsSettledAtOnce) {
  const double tilt = 30 * std::numbers::pi / 180, c = std::cos(tilt), s = std::sin(tilt);
  for (const double young : {20e9, 70e9, 200e9}) {
    json scene = box_on_plane(0, std::tan(20 * std::numbers::pi / 180), young);
    scene["blocks"][1]["polygon"]["vertices"] = {
        {0, 0}, {3 * s, 3 * c}, {3 * s - 0.5 * c, 3 * c + 0.5 * s}, {-0.5 * c, 0.5 * s}};
    scene["steps"]["duration"] = "0.9 s";
    const json summary = summary_of(scene, "cholesky");
    EXPECT_FALSE(summary.contains("unsettled_steps")) << young;
    EXPECT_EQ(summary["status"], "ok") << young;
    EXPECT_NEAR(summary["energy"]["friction"].get<double>(), 196.5, 2) << young;  // 189 of 2,500 kg/m3
  }
}

// Painleve 1895: above a friction of 4/3 a slender rod that is pushed ahead of its contact presses itself the harder
// onto the floor the faster the floor stops it, and there is no balance in which it slides on. Pulled, it has one.
TEST_F(Unsettled, PainlevesRodIsSaidToHaveNoBalance) {
  for (const double degrees : {50.0, 60.0, 65.0})
    for (const double friction : {2.0, 3.0}) {
      const double angle = degrees * std::numbers::pi / 180;
      const json pushed = summary_of(sliding_rod(friction, angle, -5), "cholesky");
      ASSERT_TRUE(pushed.contains("unsettled_steps")) << degrees << ", " << friction;
      EXPECT_GE(pushed["unsettled_steps"]["count"], 1);
      EXPECT_EQ(pushed["unsettled_steps"]["first_blocks"], json({"floor", "rod"}));
      EXPECT_TRUE(contains(pushed["remarks"].dump(), "contacts left the answer open in ")) << pushed["remarks"];
      EXPECT_FALSE(summary_of(sliding_rod(friction, angle, 5), "cholesky").contains("unsettled_steps"));
      EXPECT_FALSE(summary_of(sliding_rod(0.5, angle, -5), "cholesky").contains("unsettled_steps"));
    }
}

// Bricks without bonds that fall on a floor and start with any velocity, every second time.
json loose_bricks(unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
  };
  const int columns = static_cast<int>(between(3, 7)), rows = static_cast<int>(between(3, 8));
  const double height = between(0.3, 1), tilt = between(-0.4, 0.4);
  const double dt = std::vector<double>{1e-3, 2e-3, 5e-3}[static_cast<std::size_t>(between(0, 3))];
  json grid = {
      {"columns", columns}, {"rows", rows}, {"block_width", 1}, {"block_height", height}, {"pattern", "running_bond"}};
  if (seed % 2 == 1) grid["initial_velocity"] = {between(-1, 1), between(-1, 0)};
  json measurements = json::array();
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      for (const char* quantity : {"displacement_x", "displacement_y"})
        measurements.push_back(
            {{"quantity", quantity}, {"point", {column + (row % 2 == 0 ? 0.37 : 0.63), (row + 0.47) * height}}});
  json materials = rock();
  materials["rock"]["young"] = std::vector<double>{5e9, 20e9, 50e9}[static_cast<std::size_t>(between(0, 3))];
  return {
      {"dda", 1},
      {"materials", materials},
      {"joints", {{"default", {{"friction_angle", between(10, 45) * std::numbers::pi / 180}, {"law", "classical"}}}}},
      {"blocks", {{{"grid", grid}}, box("base", -3, -1, columns + 3, 0)}},
      {"fixed", {"base"}},
      {"gravity", {9.81 * std::sin(tilt), -9.81}},
      {"measurements", measurements},
      {"steps", {{"dt", dt}, {"duration", 60 * dt}}}};
}

// Whether two runs of one scene part by more than 1e-6 of the largest motion, at any time.
bool differ(const std::vector<std::vector<double>>& one, const std::vector<std::vector<double>>& other) {
  for (std::size_t row = 0; row < std::min(one.size(), other.size()); ++row) {
    double motion = 0, apart = 0;
    for (std::size_t i = 1; i < one[row].size(); ++i) {
      motion = std::max(motion, std::abs(one[row][i]));
      apart = std::max(apart, std::abs(one[row][i] - other[row][i]));
    }
    if (apart > 1e-6 * motion) return true;
  }
  return one.size() != other.size();
}

TEST_F(Unsettled, RunsThatDependOnTheSolverAreAnnounced) {
  int differing = 0, announced = 0, agreeing = 0, announced_in_vain = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    const json scene = loose_bricks(seed);
    std::vector<bool> said;
    for (const char* solver : {"cholesky", "pcg"})
      said.push_back(summary_of(scene, solver).contains("unsettled_steps"));
    const bool part = differ(rows_of("cholesky"), rows_of("pcg"));
    const auto times = static_cast<int>(std::ranges::count(said, true));
    (part ? differing : agreeing) += 2;
    (part ? announced : announced_in_vain) += times;
  }
  EXPECT_GE(differing, 12);
  EXPECT_GE(announced, 0.9 * differing) << announced << " of " << differing;
  EXPECT_LE(announced_in_vain, 0.15 * agreeing) << announced_in_vain << " of " << agreeing;
}

}  // namespace
}  // namespace dda
