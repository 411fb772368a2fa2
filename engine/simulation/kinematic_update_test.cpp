#include "engine/simulation/kinematic_update.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <random>
#include <utility>

#include "engine/geometry/rotation.h"
#include "engine/simulation/simulation_models.h"
#include "engine/terms/inertia.h"

namespace dda {
namespace {

constexpr double round_off = 1e-14;

struct Moved {
  State state;
  Mat3 elasticity;
};

Model stressed_box() {
  Model model = model_of({{box_ring(0, 0, 2, 1), {}}}, {"rock", 1, 3, 0.25, PlaneState::stress});
  model.blocks[0].initial_stress = {1, -2, 0.5};
  model.blocks[0].initial_velocity = {0.3, 0};
  return model;
}

// A block and the directions in which its strains are measured.
struct Moving {
  explicit Moving(Model with) : model(std::move(with)), state(initial_state(model)), terms(make_block_terms(model)) {}

  // A step whose forces act where the block has turned by `ahead` (rad).
  void step(const Vec6& d, double ahead, Kinematics kinematics = Kinematics::finite) {
    State acting = state;
    acting.displacement[0](2) += ahead;
    acting.deformation[0] = rotation(ahead) * state.deformation[0];
    if (kinematics == Kinematics::finite) follow_blocks(model, acting, true, state, terms);
    advance_blocks(step_coefficients(trapezoidal_integrator(), 0.1), terms, d, state);
    deform_blocks(kinematics, d, terms, state);
  }

  // Stress (Pa) in the directions that the block has now.
  [[nodiscard]] Vec3 stress_now() const {
    return rotate_stress(state.stress[0], state.displacement[0](2) - terms.directions[0]);
  }

