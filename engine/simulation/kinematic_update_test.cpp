#include "engine/simulation/kinematic_update.h"

#include <gtest/gtest.h>

#include "engine/geometry/rotation.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr double round_off = 1e-14;

struct Moved {
  State state;
  Mat3 elasticity;
};

// One step of a stressed, deformed block.
Moved move(Kinematics kinematics, const Vec6& d) {
  Model model = model_of({{box_ring(0, 0, 2, 1), {}}}, {"rock", 1, 3, 0.25, PlaneState::stress});
  model.blocks[0].initial_stress = {1, -2, 0.5};
  model.blocks[0].initial_velocity = {0.3, 0};
  Moved moved{initial_state(model), elasticity_matrix(model.materials[0])};
  moved.state.deformation[0] << 1.1, 0.2, -0.1, 0.9;
  const BlockTerms terms = make_block_terms(model);
  advance_blocks(step_coefficients(trapezoidal_integrator(), 0.1), terms, d, moved.state);
  deform_blocks(kinematics, d, moved.state);
  std::vector<Vec4> turned{Vec4::Zero()};
  if (kinematics == Kinematics::finite) turn_stresses(terms, moved.state, turned);
  return moved;
}

TEST(MoveBlocks, FiniteKinematicsTurnStressAndShape) {
  Vec6 d;
  d << 0.1, -0.2, 0.7, 0.01, -0.02, 0.03;
  const auto [state, elasticity] = move(Kinematics::finite, d);
  // What was there turns with the block, what the step adds comes halfway.
  const Vec3 turned = rotate_stress({1, -2, 0.5}, 0.7) + rotate_stress(elasticity * d.tail<3>(), 0.35);
  EXPECT_LT((state.stress[0] - turned).norm(), round_off);
  const Mat2 before = (Mat2() << 1.1, 0.2, -0.1, 0.9).finished();
  EXPECT_LT((state.deformation[0] - deformation_increment(d) * before).norm(), round_off);
  EXPECT_LT((state.displacement[0] - d).norm(), round_off);
}

// A block turned and strained there and back by `steps` steps each way, in stresses that follow every `each` of them:
// the largest stress left over.
double left_over(int steps, int each) {
  Model model = model_of({{box_ring(0, 0, 2, 1), {}}}, {"rock", 1, 3, 0.25, PlaneState::stress});
  State state = initial_state(model);
  const BlockTerms terms = make_block_terms(model);
  std::vector<Vec4> turned{Vec4::Zero()};
  Vec6 d = Vec6::Zero();
  d.tail<4>() = Vec4(-0.1, 0.02, -0.01, 0.2) / steps;
  for (int i = 0; i < 2 * steps; ++i) {
    advance_blocks(step_coefficients(trapezoidal_integrator(), 0.1), terms, i < steps ? d : -d, state);
    if (i % each == each - 1) turn_stresses(terms, state, turned);
  }
  EXPECT_LT((state.displacement[0]).norm(), round_off);
  return state.stress[0].cwiseAbs().maxCoeff();
}

// Stress that came with a strain goes with it, though the block turned all along.
TEST(MoveBlocks, StressesOfAClosedPathVanish) {
  EXPECT_LT(left_over(50, 1), round_off);
  EXPECT_LT(left_over(50, 10), round_off);
  EXPECT_LT(left_over(1, 1), round_off);
}

// Strains that came before the block turns turn with it by all of it: each step's stress by half of that step's turn.
TEST(MoveBlocks, StressesFollowStrainsOfStepsWithoutTurn) {
  Model model = model_of({{box_ring(0, 0, 2, 1), {}}}, {"rock", 1, 3, 0.25, PlaneState::stress});
  State state = initial_state(model);
  const BlockTerms terms = make_block_terms(model);
  std::vector<Vec4> turned{Vec4::Zero()};
  Vec6 strain = Vec6::Zero(), turn = Vec6::Zero();
  strain(3) = 0.01;
  turn(2) = 0.3;
  const Vec3 expected = rotate_stress(terms.elasticity[0] * strain.tail<3>(), 0.3);
  for (const Vec6& d : {strain, turn}) {
    advance_blocks(step_coefficients(trapezoidal_integrator(), 0.1), terms, d, state);
    turn_stresses(terms, state, turned);
  }
  EXPECT_LT((state.stress[0] - expected).norm(), round_off);
}

TEST(MoveBlocks, SmallKinematicsAdd) {
  Vec6 d;
  d << 0.1, -0.2, 0.7, 0.01, -0.02, 0.03;
  const auto [state, elasticity] = move(Kinematics::small, d);
  EXPECT_LT((state.stress[0] - (Vec3(1, -2, 0.5) + elasticity * d.tail<3>())).norm(), round_off);
  const Mat2 expected = (Mat2() << 1.11, 0.2 - 0.7 + 0.015, -0.1 + 0.7 + 0.015, 0.88).finished();
  EXPECT_LT((state.deformation[0] - expected).norm(), round_off);
}

TEST(MoveBlocks, VelocityAndAccelerationAreTheIntegrators) {
  Vec6 d = Vec6::Zero();
  d(0) = 0.05;
  const auto [state, elasticity] = move(Kinematics::small, d);
  // Trapezoidal rule from a0 = 0: d = dt (v0 + v1)/2, v1 = v0 + dt a1/2.
  EXPECT_NEAR(state.velocity[0](0), 2 * 0.05 / 0.1 - 0.3, round_off);
  EXPECT_NEAR(state.acceleration[0](0), (0.7 - 0.3) * 2 / 0.1, 100 * round_off);
}

}  // namespace
}  // namespace dda
