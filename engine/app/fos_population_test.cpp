// `dda fos` of a block on a plane against limit equilibrium: loads, weight and strength come and go with stages by lot,
// and what acts in the end decides.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "engine/app/command_line_test_support.h"
#include "engine/geometry/cut_pieces.h"
#include "engine/geometry/polygon.h"

namespace dda {
namespace {

using nlohmann::json;

constexpr double degree = std::numbers::pi / 180;
constexpr double standard_gravity = 9.81;  // m/s2
constexpr double width = 0.005;            // of the interval that is found

json pair_of(const Vec2& vector) { return {vector.x(), vector.y()}; }

// u runs up the slope and v out of it. Forces are those on the block, N per m of thickness.
class BlockOnAPlane {
 public:
  explicit BlockOnAPlane(std::uint64_t seed) : random_(seed) {
    turn_ = Eigen::Rotation2Dd(random_.number(15, 55) * degree).toRotationMatrix();
    if (random_.chance(0.5)) turn_.row(0) *= -1;
    size_ = random_.magnitude(-1, 1.5);
    length_ = size_ * random_.number(2, 4);
    height_ = length_ * random_.number(0.1, 0.3);
    density_ = random_.number(2000, 3000);
    friction_ = random_.number(20, 50) * degree;
    draw();
    if (random_.chance(0.4)) cohere();
    if (random_.chance(0.5)) load();
    if (random_.chance(0.4)) press();
    if (random_.chance(0.5)) weaken();
    if (random_.chance(0.5)) soak();
    if (random_.chance(0.3)) add_stage({{"dt", 1e-4}, {"duration", 1e-3}});
  }

  [[nodiscard]] std::string text() const { return scene_.dump(); }

  [[nodiscard]] double factor() const {
    const Vec2 weight = density_ * length_ * height_ * gravity();
    const Vec2 force = weight + force_;
    return (cohesion_ * length_ - force.y() * std::tan(friction_)) / -force.x();
  }

  // The block is pressed on, and slides down, by a fair share of its weight.
  [[nodiscard]] bool is_fit() const {
    const double weight = density_ * length_ * height_ * standard_gravity;
    const Vec2 force = density_ * length_ * height_ * gravity() + force_;
    return force.y() < -0.2 * weight && force.x() < -0.1 * weight;
  }

 private:
  [[nodiscard]] Vec2 gravity() const { return turn_.transpose() * Vec2(0, -standard_gravity); }
  [[nodiscard]] json at(double u, double v) const { return pair_of(turn_ * Vec2(u, v)); }
  [[nodiscard]] double weight_at_start() const { return density_ * length_ * height_ * standard_gravity; }

  void add_stage(json stage) {
    stage["name"] = "stage " + std::to_string(scene_["steps"].size() + 1);
    scene_["steps"].push_back(std::move(stage));
  }

  void draw() {
    const double l = length_, h = height_;
    scene_ = {
        {"dda", 1},
        {"gravity", standard_gravity},
        {"materials", {{"rock", {{"density", density_}, {"young", random_.magnitude(9, 10.7)}, {"poisson", 0.2}}}}},
        {"joints", {{"default", {{"friction_angle", friction_}}}}},
        {"fixed", {"base"}}};
    const std::string law = std::array{"", "classical", "projected"}[static_cast<std::size_t>(random_.integer(0, 2))];
    if (!law.empty()) joint()["law"] = law;
    const json base = {at(-l, -l), at(2 * l, -l), at(2 * l, 0), at(-l, 0)};
    const json box = {at(0, 0), at(l, 0), at(l, h), at(0, h)};
    scene_["blocks"] = {{{"polygon", {{"name", "base"}, {"vertices", base}}}},
                        {{"polygon", {{"name", "box"}, {"vertices", box}}}}};
    scene_["loads"] = json::array();
    add_stage({{"integrator", "static"}});
  }

  json& joint() { return scene_["joints"]["default"]; }

  // It stays when the face has slid, or the face would fail end by end.
  void cohere() {
    cohesion_ = weight_at_start() / length_ * random_.number(0.05, 0.6);
    joint()["cohesion"] = joint()["residual_cohesion"] = cohesion_;
  }

