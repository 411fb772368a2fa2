// Forces that act from outside: loads with their histories, weight, and what supports that were let go leave behind.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/core/types.h"
#include "engine/model/model.h"
#include "engine/model/state.h"
#include "engine/waves/wave_corrections.h"

namespace dda {

class ExternalForces {
 public:
  // `waves`: loads on the ends of chains have another lever, which only exist where geometry never moves.
  ExternalForces(const Model& model, const State& state, const WaveCorrections& waves);

  // Moves the points of attack with their blocks (finite kinematics).
  void update_geometry(const Model& model, const State& state);

  // From now on `force` (N) acts at the point of this support of the model, which lies at `offset` from the centroid.
  void keep_reaction(std::size_t support, const Vec2& offset, const Vec2& force);

  // The force that it has left behind, zero where it has not.
  [[nodiscard]] Vec2 reaction(std::size_t support) const;

  // Blocks that are absent, `absent` saying so of each, weigh nothing and no load acts on them from now on.
  void leave_out(const Model& model, const std::vector<bool>& absent);

  // Weight by the materials that the model has now; `absent` is empty where no block is.
  void weigh(const Model& model, const std::vector<bool>& absent);

  // From now on the loads of this stage act. Returns whether they are others than before.
  bool begin_stage(const Model& model, std::size_t stage);

  // From now on loads are filtered as the corrections of this stage say.
  void filter(const WaveCorrections& waves);

  // Writes the loads (without weight) at `time` into `force`, 6 entries a block.
  void loads_at(double time, Eigen::VectorXd& force) const;

  // Adds the edge loads of the model that are `chosen`, one flag each, as they are at `time`, whether they act then.
  void add_edge_loads(const std::vector<bool>& chosen, double time, Eigen::VectorXd& force) const;

  // The weight of all blocks, that of held ones zero, as their inertia is; empty without gravity.
  [[nodiscard]] const Eigen::VectorXd& weight() const { return weight_; }
  // Replaces it where inertia couples blocks: weight is inertia times gravity then too.
  void set_weight(const Eigen::VectorXd& weight) { weight_ = weight; }
  [[nodiscard]] bool has_loads() const { return !loads_.empty(); }
  [[nodiscard]] std::size_t number_of_loads() const { return loads_.size(); }

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [loads, reactions, point_loads, weight] = self;
    for (auto& load : loads) archive(load.force);
    for (auto& reaction : reactions) archive(reaction.force);
    // Filters, weight and which loads act follow from the stage.
  }

 private:
  struct Load {
    int block;
    Vec6 force;
    const TimeFunction* history;  // lives in the model
    LoadFilter filter = {};
    bool acts = true;      // its block is there
    bool in_force = true;  // the stage is one of those in which it acts
  };

  // What a support leaves behind that is let go some day; the force is zero until then.
  struct Reaction {
    std::size_t support;
    Vec2 force;
  };

  void correct_levers(const Model& model, const WaveCorrections& waves);

  std::vector<Load> loads_;  // point loads, edge loads, reactions
  std::vector<Reaction> reactions_;
  std::size_t point_loads_ = 0;  // among the loads, the first ones
  Eigen::VectorXd weight_;
};

}  // namespace dda
