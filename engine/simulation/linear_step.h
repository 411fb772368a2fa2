// The step of a scene in which nothing can change - all joints bonded, geometry as drawn: constant stiffness K and
// inertia M over all unknowns (linear_operators.h). An implicit step is one product with each and one solve, and visits
// neither interfaces nor strengths.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>

#include "engine/core/status.h"
#include "engine/simulation/block_system.h"
#include "engine/simulation/linear_forces.h"
#include "engine/simulation/linear_states.h"
#include "engine/simulation/step.h"
#include "engine/solve/step_matrix.h"

namespace dda {

class LinearStep : public Step {
 public:
  explicit LinearStep(BlockSystem& system) : system_(system), linear_(system), matrix_(system.costs) {}

  void set_up(BlockMatrix pattern) override;
  void begin() override { linear_.begin(); }
  [[nodiscard]] Status advance(double dt, Taken taken) override;
  void hand_over() override;
  void take_over() override { keep_gaps_at_rest(system_); }
  [[nodiscard]] StoredEnergy stored_energy() const override { return linear_.stored_energy(); }
  [[nodiscard]] const std::string& message() const override { return message_; }

  [[nodiscard]] std::int64_t solver_iterations() const { return matrix_.iterations(); }

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [system, linear, matrix, next_momentum, rhs, message] = self;
    archive(linear);
    // The others follow from the system, or are written before they are read.
  }

 private:
  void set_step_size(double dt);
  void form_rhs();
  [[nodiscard]] Status solve();
  void foresee_increment();
  void accept();
  [[nodiscard]] double follow_inertia_force();

  BlockSystem& system_;
  LinearForces linear_;
  StepMatrix matrix_;

  // Within a step, 6 entries a block.
  Eigen::VectorXd next_momentum_, rhs_;
  std::string message_;
};

}  // namespace dda