  void load() {
    const Vec2 force = weight_at_start() * Vec2(random_.number(-0.2, 0.3), -random_.number(0, 0.3));
    json load = {{"point", at(length_ / 2, 0.4 * height_)}, {"block", "box"}, {"force", pair_of(turn_ * force)}};
    const int when = random_.integer(0, 2);
    if (when > 0) add_stage({{"integrator", "static"}});
    if (when == 1) load["from_stage"] = "stage 2";
    if (when == 2) load["until_stage"] = "stage 1";
    if (when != 2) force_ += force;
    scene_["loads"].push_back(load);
  }

  void press() {
    const double pressure = weight_at_start() / length_ * random_.number(0.05, 0.5);
    force_.y() -= pressure * length_;
    scene_["loads"].push_back(
        {{"edge", {{"from", at(0, height_)}, {"to", at(length_, height_)}}}, {"pressure", pressure}});
  }

  void weaken() {
    friction_ = random_.number(15, 45) * degree;
    json change = {{"friction_angle", friction_}};
    if (cohesion_ > 0) change["cohesion"] = change["residual_cohesion"] = cohesion_ /= 2;
    add_stage({{"integrator", "static"}, {"joints", {{"default", change}}}});
  }

  void soak() {
    density_ *= random_.number(0.8, 1.2);
    add_stage({{"integrator", "static"}, {"materials", {{"rock", {{"density", density_}}}}}});
  }

  SeededNumbers random_;
  Mat2 turn_;
  double size_ = 0, length_ = 0, height_ = 0;  // m
  double density_ = 0;                         // kg/m3
  double friction_ = 0, cohesion_ = 0;
  Vec2 force_ = Vec2::Zero();  // beside the weight, in u and v
  json scene_;
};

class FosPopulation : public CommandLine {
 protected:
  void expect_factor(double factor, const std::string& scene) {
    write("scene.json", scene);
    const Outcome outcome = call({"fos", path("scene.json"), "--jobs", "1", "--out", path("out")});
    ASSERT_EQ(outcome.code, 0) << outcome.errors << scene;
    const json report = json::parse(text("out/fos.json"));
    ASSERT_TRUE(report["factor_of_safety"].is_number()) << outcome.out << scene;
    EXPECT_NEAR(report["factor_of_safety"].get<double>() / factor, 1, width) << scene;
  }
};

TEST_F(FosPopulation, IsLimitEquilibriumOfWhatActsInTheEnd) {
  int fit = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const BlockOnAPlane block(seed);
    if (!block.is_fit()) continue;
    ++fit;
    ASSERT_NO_FATAL_FAILURE(expect_factor(block.factor(), block.text()));
  }
  EXPECT_GE(fit, 20);
}

// A wedge on a plane that comes out at the toe of a slope, with a tension crack behind it. Water stands in the crack
// and runs out at the toe: its pressure on the plane falls in a straight line. (Hoek & Bray 1981, plane failure.)
struct WetWedge {
  explicit WetWedge(std::uint64_t seed) {
    SeededNumbers random(seed);
    const double face = random.number(55, 80) * degree;
    plane = random.number(25, face / degree - 20) * degree;
    height = random.magnitude(0.5, 1.8);
    friction = random.number(20, 40) * degree;
    const double crest = height / std::tan(face);
    crack.x() = crest + random.number(0.1, 0.8) * (height / std::tan(plane) - crest);
    crack.y() = crack.x() * std::tan(plane);
    water = random.number(0, 0.8) * (height - crack.y());
    corners = {{0, 0}, crack, {crack.x(), height}, {crest, height}};
  }

  [[nodiscard]] double factor() const {
    const double weight = density * standard_gravity * shape().area;
    const double uplift = water_weight * water * crack.norm() / 2, push = water_weight * water * water / 2;
    const double pressed = weight * std::cos(plane) - uplift - push * std::sin(plane);
    return (cohesion * crack.norm() + pressed * std::tan(friction)) /
           (weight * std::sin(plane) + push * std::cos(plane));
  }

