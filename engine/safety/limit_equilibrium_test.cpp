// Blocks of any size and direction on planes of any slope stand by as much as limit equilibrium says: against the
// weight along the plane acts its friction, and cohesion where a foot that carries no tension is closed.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/safety/factor_of_safety.h"
#include "engine/simulation/lot.h"

namespace dda {
namespace {

constexpr double gravity = 9.81;  // m/s2
constexpr double width = 0.001;   // of the interval that is found, in which the factor is anywhere
constexpr int blocks = 100;

struct BlockOnAPlane {
  double slope = 0, length = 1, height = 1;  // rad, m: of the plane, of the block along it and out of it
  double density = 2500;                     // kg/m3
  double behind = 0;                         // m, from its upper end to a wall of the plane; none where 0
  JointMaterial joint;

  [[nodiscard]] double weight() const { return density * gravity * length * height; }
  [[nodiscard]] double closed_share() const { return std::min(1.0, 1.5 - 1.5 * height * std::tan(slope) / length); }
  [[nodiscard]] double factor() const {
    const double friction = std::tan(joint.friction_angle) * weight() * std::cos(slope);
    return (joint.cohesion * length * closed_share() + friction) / (weight() * std::sin(slope));
  }
};

BlockOnAPlane drawn_block(double slope, double height_of_length, Lot& lot) {
  BlockOnAPlane block;
  block.slope = slope;
  block.length = lot.power(-1, 1.3);
  block.height = block.length * height_of_length;
  block.density = lot.between(1500, 3000);
  block.joint.law = InterfaceLaw::projected;
  block.joint.friction_angle = lot.between(0.1, 0.8);
  return block;
}

void cohere(BlockOnAPlane& block, Lot& lot) {
  block.joint.cohesion = block.weight() / block.length * lot.power(-1.3, 0.5);
  block.joint.residual_cohesion = lot.chance(0.5) ? 0 : block.joint.cohesion * lot.between(0, 1);
}

// On a held plane, all turned or mirrored at random. The rock is so stiff that the block does not lean.
Model model_of(const BlockOnAPlane& block, Lot& lot) {
  const double l = block.length, h = block.height, side = lot.chance(0.5) ? 1 : -1;
  const double stiff = 1e7 * block.density * gravity * std::max(l, h);
  const Mat2 turn = Eigen::Rotation2Dd(lot.between(-3, 3)).toRotationMatrix();
  const auto box = [&](double left, double bottom, double right, double top) {
    return Ring{turn * Vec2(left, bottom), turn * Vec2(right, bottom), turn * Vec2(right, top), turn * Vec2(left, top)};
  };
  Model model;
  model.materials = {{"rock", block.density, stiff, lot.between(0, 0.35), PlaneState::stress}};
  model.joints = {block.joint};
  model.blocks.resize(2);
  model.blocks[0].shape.outer = box(-2 * l, -2 * l, 3 * l, 0);
  if (block.behind > 0) {
    const double wall = side > 0 ? -block.behind : l + block.behind;
    Ring& plane = model.blocks[0].shape.outer;
    if (side > 0)
      plane = {plane[0], plane[1], plane[2], turn * Vec2(wall, 0), turn * Vec2(wall, h), turn * Vec2(-2 * l, h)};
    else
      plane = {plane[0], plane[1], turn * Vec2(3 * l, h), turn * Vec2(wall, h), turn * Vec2(wall, 0), plane[3]};
  }
  model.blocks[1].shape.outer = box(0, 0, l, h);
  model.held_blocks.emplace_back().block = 0;
  model.gravity = gravity * (turn * Vec2(side * std::sin(block.slope), -std::cos(block.slope)));
  return model;
}

template <typename Draw>
void expect_factors_of_limit_equilibrium(const Draw& draw) {
  for (int seed = 0; seed < blocks; ++seed) {
    Lot lot(seed);
    const BlockOnAPlane block = draw(lot);
    const SafetyReport report = factor_of_safety(model_of(block, lot), {.most = 1024, .width = width});
    ASSERT_TRUE(report.is_bracketed()) << "seed " << seed;
    EXPECT_NEAR(report.factor() / block.factor(), 1, 2 * width) << "seed " << seed;
  }
}

// The weight acts so near the edge that 3 to 30 % of the foot is closed.
TEST(LimitEquilibrium, CohesionActsOnWhatIsClosedOfAFootHoweverLittleItIs) {
  expect_factors_of_limit_equilibrium([](Lot& lot) {
    const double slope = lot.between(0.2, 1.1);
    BlockOnAPlane block = drawn_block(slope, (1 - lot.between(0.02, 0.2)) / std::tan(slope), lot);
    cohere(block, lot);
    return block;
  });
}

// The plane rises into a wall behind the block, from which it parts: it could touch there again, but does not.
TEST(LimitEquilibrium, CohesionOfWhatIsClosedIsKeptBeforeAWall) {
  expect_factors_of_limit_equilibrium([](Lot& lot) {
    const double slope = lot.between(0.2, 1.1);
    BlockOnAPlane block = drawn_block(slope, (1 - lot.between(0.02, 0.6)) / std::tan(slope), lot);
    cohere(block, lot);
    block.behind = block.length * lot.power(-4, 0);
    return block;
  });
}

// So little of the weight goes along the plane that what it strains the block by shears the ends of the foot by more.
TEST(LimitEquilibrium, AFootIsNotShearedOffByTheStrainOfItsBlock) {
  expect_factors_of_limit_equilibrium([](Lot& lot) {
    BlockOnAPlane block = drawn_block(lot.between(0.005, 0.1), lot.between(0.2, 3), lot);
    cohere(block, lot);
    return block;
  });
}

// Nor does that take the friction that a dry foot has before it slides.
TEST(LimitEquilibrium, ADryFootKeepsItsPeakFrictionUntilItSlidesAsAWhole) {
  expect_factors_of_limit_equilibrium([](Lot& lot) {
    const double slope = lot.between(0.02, 1);
    BlockOnAPlane block = drawn_block(slope, lot.between(0.05, 0.9) / std::tan(slope), lot);
    block.height = std::min(block.height, 5 * block.length);
    block.joint.residual_friction_angle = block.joint.friction_angle * lot.between(0.2, 0.95);
    return block;
  });
}

}  // namespace
}  // namespace dda
