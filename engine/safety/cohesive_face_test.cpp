// Cohesion acts on the face that a block shares with the ground, whatever vertices the ground has along it and however
// the scene lies in its coordinates.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "engine/safety/factor_of_safety.h"

namespace dda {
namespace {

constexpr double gravity = 9.81;    // m/s2
constexpr double density = 2600;    // kg/m3
constexpr double interval = 0.001;  // of the search

struct Incline {
  Model model;
  double exact = 0;  // (c A + W cos(a) tan(f))/(W sin(a))
};

// A flat block that would slide along -x on a held slope. Vertices lie in the slope's face at random places, and at the
// block's corners; all is turned by a random angle, gravity with it.
Incline random_incline(unsigned seed) {
  std::mt19937 random(seed);
  const auto number = [&random](double from, double to) { return std::uniform_real_distribution(from, to)(random); };
  const double angle = number(0.35, 0.87), length = number(1, 3), height = number(0.2, 0.5) * length;
  JointMaterial joint;
  joint.friction_angle = number(0.17, 0.6);
  joint.cohesion = joint.residual_cohesion = number(3e3, 40e3);
  if (seed % 4 == 3) joint.normal_stiffness = number(1, 20) * 1e9;
  std::vector<double> places(random() % 4);
  for (double& place : places) place = number(-1, length + 1);
  if (number(0, 1) < 0.5) places.push_back(0);
  if (number(0, 1) < 0.3) places.push_back(length);
  std::ranges::sort(places, std::greater());
  const Eigen::Rotation2Dd turn(seed % 3 == 0 ? 0 : number(-3, 3));
  const auto turned = [&turn](Ring ring) {
    for (Vec2& vertex : ring) vertex = turn * vertex;
    return ring;
  };
  Ring ground{{-2, -1.5}, {length + 2, -1.5}, {length + 2, 0}};
  for (const double place : places) ground.emplace_back(place, 0);
  ground.emplace_back(-2, 0);
  Incline incline;
  Model& model = incline.model;
  model.materials = {{"rock", density, 20e9, 0.2, PlaneState::stress}};
  model.joints = {joint};
  model.blocks.resize(2);
  model.blocks[0].shape.outer = turned(ground);
  model.blocks[1].shape.outer = turned({{0, 0}, {length, 0}, {length, height}, {0, height}});
  model.held_blocks.emplace_back().block = 0;
  model.gravity = turn * (-gravity * Vec2(std::sin(angle), std::cos(angle)));
  const double weight = density * gravity * length * height;
  incline.exact = (joint.cohesion * length + weight * std::cos(angle) * std::tan(joint.friction_angle)) /
                  (weight * std::sin(angle));
  return incline;
}

TEST(CohesiveFace, HasTheLengthThatIsShared) {
  for (unsigned seed = 0; seed < 80; ++seed) {
    const Incline incline = random_incline(seed);
    const SafetyReport report = factor_of_safety(incline.model, {.most = 64, .width = interval});
    ASSERT_TRUE(report.is_bracketed()) << "seed " << seed;
    EXPECT_NEAR(report.factor() / incline.exact, 1, interval) << "seed " << seed;
  }
}

}  // namespace
}  // namespace dda
