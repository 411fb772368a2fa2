#include "dda/simulation/kinematic_update.h"

#include <gtest/gtest.h>

#include "dda/geometry/rotation.h"
#include "dda/simulation/simulation_models.h"

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
  advance_blocks(step_coefficients(trapezoidal_integrator(), 0.1), make_block_terms(model), d, moved.state);
  deform_blocks(kinematics, d, moved.state);
  std::vector<double> turned{0};
  if (kinematics == Kinematics::finite) turn_stresses(moved.state, turned);
  return moved;
}

TEST(MoveBlocks, FiniteKinematicsTurnStressAndShape) {
  Vec6 d;
  d << 0.1, -0.2, 0.7, 0.01, -0.02, 0.03;
  const auto [state, elasticity] = move(Kinematics::finite, d);
  const Vec3 stress = Vec3(1, -2, 0.5) + elasticity * d.tail<3>();
  const Mat2 tensor = (Mat2() << stress(0), stress(2), stress(2), stress(1)).finished();
  const Mat2 turned = rotation(0.7) * tensor * rotation(-0.7);
  EXPECT_LT((state.stress[0] - Vec3(turned(0, 0), turned(1, 1), turned(0, 1))).norm(), round_off);
  const Mat2 before = (Mat2() << 1.1, 0.2, -0.1, 0.9).finished();
  const Mat2 stretch = (Mat2() << 1.01, 0.015, 0.015, 0.98).finished();
  EXPECT_LT((state.deformation[0] - rotation(0.7) * stretch * before).norm(), round_off);
  EXPECT_LT((state.displacement[0] - d).norm(), round_off);
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
