// Blocks that weight alone brings to rest, on bolts and on the tip of another block, against statics by hand.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/simulation/random_test_support.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr double gravity = 10;  // m/s2

constexpr double rigid = 1e13;  // Pa: strains of the block change its forces by a share of 1e-5 at most

// --- A block below a held roof on bolts that stand upright ---

struct Hung {
  double width, height;   // m
  double roof;            // m, half of its length: the scene is as long
  double anchors, above;  // m, in the block above its centroid, and in the roof above these
  std::vector<double> x, stiffness;

  [[nodiscard]] double weight() const { return rock().density * width * height * gravity; }
};

Hung random_hung(Random& random, int bolts) {
  Hung hung;
  hung.width = between(1, 3, random);
  hung.height = between(0.6, 2, random);
  hung.roof = between(0, 1, random) < 0.5 ? 4 : 100;
  hung.anchors = between(0.2, 0.45, random) * hung.height;
  hung.above = between(0.6, 2, random) + hung.height / 2;
  for (int i = 0; i < bolts; ++i) {
    const double place = -0.4 + 0.8 * i / (bolts - 1) + between(-0.05, 0.05, random);
    hung.x.push_back(place * hung.width);
    hung.stiffness.push_back(std::pow(10, between(7, 8, random)));
  }
  return hung;
}

Model model_of(const Hung& hung, Kinematics kinematics) {
  Model model;
  model.materials = {rock_of(rigid)};
  const double roof = hung.anchors + hung.above;
  model.blocks = {rectangle("roof", -hung.roof, roof - 0.05, 2 * hung.roof, 1),
                  rectangle("block", -hung.width / 2, -hung.height / 2, hung.width, hung.height)};
  model.held_blocks = {HeldBlock{}};
  model.gravity = {0, -gravity};
  for (std::size_t i = 0; i < hung.x.size(); ++i) {
    Bolt bolt;
    bolt.name = "bolt " + std::to_string(i);
    bolt.direction = -Vec2::UnitY();
    bolt.links = {{0, 1, {hung.x[i], roof}, {hung.x[i], hung.anchors}, hung.stiffness[i], 0}};
    model.bolts.push_back(bolt);
  }
  model.stages = {settling_stage(1e-9)};
  model.stages[0].kinematics = kinematics;
  return model;
}

// The rigid block's gradient and second derivatives of energy by (x, y, turn), and the forces of the bolts, where it
// has moved by q.
struct Statics {
  Vec3 gradient;
  Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
  std::vector<double> forces;
};

Statics statics_at(const Hung& hung, const Vec3& q) {
  Statics statics{{0, hung.weight(), 0}, Eigen::Matrix3d::Zero(), {}};
  for (std::size_t i = 0; i < hung.x.size(); ++i) {
    const double c = std::cos(q(2)), s = std::sin(q(2));
    const Vec2 arm(c * hung.x[i] - s * hung.anchors, s * hung.x[i] + c * hung.anchors);
    const Vec2 span = Vec2(q(0), q(1)) + arm - Vec2(hung.x[i], hung.anchors + hung.above);
    const Vec2 along = span.normalized(), across(-along.y(), along.x());
    const double force = hung.stiffness[i] * (span.norm() - hung.above);
    const Vec2 turning(-arm.y(), arm.x());
    const Vec3 lengthens(along.x(), along.y(), along.dot(turning)), swings(across.x(), across.y(), across.dot(turning));
    statics.gradient += force * lengthens;
    statics.stiffness += hung.stiffness[i] * lengthens * lengthens.transpose();
    statics.stiffness += force / span.norm() * swings * swings.transpose();
    statics.stiffness(2, 2) -= force * along.dot(arm);
    statics.forces.push_back(force);
  }
  return statics;
}

// Upright bolts have no answer to x to first order.
std::vector<double> forces_of_small_motion(const Hung& hung) {
  const Statics drawn = statics_at(hung, Vec3::Zero());
  const Vec2 q = drawn.stiffness.bottomRightCorner<2, 2>().ldlt().solve(-drawn.gradient.tail<2>());
  std::vector<double> forces;
  for (std::size_t i = 0; i < hung.x.size(); ++i) forces.push_back(-hung.stiffness[i] * (q(0) + hung.x[i] * q(1)));
  return forces;
}

