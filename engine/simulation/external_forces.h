// Forces that act from outside: loads with their histories, and weight.
#pragma once

#include <vector>

#include "dda/core/types.h"
#include "dda/model/model.h"
#include "dda/model/state.h"

namespace dda {

class ExternalForces {
 public:
  ExternalForces(const Model& model, const State& state);

  // Moves the points of attack with their blocks (finite kinematics).
  void update_geometry(const Model& model, const State& state);

  // Writes the loads (without weight) at `time` into `force`, 6 entries a block.
  void loads_at(double time, Eigen::VectorXd& force) const;

  // The weight of all blocks; empty without gravity.
  [[nodiscard]] const Eigen::VectorXd& weight() const { return weight_; }
  // Replaces it where inertia couples blocks: weight is inertia times gravity then too.
  void set_weight(const Eigen::VectorXd& weight) { weight_ = weight; }
  [[nodiscard]] bool has_loads() const { return !loads_.empty(); }

 private:
  friend struct SnapshotAccess;  // snapshot.h

  struct Load {
    int block;
    Vec6 force;
    const TimeFunction* history;  // lives in the model
  };

  std::vector<Load> loads_;
  Eigen::VectorXd weight_;
};

}  // namespace dda
