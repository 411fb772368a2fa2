#include "engine/simulation/kinematic_update.h"

#include <cstddef>

#include "engine/geometry/rotation.h"

namespace dda {
namespace {

void advance_motion(const StepCoefficients& step, const Vec6& d, std::size_t i, State& state) {
  const Vec6 old_acceleration = state.acceleration[i];
  const Vec6 acceleration = step.a_d * d + step.a_v * state.velocity[i] + step.a_a * old_acceleration;
  state.velocity[i] = step.v_v * state.velocity[i] + step.v_a0 * old_acceleration + step.v_a1 * acceleration;
  state.acceleration[i] = acceleration;
  state.displacement[i] += d;
}

void deform_small(const Vec6& d, Mat2& deformation) {
  deformation(0, 0) += d(3);
  deformation(0, 1) += d(5) / 2 - d(2);
  deformation(1, 0) += d(5) / 2 + d(2);
  deformation(1, 1) += d(4);
}

}  // namespace

void advance_blocks(const StepCoefficients& step, const BlockTerms& terms, const Eigen::VectorXd& d, State& state) {
  for (std::size_t i = 0; i < state.velocity.size(); ++i) {
    const Vec6 own = d.segment<6>(static_cast<Eigen::Index>(6 * i));
    advance_motion(step, own, i, state);
    state.stress[i].noalias() += terms.elasticity[i] * own.tail<3>();
  }
}

void deform_blocks(Kinematics kinematics, const Eigen::VectorXd& d, State& state) {
  for (std::size_t i = 0; i < state.velocity.size(); ++i) {
    const Vec6 own = d.segment<6>(static_cast<Eigen::Index>(6 * i));
    if (kinematics == Kinematics::small) {
      deform_small(own, state.deformation[i]);
    } else {
      state.deformation[i] = deformation_increment(own) * state.deformation[i];
    }
  }
}

void turn_stresses(const BlockTerms& terms, State& state, std::vector<Vec4>& turned) {
  for (std::size_t i = 0; i < turned.size(); ++i) {
    const Vec4 since = state.displacement[i].tail<4>() - turned[i];
    turned[i] = state.displacement[i].tail<4>();
    if (since(0) == 0) continue;
    const Vec3 added = terms.elasticity[i] * since.tail<3>();
    state.stress[i] = rotate_stress(state.stress[i] - added, since(0)) + rotate_stress(added, since(0) / 2);
  }
}

}  // namespace dda