std::vector<double> forces_of_finite_motion(const Hung& hung) {
  const Statics drawn = statics_at(hung, Vec3::Zero());
  Vec3 q = Vec3::Zero();
  q.tail<2>() = drawn.stiffness.bottomRightCorner<2, 2>().ldlt().solve(-drawn.gradient.tail<2>());
  for (int round = 0; round < 20; ++round) {
    const Statics now = statics_at(hung, q);
    q -= now.stiffness.ldlt().solve(now.gradient);
  }
  return statics_at(hung, q).forces;
}

// Some of them go slack; those are left out.
bool all_pull(const Hung& hung) {
  const std::vector<double> forces = forces_of_finite_motion(hung);
  return *std::ranges::min_element(forces) > 0.05 * hung.weight();
}

void expect_forces(const Hung& hung, Kinematics kinematics, const std::vector<double>& by_hand, double tolerance) {
  Simulation simulation = simulation_of(model_of(hung, kinematics));
  while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
  for (std::size_t i = 0; i < by_hand.size(); ++i)
    EXPECT_NEAR(simulation.bolts().state(static_cast<int>(i), 0).force(0), by_hand[i], tolerance * hung.weight());
  EXPECT_LT(simulation.state().step, 150);  // of 500; measured: 106
  EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-10);
}

TEST(HangingBlocks, HaveTheForcesByHandOnUnequalBolts) {
  Random random(1);
  int hung_blocks = 0;
  while (hung_blocks < 24) {
    const Hung hung = random_hung(random, 2 + hung_blocks % 2);
    if (!all_pull(hung)) continue;
    SCOPED_TRACE("block " + std::to_string(++hung_blocks));
    expect_forces(hung, Kinematics::finite, forces_of_finite_motion(hung), 2e-5);
    expect_forces(hung, Kinematics::small, forces_of_small_motion(hung), 2e-5);
  }
}

// --- A block whose notch sits on the tip of a held one: it turns until its centroid is below the tip ---

// `far`: of another held block, m. Steps are longer in a larger scene.
Model block_on_a_tip(Random& random, double far) {
  const double half = between(1, 3, random), depth = between(0.5, 2, random), height = between(0.4, 1, random);
  const double right = half * (1 + between(-0.05, 0.05, random));
  Model model;
  model.materials = {rock()};
  model.joints = {JointMaterial{}};
  model.blocks.resize(2);
  model.blocks[0].shape.outer = {{-0.2, -2}, {0.2, -2}, {0, 0}};
  model.blocks[1].shape.outer = {
      {-half, -depth}, {-0.6 * half, -depth}, {0, 0}, {right - 0.4 * half, -depth}, {right, -depth}, {0, height}};
  model.blocks.push_back(rectangle("far", far, -2, 1, 1));
  model.held_blocks = {HeldBlock{}, HeldBlock{}};
  model.held_blocks[1].block = 2;
  model.gravity = {0, -gravity};
  model.stages = {settling_stage(1e-9)};
  return model;
}

TEST(HangingBlocks, ComeToRestBelowTheTipTheyHangOn) {
  Random random(2);
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE("block " + std::to_string(i));
    Simulation simulation = simulation_of(block_on_a_tip(random, i % 2 == 0 ? 4 : 200));
    while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
    const Vec2 centroid = current_centroid(simulation.model(), simulation.state(), 1);
    const Vec2 notch = current_position(simulation.model(), simulation.state(), 1, {0, 0});
    EXPECT_LT(centroid.y(), notch.y());
    EXPECT_NEAR(centroid.x(), notch.x(), 1e-5);
    EXPECT_GT(std::abs(simulation.state().displacement[1](2)), 1e-4) << "it was drawn at rest";
  }
}

}  // namespace
}  // namespace dda
