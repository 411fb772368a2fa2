// The step of a scene in which nothing can change - all joints bonded, geometry as drawn: constant stiffness K and
// inertia M over all unknowns (linear_operators.h). A step is one product with each and one solve, and visits neither
// interfaces nor strengths.
//
// In a linear stage the states of the contacts hold their gaps at zero displacement, which is what finite kinematics
// before it left; interface_state() computes what they are now.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "engine/contact/interface_state.h"
#include "engine/core/status.h"
#include "engine/simulation/block_system.h"
#include "engine/simulation/linear_operators.h"
#include "engine/simulation/rayleigh_damping.h"
#include "engine/simulation/step.h"
#include "engine/solve/step_matrix.h"

namespace dda {

class LinearStep : public Step {
 public:
  explicit LinearStep(BlockSystem& system) : system_(system), matrix_(system.costs) {}

  void set_up(BlockMatrix pattern) override;
  void begin() override;
  [[nodiscard]] Status advance(double dt, bool can_be_cut) override;
  void hand_over() override;
  void take_over() override;
  // Writes the states of the contacts as they are now, which hand_over() does too.
  void write_states();
  [[nodiscard]] StoredEnergy stored_energy() const override;
  [[nodiscard]] const std::string& message() const override { return message_; }

  [[nodiscard]] InterfaceState interface_state(std::size_t index) const;
  [[nodiscard]] std::int64_t solver_iterations() const { return matrix_.iterations(); }

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [system, operators, matrix, rayleigh, momentum, inertia_force, elastic_force, internal_at_rest, energy_offset,
           next_momentum, rhs, message] = self;
    archive(momentum, inertia_force, elastic_force, internal_at_rest, energy_offset);
    // The others follow from the system, or are written before they are read.
  }

 private:
  void set_step_size(double dt);
  void set_consistent_weight();
  [[nodiscard]] Eigen::VectorXd initial_acceleration() const;
  void form_rhs();
  [[nodiscard]] Status solve();
  void foresee_increment();
  void accept();
  void book_damping();
  [[nodiscard]] double follow_inertia_force();
  void sum_internal_forces(Eigen::VectorXd& force);
  [[nodiscard]] double elastic_energy() const;
  [[nodiscard]] double contact_energy() const;
  void sum_forces_of_states();

  BlockSystem& system_;
  std::optional<LinearOperators> operators_;  // only in a linear stage
  StepMatrix matrix_;
  RayleighDamping rayleigh_;

  // 6 entries a block: M v, M a, K u without and internal forces that u does not change.
  Eigen::VectorXd momentum_, inertia_force_, elastic_force_, internal_at_rest_;
  double energy_offset_ = 0;  // makes the elastic energy the sum of its parts, J per m of thickness

  // Within a step, 6 entries a block.
  Eigen::VectorXd next_momentum_, rhs_;
  std::string message_;
};

}  // namespace dda
