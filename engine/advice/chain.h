// The equations of a way through a scene, layer by layer, out of the engine's own matrices for its blocks.
#pragma once

#include <vector>

#include "engine/advice/chain_path.h"
#include "engine/simulation/linear_operators.h"

namespace dda {

class Chain {
 public:
  // `consistent`: joints have the accurate law in place of their own. The stage gives its inertia options and dt.
  Chain(const Model& model, const ChainPath& path, const Stage& stage, bool consistent);

  // Force at joint number `joint` along the wave's motion, for s^2 = `square`, where only the first `layers` of the way
  // are there and the wave goes on behind them. It is divided by the force on the end or, where the end is moved, by
  // its displacement times the impedance of the first layer: exp(-s x/c) and s exp(-s x/c) in rock without joints.
  [[nodiscard]] Complex force(Complex square, int joint, int layers) const;

  // The filter through which a run puts loads on the end.
  [[nodiscard]] const LoadFilter& load_filter() const { return load_filter_; }

 private:
  // Forces on a layer by its own unknowns and those of its neighbours.
  struct Layer {
    Mat6 own = Mat6::Zero(), next = Mat6::Zero(), last = Mat6::Zero();
  };
  struct Traction {
    Vec6 here = Vec6::Zero(), last = Vec6::Zero();  // N, at a layer's first face by its unknowns and the last layer's
  };
  [[nodiscard]] ComplexMat6 own_at_end(Complex square, int layer) const;
  void fold(const LinearOperators& operators);
  void set_drive(const Model& model, const WaveCorrections& waves, const std::vector<SupportElement>& supports);
  void set_tractions(const Model& model, const ContactSet& contacts);

  ChainPath path_;
  Vec2 particles_;
  std::vector<Layer> stiffness_, inertia_;
  std::vector<Traction> tractions_;
  Vec6 push_ = Vec6::Zero();  // on the first layer; of a held one its motion
  double unit_ = 1;           // of the force that is told
  LoadFilter load_filter_;
};

// The same force in rock without blocks or joints, where layers of other impedance send back what they do.
Complex exact_force(const ChainPath& path, Complex s, int joint, int layers);

}  // namespace dda