  // The weight acts in the middle third of the plane, which is then closed all along where there is no water.
  [[nodiscard]] bool is_closed_when_dry() const {
    const double place = shape().centroid.x() / crack.x();
    return place > 1.0 / 3 && place < 2.0 / 3;
  }

  [[nodiscard]] AreaMoments shape() const { return area_moments(Polygon{corners, {}}); }

  [[nodiscard]] std::string text() const {
    json wedge = json::array();
    for (const Vec2& corner : corners) wedge.push_back(pair_of(corner));
    const double h = height, x = crack.x();
    const json base = {{0, 0}, {0, -h}, {x + h, -h}, {x + h, h}, {x, h}, pair_of(crack)};
    const json table = {{0, 0}, {x, crack.y() + water}};
    json scene = {
        {"dda", 1},
        {"gravity", standard_gravity},
        {"fixed", {"base"}},
        {"materials", {{"rock", {{"density", density}, {"young", 5e9}, {"poisson", 0.25}}}}},
        {"joints",
         {{"default", {{"friction_angle", friction}, {"cohesion", cohesion}}}, {"crack", {{"friction_angle", 0}}}}},
        {"joint_lines", {{{"joint", "crack"}, {"points", {pair_of(crack), {x, h}}}}}},
        {"blocks",
         {{{"polygon", {{"name", "wedge"}, {"vertices", wedge}}}},
          {{"polygon", {{"name", "base"}, {"vertices", base}}}}}},
        {"steps", {{{"integrator", "static"}}}}};
    if (water > 0)
      scene["loads"] = {{{"edge", "joints"}, {"pressure", {{"surface", table}, {"gradient", water_weight}}}}};
    return scene.dump();
  }

  static constexpr double density = 2600, water_weight = 9810;  // kg/m3, N/m3
  double plane = 0, friction = 0, height = 0, water = 0;        // rad, m; water in the crack
  double cohesion = 0;                                          // Pa, of the plane; it goes when that slides
  Vec2 crack = Vec2::Zero();                                    // its foot
  std::vector<Vec2> corners;
};

TEST_F(FosPopulation, IsThatOfHoekAndBrayWithWaterInTheTensionCrack) {
  int fit = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const WetWedge wedge(seed);
    if (wedge.factor() < 0.1) continue;  // all but afloat
    ++fit;
    ASSERT_NO_FATAL_FAILURE(expect_factor(wedge.factor(), wedge.text()));
  }
  EXPECT_GE(fit, 20);
}

// As it swells sideways under its weight the wedge pushes off the wall of the crack, so that its plane is sheared by
// more than its weight asks for, and a brittle one goes before limit equilibrium. What that costs is told.
TEST_F(FosPopulation, TellsTheFactorOfHoekAndBrayWhereAPlaneLosesItsCohesionBefore) {
  int fit = 0, lost = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    WetWedge wedge(seed);
    if (!wedge.is_closed_when_dry()) continue;
    ++fit;
    wedge.water = 0;
    wedge.cohesion = SeededNumbers(seed + 1000).number(0.02, 0.5) * WetWedge::density * standard_gravity * wedge.height;
    write("scene.json", wedge.text());
    const Outcome outcome = call({"fos", path("scene.json"), "--jobs", "1", "--out", path("out")});
    ASSERT_EQ(outcome.code, 0) << outcome.errors << wedge.text();
    const json report = json::parse(text("out/fos.json"));
    const bool is_lost = report["strength_kept"].is_object();
    EXPECT_EQ(contains(outcome.out, "joints that keep cohesion and friction as they slide have"), is_lost);
    const json factor = is_lost ? report["strength_kept"]["factor_of_safety"] : report["factor_of_safety"];
    ASSERT_TRUE(factor.is_number()) << report << wedge.text();
    EXPECT_NEAR(factor.get<double>() / wedge.factor(), 1, 2 * width) << wedge.text();
    if (!is_lost) continue;
    ++lost;
    EXPECT_LT(report["factor_of_safety"].get<double>(), wedge.factor() * (1 - width / 2)) << wedge.text();
  }
  EXPECT_GE(fit, 20);
  EXPECT_GE(lost, 3);
}

}  // namespace
}  // namespace dda
