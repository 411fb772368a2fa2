// What the steps of linear stages have in common, implicit ones (linear_step.h) and explicit ones (explicit_step.h):
// the constant stiffness and inertia, the forces and momenta that follow from them, the stored energies, and how such a
// stage begins.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "engine/simulation/block_system.h"
#include "engine/simulation/linear_operators.h"
#include "engine/simulation/rayleigh_damping.h"

namespace dda {

struct LinearForces {
  explicit LinearForces(BlockSystem& block_system) : system(block_system) {}

  // Operators and corrections of the stage that system.clock and system.plan tell.
  void set_up();
  // The first moment of that stage: forces, momenta and accelerations there.
  void begin();
  // The stage is over: its operators go.
  void end() { operators.reset(); }

  // Velocities, accelerations, M v and M a, as they are.
  [[nodiscard]] MotionAtStart motion() const;

  // Internal forces at the current displacements; those of supports that move follow their prescribed places.
  void sum_internal_forces(Eigen::VectorXd& force);
  // Elastic energy of blocks, interfaces and supports above that of zero displacement, J per m of thickness.
  [[nodiscard]] double elastic_energy() const;
  // The same from the displacements times (K u/2 + the forces at rest), which a step may have summed up already.
  [[nodiscard]] double elastic_energy(double of_displacements) const;
  [[nodiscard]] StoredEnergy stored_energy() const;
  // Splits the elastic energy: `strain` is that of the blocks' stresses, interfaces and supports store the rest.
  [[nodiscard]] StoredEnergy stored_energy(double kinetic, double strain, double elastic) const;

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [system, operators, rayleigh, momentum, inertia_force, elastic_force, internal_at_rest, energy_offset,
           scratch] = self;
    for (auto* force : {&momentum, &inertia_force, &elastic_force, &internal_at_rest}) archive.of_blocks(*force, 6);
    archive(energy_offset);
    // The others follow from the system, or are written before they are read.
  }

  BlockSystem& system;
  std::optional<LinearOperators> operators;  // only in a stage of this kind
  RayleighDamping rayleigh;

  // 6 entries a block: M v, M a, K u without and internal forces that u does not change.
  Eigen::VectorXd momentum, inertia_force, elastic_force, internal_at_rest;
  double energy_offset = 0;  // makes the elastic energy the sum of its parts, J per m of thickness

 private:
  void set_consistent_weight();
  [[nodiscard]] Eigen::VectorXd initial_acceleration() const;
  [[nodiscard]] double contact_energy() const;
  void make_jumps();

  Eigen::VectorXd scratch_;  // 6 entries a block
};

// Per-block arrays as one vector of 6 entries a block, and back.
inline Eigen::Map<const Eigen::VectorXd> flat(const std::vector<Vec6>& per_block) {
  return {per_block.front().data(), static_cast<Eigen::Index>(6 * per_block.size())};
}

}  // namespace dda
