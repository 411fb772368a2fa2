// Forces that act from outside: loads with their histories, weight, and what supports that were let go leave behind.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/contact/chain_end.h"
#include "engine/core/types.h"
#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

class ExternalForces {
 public:
  // `chain_ends`: loads on them have a shorter lever (chain_end.h); they exist where geometry never moves.
  ExternalForces(const Model& model, const State& state, const std::vector<ChainEnd>& chain_ends = {});

  // Moves the points of attack with their blocks (finite kinematics).
  void update_geometry(const Model& model, const State& state);

  // From now on `force` (N) acts at the point of this support of the model, which lies at `offset` from the centroid.
  void keep_reaction(std::size_t support, const Vec2& offset, const Vec2& force);

  // From now on the loads on block i are those of the model less shares[i] times their second difference over dt: see
  // load_sharpening in cubic_law.h. At time 0, when the run starts from rest, they are those of the model.
  void sharpen(const std::vector<double>& shares, double dt);

  // Writes the loads (without weight) at `time` into `force`, 6 entries a block.
  void loads_at(double time, Eigen::VectorXd& force) const;

  // The weight of all blocks; empty without gravity.
  [[nodiscard]] const Eigen::VectorXd& weight() const { return weight_; }
  // Replaces it where inertia couples blocks: weight is inertia times gravity then too.
  void set_weight(const Eigen::VectorXd& weight) { weight_ = weight; }
  [[nodiscard]] bool has_loads() const { return !loads_.empty(); }
  [[nodiscard]] std::size_t number_of_loads() const { return loads_.size(); }

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [loads, reactions, sharpening_interval, weight] = self;
    for (auto& load : loads) archive(load.force);
    for (auto& reaction : reactions) archive(reaction.force);
    // Sharpening and weight follow from the stage.
  }

 private:
  struct Load {
    int block;
    Vec6 force;
    const TimeFunction* history;  // lives in the model
    double sharpening = 0;
  };

  // Of a support that is let go some day; zero until then.
  struct Reaction {
    std::size_t support;
    Vec2 force;
  };

  void shorten_levers(const Model& model, const ChainEnd& end);
  [[nodiscard]] double factor(const Load& load, double time) const;

  std::vector<Load> loads_;  // point loads, edge loads, reactions
  std::vector<Reaction> reactions_;
  double sharpening_interval_ = 0;  // s
  Eigen::VectorXd weight_;
};

}  // namespace dda
