#include "engine/simulation/kinematic_update.h"

#include <cmath>
#include <cstddef>

#include "engine/geometry/rotation.h"
#include "engine/linear/block_vectors.h"
#include "engine/terms/centrifugal.h"
#include "engine/terms/inertia.h"

namespace dda {
namespace {

void advance_motion(const StepCoefficients& step, const Vec6& d, std::size_t i, State& state) {
  const Vec6 old_acceleration = state.acceleration[i];
  const Vec6 acceleration = step.a_d * d + step.a_v * state.velocity[i] + step.a_a * old_acceleration;
  state.velocity[i] = step.v_v * state.velocity[i] + step.v_a0 * old_acceleration + step.v_a1 * acceleration;
  state.acceleration[i] = acceleration;
  state.displacement[i] += d;
}

// Areas and inertia follow strains in steps of this size. Were they measured anew at every step, it would be with the
// strains of its start, and blocks that vibrate under stress would gain energy from the delay; so they do where a
// vibration is large enough to go through such a step each time (ADR 30).
constexpr double shape_tolerance = 0.05;

void deform_block(Kinematics kinematics, const Eigen::VectorXd& d, std::size_t i, const BlockTerms& terms,
                  State& state) {
  const Vec6 own = d.segment<6>(static_cast<Eigen::Index>(6 * i));
  if (kinematics == Kinematics::small) {
    deform_small(own, state.deformation[i]);
  } else {
    const double before = terms.directions[i] - (state.displacement[i](2) - own(2));
    state.deformation[i] = deformation_increment(own, before) * state.deformation[i];
  }
}

double trace(const Vec3& squares) { return squares(0) + squares(1); }

// The length of the tensor, whichever way the block lies.
double length(const Vec3& squares) { return std::sqrt(squares.squaredNorm() + squares(2) * squares(2)); }

bool shape_has_changed(double area, const Vec3& squares, double old_area, const Vec3& old_squares) {
  return std::abs(area - old_area) > shape_tolerance * old_area ||
         length(squares - old_squares) > shape_tolerance * trace(old_squares);
}

// Into the directions that the block has when it has turned by `to` (rad).
void turn_strains(double to, std::size_t i, State& state, BlockTerms& terms) {
  const double angle = to - terms.directions[i];
  if (angle == 0) return;
  terms.directions[i] = to;
  terms.inertia[i].squares = rotate_stress(terms.inertia[i].squares, angle);
  state.stress[i] = rotate_stress(state.stress[i], angle);
  for (Vec6* rates : {&state.velocity[i], &state.acceleration[i]})
    rates->tail<3>() = rotate_strain(rates->tail<3>(), angle);
}

// The rate of rotation that has this angular momentum, at these rates of the strains.
void keep_angular_momentum(double wanted, const Inertia& inertia, Vec6& rates) {
  rates(2) += (wanted - momentum(inertia, rates)(2)) / (inertia.mass * inertia.polar());
}

// Changes the inertia of a block and leaves it its angular momentum, and what its acceleration makes of that.
// `squares` may be the block's own.
void change_inertia(std::size_t i, const Vec3& squares, double beyond, Inertia& inertia, State& state) {
  const bool held = inertia.mass == 0;
  const double of_velocity = momentum(inertia, state.velocity[i])(2);
  const double of_acceleration = momentum(inertia, state.acceleration[i])(2);
  inertia.squares = squares;
  inertia.beyond = beyond;
  if (held) return;
  keep_angular_momentum(of_velocity, inertia, state.velocity[i]);
  keep_angular_momentum(of_acceleration, inertia, state.acceleration[i]);
}

// Takes the block as drawn, at the spin at which it would then have its angular momentum: see README.md.
Vec3 centrifugal_force_on(const Model& model, std::size_t i, const BlockTerms& terms, const Vec6& velocity) {
  const Inertia& inertia = terms.inertia[i];
  const Vec3 drawn = mean_squares(model.blocks[i].moments);
  const double spin = momentum(inertia, velocity)(2) / (inertia.mass * trace(drawn));
  return centrifugal_force(inertia.mass, rotate_stress(drawn, terms.directions[i]), spin);
}

}  // namespace

void advance_blocks(const StepCoefficients& step, const BlockTerms& terms, const Eigen::VectorXd& d, State& state) {
  parallel_for_each(state.velocity.size(), blocks_worth_sharing, [&](std::size_t i) {
    const Vec6 own = d.segment<6>(static_cast<Eigen::Index>(6 * i));
    advance_motion(step, own, i, state);
    state.stress[i].noalias() += terms.elasticity[i] * own.tail<3>();
  });
}

void deform_blocks(Kinematics kinematics, const Eigen::VectorXd& d, const BlockTerms& terms, State& state) {
  parallel_for_each(state.velocity.size(), blocks_worth_sharing,
                    [&](std::size_t i) { deform_block(kinematics, d, i, terms, state); });
}

void keep_angular_momenta(const Model& model, State& state, BlockTerms& terms) {
  for (std::size_t i = 0; i < state.velocity.size(); ++i) {
    Inertia& inertia = terms.inertia[i];
    if (inertia.mass == 0) continue;  // held
    const double beyond = trace(deformed_squares(model, state, i)) - trace(inertia.squares);
    change_inertia(i, inertia.squares, beyond, inertia, state);
  }
}

void foresee(const State& state, double dt, double share, double most_turn, State& acting) {
  for (std::size_t i = 0; i < state.velocity.size(); ++i) {
    acting.velocity[i].setZero();
    if (std::abs(dt * state.velocity[i](2)) <= most_turn) acting.velocity[i].head<3>() = state.velocity[i].head<3>();
    const Vec3 motion = share * dt * acting.velocity[i].head<3>();
    acting.displacement[i] = state.displacement[i];
    acting.displacement[i].head<3>() += motion;
    acting.deformation[i] = rotation(motion(2)) * state.deformation[i];
  }
}

void follow_blocks(const Model& model, const State& acting, bool measure, State& state, BlockTerms& terms) {
  for (std::size_t i = 0; i < terms.inertia.size(); ++i) {
    turn_strains(acting.displacement[i](2), i, state, terms);
    Inertia& inertia = terms.inertia[i];
    const double area = deformed_area(model, acting, i);
    const Vec3 squares = deformed_squares(model, acting, i);
    if (measure || shape_has_changed(area, squares, terms.area[i], inertia.squares)) {
      terms.area[i] = area;
      const double beyond = inertia.beyond + trace(inertia.squares) - trace(squares);
      change_inertia(i, squares, beyond, inertia, state);
    }
  }
}

void turn_strains_home(State& state, BlockTerms& terms) {
  for (std::size_t i = 0; i < terms.inertia.size(); ++i) turn_strains(state.displacement[i](2), i, state, terms);
}

void set_centrifugal_forces(const Model& model, const State& state, BlockTerms& terms) {
  for (std::size_t i = 0; i < terms.inertia.size(); ++i)
    if (terms.inertia[i].mass > 0)  // not held
      terms.centrifugal[i] = centrifugal_force_on(model, i, terms, state.velocity[i]);
}

void add_centrifugal_forces(const BlockTerms& terms, Eigen::VectorXd& force) {
  for (std::size_t i = 0; i < terms.centrifugal.size(); ++i)
    force.segment<3>(static_cast<Eigen::Index>(6 * i + 3)) += terms.centrifugal[i];
}

double centrifugal_work(const BlockTerms& terms, const Eigen::VectorXd& d) {
  double work = 0;
  for (std::size_t i = 0; i < terms.centrifugal.size(); ++i)
    work += d.segment<3>(static_cast<Eigen::Index>(6 * i + 3)).dot(terms.centrifugal[i]);
  return work;
}

}  // namespace dda
