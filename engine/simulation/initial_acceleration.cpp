#include "engine/simulation/initial_acceleration.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cstddef>

#include "engine/simulation/settling_drag.h"
#include "engine/simulation/step.h"
#include "engine/solve/largest_entry.h"

namespace dda {
namespace {

// Contacts press when their force is more than this share of the largest force out of balance: blocks that just touch
// do not.
constexpr double pressing = 1e-9;

// Motion in a step, in the block's own size, that an acceleration must stand for before it can do harm.
constexpr double harmful = 1e-4;

// Stiffness of a block's contacts times dt^2 over its mass, or of its strains over their inertia, from which on a step
// does not resolve how it lets go.
constexpr double unresolved = 1;

// N per m of thickness.
double largest_of_free_blocks(const Eigen::VectorXd& forces, const BlockSystem& system) {
  double largest = 0;
  for (std::size_t i = 0; i < system.terms.area.size(); ++i)
    if (system.terms.inertia[i].mass > 0) largest = std::max(largest, largest_entry(forces, i, system.terms.area[i]));
  return largest;
}

// What contacts without a bond that press by more than `negligible` (N per m of thickness) hold each block with: where
// they slide, their normal springs alone.
std::vector<Mat6> stiffness_of_pressed_contacts(const std::vector<int>& changing, const BlockSystem& system,
                                                double negligible) {
  std::vector<Mat6> stiffness(system.terms.area.size(), Mat6::Zero());
  for (const int index : changing) {
    const auto i = static_cast<std::size_t>(index);
    const InterfaceElement& element = system.contacts.elements.own()[i];
    const InterfaceState& state = system.contacts.states[i];
    Vec4 held = Vec4::Zero();
    for (std::size_t end = 0; end < 2; ++end) {
      const auto normal = static_cast<Eigen::Index>(2 * end);
      if (!state.broken[end] || state.force(normal) >= -negligible) continue;
      held(normal) = 1;
      if (state.status[end] != ContactStatus::sliding) held(normal + 1) = 1;
    }
    const InterfaceMatrices k = stiffness_of(element, held);
    stiffness[static_cast<std::size_t>(element.block_a)] += k.aa;
    stiffness[static_cast<std::size_t>(element.block_b)] += k.bb;
  }
  return stiffness;
}

// Which blocks nothing but contacts without a bond can hold: no others begin with a stress that is let go.
std::vector<bool> blocks_without_bonds(const BlockSystem& system) {
  std::vector<bool> are_free(system.terms.area.size(), true);
  for (std::size_t i = 0; i < system.contacts.interfaces.size(); ++i) {
    const std::array<bool, 2>& broken = system.contacts.states[i].broken;
    if (broken[0] && broken[1]) continue;
    are_free[static_cast<std::size_t>(system.contacts.interfaces[i].block_a)] = false;
    are_free[static_cast<std::size_t>(system.contacts.interfaces[i].block_b)] = false;
  }
  return are_free;
}

double stiffness_number(const Mat6& stiffness, const Mat6& mass, double dt) {
  return dt * dt * stiffness.topLeftCorner<2, 2>().trace() / mass(0, 0);
}

double stiffness_number_of_strains(const Mat3& stiffness, const Mat6& mass, double dt) {
  return dt * dt * stiffness.trace() / mass.bottomRightCorner<3, 3>().trace();
}

// Blocks that spin and have no stress yet begin to swing. An integrator's acceleration belongs to a moment that is
// t = (gamma - 1/2) dt away from that of the state (ADR 30), where the swing has a0 cos(Omega t) of it left, close to
// a0/(1 + (Omega t)^2/2); so (M + t^2 K/2) a = F. With M alone rho_inf = 0 would begin with too much energy.
Vec6 centrifugal_acceleration(const Mat6& mass, std::size_t block, const BlockSystem& system) {
  const Vec3& stretching = system.terms.centrifugal[block];
  if (stretching.isZero(0)) return Vec6::Zero();
  const double away = system.coefficients.v_a1 - system.coefficients.dt / 2;
  Mat6 matrix = mass;
  matrix.bottomRightCorner<3, 3>() += away * away / 2 * system.terms.area[block] * system.terms.elasticity[block];
  Vec6 force = Vec6::Zero();
  force.tail<3>() = stretching;
  return matrix.llt().solve(force);
}

}  // namespace

void set_initial_acceleration(const std::vector<int>& changing, BlockSystem& system) {
  const Eigen::VectorXd unbalanced = accelerating_forces(system);
  std::vector<Mat6> stiffness =
      stiffness_of_pressed_contacts(changing, system, pressing * largest_of_free_blocks(unbalanced, system));
  const std::vector<bool> are_free = blocks_without_bonds(system);
  const double dt = system.coefficients.dt;
  for (std::size_t i = 0; i < system.state.acceleration.size(); ++i) {
    const Inertia& inertia = system.terms.inertia[i];
    if (inertia.mass == 0) continue;  // held
    const Mat6 mass = mass_matrix(inertia);
    const Mat3 elasticity = system.terms.area[i] * system.terms.elasticity[i];
    const auto force = unbalanced.segment<6>(static_cast<Eigen::Index>(6 * i));
    Vec6& acceleration = system.state.acceleration[i];
    acceleration = mass.llt().solve(force);
    const bool is_unresolved = stiffness_number(stiffness[i], mass, dt) > unresolved ||
                               (are_free[i] && stiffness_number_of_strains(elasticity, mass, dt) > unresolved);
    if (is_unresolved && motion_share(dt * dt * acceleration, system.terms.area[i]) > harmful) {
      stiffness[i].bottomRightCorner<3, 3>() += elasticity;
      acceleration = (mass + dt * dt * stiffness[i]).llt().solve(force);
    }
    acceleration += centrifugal_acceleration(mass, i, system);
  }
}

}  // namespace dda
