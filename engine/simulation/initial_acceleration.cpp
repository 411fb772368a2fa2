#include "engine/simulation/initial_acceleration.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>

#include "engine/linear/block_matrix.h"
#include "engine/linear/solver.h"
#include "engine/linear/solver_choice.h"
#include "engine/simulation/settling_drag.h"
#include "engine/simulation/step.h"
#include "engine/solve/largest_entry.h"

namespace dda {
namespace {

// Contacts press when their force is more than this share of the largest force out of balance: blocks that just touch
// do not.
constexpr double pressing = 1e-9;

// Stiffness of a block's contacts times dt^2 over its mass, or of its strains over their inertia, from which on a step
// does not resolve how it lets go.
constexpr double unresolved_from = 1;

// N per m of thickness.
double largest_of_free_blocks(const Eigen::VectorXd& forces, const BlockSystem& system) {
  double largest = 0;
  for (std::size_t i = 0; i < system.terms.area.size(); ++i)
    if (system.terms.inertia[i].mass > 0) largest = std::max(largest, largest_entry(forces, i, system.terms.area[i]));
  return largest;
}

// What contacts without a bond hold blocks with.
struct Pressed {
  std::vector<Mat6> own;  // of each block
  struct Between {
    int block_a, block_b;
    Mat6 ba;
  };
  std::vector<Between> between;
};

// Contacts count that press by more than `negligible` (N per m of thickness): where they slide, by their normal springs
// alone.
Pressed stiffness_of_pressed_contacts(const std::vector<int>& changing, const BlockSystem& system, double negligible) {
  Pressed pressed{std::vector<Mat6>(system.terms.area.size(), Mat6::Zero()), {}};
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
    if (held.isZero(0)) continue;
    const InterfaceMatrices k = stiffness_of(element, held);
    pressed.own[static_cast<std::size_t>(element.block_a)] += k.aa;
    pressed.own[static_cast<std::size_t>(element.block_b)] += k.bb;
    pressed.between.push_back({element.block_a, element.block_b, k.ba});
  }
  return pressed;
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

// The blocks whose acceleration is that of (M + dt^2 K) a = F, together: what they are pressed against moves with them,
// or as it does by itself where a step resolves that.
class UnresolvedBlocks {
 public:
  UnresolvedBlocks(const Pressed& pressed, const std::vector<bool>& unresolved, const BlockSystem& system)
      : pressed_(pressed), unresolved_(unresolved), system_(system) {}

  // `accelerations`: of all blocks by M a = F.
  void accelerate(const Eigen::VectorXd& unbalanced, std::vector<Vec6>& accelerations) const {
    const BlockMatrix matrix = stiffened_inertia();
    const Eigen::VectorXd force = what_accelerates(unbalanced, accelerations);
    const Eigen::VectorXd together = solution(matrix, force);
    for (std::size_t i = 0; i < accelerations.size(); ++i)
      if (unresolved_[i]) accelerations[i] = together.segment<6>(static_cast<Eigen::Index>(6 * i));
  }

 private:
  [[nodiscard]] bool has(int block) const { return unresolved_[static_cast<std::size_t>(block)]; }
  [[nodiscard]] double dt_squared() const { return system_.coefficients.dt * system_.coefficients.dt; }

  // M + dt^2 K; the rows of all other blocks are those of the identity.
  [[nodiscard]] BlockMatrix stiffened_inertia() const {
    std::vector<std::pair<int, int>> couplings;
    for (const auto& [a, b, ba] : pressed_.between)
      if (has(a) && has(b)) couplings.emplace_back(a, b);
    BlockMatrix matrix(static_cast<int>(unresolved_.size()), std::move(couplings));
    for (int block = 0; block < matrix.size(); ++block)
      matrix.diagonal(block) = has(block) ? own_of(static_cast<std::size_t>(block)) : Mat6(Mat6::Identity());
    for (const auto& [a, b, ba] : pressed_.between)
      if (has(a) && has(b)) matrix.add_coupling(b, a, dt_squared() * ba);
    return matrix;
  }