  Model model;
  State state;
  BlockTerms terms;
};

TEST(MoveBlocks, FiniteKinematicsTurnStressAndShape) {
  Vec6 d;
  d << 0.1, -0.2, 0.7, 0.01, -0.02, 0.03;
  for (const double ahead : {0.0, 0.35, 0.7}) {
    Moving block(stressed_box());
    block.state.deformation[0] << 1.1, 0.2, -0.1, 0.9;
    const Mat2 before = block.state.deformation[0];
    block.step(d, ahead);
    const Vec3 strain = block.terms.elasticity[0] * d.tail<3>();
    // What was there turns with the block by all of its rotation, what the step adds by what is left of it.
    const Vec3 turned = rotate_stress({1, -2, 0.5}, 0.7) + rotate_stress(strain, 0.7 - ahead);
    EXPECT_LT((block.stress_now() - turned).norm(), round_off);
    EXPECT_LT((block.state.deformation[0] - deformation_increment(d, ahead) * before).norm(), round_off);
    EXPECT_LT((block.state.displacement[0] - d).norm(), round_off);
  }
}

// Strains of steps in the block's own directions: the stress and the shape depend on their sum alone, wherever in a
// step forces act and however seldom the geometry is followed.
TEST(MoveBlocks, StressAndShapeAreThoseOfTheStrainsInTheBlock) {
  constexpr double turn = 0.01;
  const Vec3 strain(0.002, -0.001, 0.003);
  for (const double share : {0.0, 0.5, 1.0}) {
    for (const int every : {1, 5}) {
      Moving block(stressed_box());
      block.model.blocks[0].initial_stress.setZero();
      block.state.stress[0].setZero();
      for (int i = 0; i < 20; ++i) {
        if (i % every == 0) {
          State acting = block.state;
          acting.displacement[0](2) += share * turn;
          follow_blocks(block.model, acting, false, block.state, block.terms);
        }
        Vec6 d = Vec6::Zero();
        d(2) = turn;
        d.tail<3>() = rotate_strain(i < 10 ? strain : Vec3(-strain), block.terms.directions[0]);
        advance_blocks(step_coefficients(trapezoidal_integrator(), 0.1), block.terms, d, block.state);
        deform_blocks(Kinematics::finite, d, block.terms, block.state);
      }
      EXPECT_LT(block.state.stress[0].norm(), round_off);
      // (1 + E + E^2/2)(1 - E + E^2/2) = 1 + E^4/4, ten times
      EXPECT_LT((block.state.deformation[0] - rotation(20 * turn)).norm(), 10 * std::pow(strain.norm(), 4));
    }
  }
}

// Rates of strains are tensors of the block as stresses are.
TEST(MoveBlocks, RatesOfStrainsTurnWithTheBlock) {
  Moving block(stressed_box());
  const Vec3 rate(0.1, -0.2, 0.4);
  block.state.velocity[0].tail<3>() = rate;
  block.state.acceleration[0].tail<3>() = 2 * rate;
  State acting = block.state;
  acting.displacement[0](2) = 0.3;
  follow_blocks(block.model, acting, false, block.state, block.terms);
  EXPECT_LT((block.state.velocity[0].tail<3>() - rotate_strain(rate, 0.3)).norm(), round_off);
  EXPECT_LT((block.state.acceleration[0].tail<3>() - 2 * rotate_strain(rate, 0.3)).norm(), round_off);
}

// A skater who stretches the arms: twice the length is a slower spin with the same angular momentum.
TEST(MoveBlocks, SpinKeepsTheAngularMomentum) {
  Moving block(stressed_box());
  block.state.velocity[0] << 0, 0, 3, 0.1, -0.2, 0.4;
  const double before = momentum(block.terms.inertia[0], block.state.velocity[0])(2);
  block.state.deformation[0] << 2, 0.1, 0, 1;
  keep_angular_momenta(block.model, block.state, block.terms);
  const Inertia& inertia = block.terms.inertia[0];
  const Vec3 squares = deformed_squares(block.model, block.state, 0);
  EXPECT_NEAR(inertia.polar(), squares(0) + squares(1), round_off);
  EXPECT_NEAR(momentum(inertia, block.state.velocity[0])(2), before, 10 * round_off);
  EXPECT_LT(block.state.velocity[0](2), 1.5);
}

// Blocks of any shape, squeezed by up to 5 % since their inertia was measured: all of their motion has inertia. (Of a
// needle a hundred times as long as wide, whose rotation and shear are the same but for 1 part in 2500, it had none.)
TEST(MoveBlocks, InertiaStaysPositive) {
  std::mt19937 random(5);
  const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  for (int scene = 0; scene < 300; ++scene) {
    const double aspect = std::pow(10, number(0, 4));
    Ring ring = box_ring(0, 0, aspect, 1);
    const Mat2 turn = rotation(number(-3, 3));
    for (Vec2& vertex : ring) vertex = turn * vertex;
    Moving block(model_of({{ring, {}}}, {"rock", 1, 3, 0.25, PlaneState::stress}));
    block.state.velocity[0] << 0, 0, number(-3, 3), number(-1, 1), number(-1, 1), number(-1, 1);
    block.state.deformation[0] << 1 + number(-0.02, 0.02), number(-0.02, 0.02), number(-0.02, 0.02),
        1 + number(-0.02, 0.02);
    const double before = momentum(block.terms.inertia[0], block.state.velocity[0])(2);
    keep_angular_momenta(block.model, block.state, block.terms);
    const Eigen::LLT<Mat6> factor(mass_matrix(block.terms.inertia[0]));
    EXPECT_EQ(factor.info(), Eigen::Success) << "scene " << scene << ", aspect " << aspect;
    const Inertia& inertia = block.terms.inertia[0];
    EXPECT_NEAR(momentum(inertia, block.state.velocity[0])(2), before, 1e-13 * inertia.mass * inertia.polar() * 10);
  }
}

TEST(MoveBlocks, ForeseenAreStraightMotionAndTurn) {
  const Moving block(stressed_box());
  State state = block.state;
  state.velocity[0] << 0.5, -1, 2, 0, 0, 0;
  State acting = state;
  foresee(state, 0.2, 0.5, 0.4, acting);
  EXPECT_LT((acting.displacement[0] - 0.1 * state.velocity[0]).norm(), round_off);
  EXPECT_LT((acting.deformation[0] - rotation(0.2)).norm(), round_off);
  EXPECT_EQ(acting.velocity[0], state.velocity[0]);
  foresee(state, 0.2, 0.5, 0.39, acting);  // turns by more
  EXPECT_TRUE(acting.displacement[0].isZero(0));
  EXPECT_TRUE(acting.velocity[0].isZero(0));
}

TEST(MoveBlocks, SmallKinematicsAdd) {
  Vec6 d;
  d << 0.1, -0.2, 0.7, 0.01, -0.02, 0.03;
  Moving block(stressed_box());
  block.state.deformation[0] << 1.1, 0.2, -0.1, 0.9;
  block.step(d, 0, Kinematics::small);
  const State& state = block.state;
  EXPECT_LT((state.stress[0] - (Vec3(1, -2, 0.5) + block.terms.elasticity[0] * d.tail<3>())).norm(), round_off);
  const Mat2 expected = (Mat2() << 1.11, 0.2 - 0.7 + 0.015, -0.1 + 0.7 + 0.015, 0.88).finished();
  EXPECT_LT((state.deformation[0] - expected).norm(), round_off);
}

TEST(MoveBlocks, VelocityAndAccelerationAreTheIntegrators) {
  Vec6 d = Vec6::Zero();
  d(0) = 0.05;
  Moving block(stressed_box());
  block.step(d, 0, Kinematics::small);
  const State& state = block.state;
  // Trapezoidal rule from a0 = 0: d = dt (v0 + v1)/2, v1 = v0 + dt a1/2.
  EXPECT_NEAR(state.velocity[0](0), 2 * 0.05 / 0.1 - 0.3, round_off);
  EXPECT_NEAR(state.acceleration[0](0), (0.7 - 0.3) * 2 / 0.1, 100 * round_off);
}

}  // namespace
}  // namespace dda