  [[nodiscard]] Mat6 own_of(std::size_t block) const {
    Mat6 stiffness = pressed_.own[block];
    stiffness.bottomRightCorner<3, 3>() += system_.terms.area[block] * system_.terms.elasticity[block];
    return mass_matrix(system_.terms.inertia[block]) + dt_squared() * stiffness;
  }

  // Zero for all other blocks.
  [[nodiscard]] Eigen::VectorXd what_accelerates(const Eigen::VectorXd& unbalanced,
                                                 const std::vector<Vec6>& accelerations) const {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(unbalanced.size());
    for (int block = 0; 6 * block < force.size(); ++block)
      if (has(block)) force.segment<6>(6 * block) = unbalanced.segment<6>(6 * block);
    for (const auto& [a, b, ba] : pressed_.between) {
      if (has(b) && !has(a))
        force.segment<6>(6 * b) -= dt_squared() * (ba * accelerations[static_cast<std::size_t>(a)]);
      if (has(a) && !has(b))
        force.segment<6>(6 * a) -= dt_squared() * (ba.transpose() * accelerations[static_cast<std::size_t>(b)]);
    }
    return force;
  }

  // Each block on its own, beside others of these at rest, where they have no solution together that has digits left.
  static Eigen::VectorXd solution(const BlockMatrix& matrix, const Eigen::VectorXd& force) {
    Eigen::VectorXd solution = Eigen::VectorXd::Zero(force.size());
    const std::unique_ptr<LinearSolver> solver = make_solver(SolverKind::cholesky);
    solver->analyze(matrix);
    if (solver->factorize(matrix) == Status::ok && solver->solve(force, solution) == Status::ok) return solution;
    for (int block = 0; block < matrix.size(); ++block)
      solution.segment<6>(6 * block) = Mat6(matrix.diagonal(block)).llt().solve(force.segment<6>(6 * block));
    return solution;
  }

  const Pressed& pressed_;
  const std::vector<bool>& unresolved_;
  const BlockSystem& system_;
};

}  // namespace

void set_initial_acceleration(const std::vector<int>& changing, double harmless, BlockSystem& system) {
  const Eigen::VectorXd unbalanced = accelerating_forces(system);
  const Pressed pressed =
      stiffness_of_pressed_contacts(changing, system, pressing * largest_of_free_blocks(unbalanced, system));
  const std::vector<bool> are_free = blocks_without_bonds(system);
  const double dt = system.coefficients.dt;
  std::vector<bool> unresolved(system.state.acceleration.size(), false);
  for (std::size_t i = 0; i < system.state.acceleration.size(); ++i) {
    const Inertia& inertia = system.terms.inertia[i];
    if (inertia.mass == 0) continue;  // held
    const Mat6 mass = mass_matrix(inertia);
    const Mat3 elasticity = system.terms.area[i] * system.terms.elasticity[i];
    Vec6& acceleration = system.state.acceleration[i];
    acceleration = mass.llt().solve(unbalanced.segment<6>(static_cast<Eigen::Index>(6 * i)));
    unresolved[i] = (stiffness_number(pressed.own[i], mass, dt) > unresolved_from ||
                     (are_free[i] && stiffness_number_of_strains(elasticity, mass, dt) > unresolved_from)) &&
                    motion_share(dt * dt * acceleration, system.terms.area[i]) > harmless;
  }
  if (std::ranges::find(unresolved, true) != unresolved.end())
    UnresolvedBlocks(pressed, unresolved, system).accelerate(unbalanced, system.state.acceleration);
  for (std::size_t i = 0; i < system.state.acceleration.size(); ++i)
    if (const Inertia& inertia = system.terms.inertia[i]; inertia.mass > 0)
      system.state.acceleration[i] += centrifugal_acceleration(mass_matrix(inertia), i, system);
}

}  // namespace dda
