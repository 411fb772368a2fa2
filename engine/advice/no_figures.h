// Why the wave of a load has no figures, although it could be followed: it jumps, or steps or blocks are too coarse for
// it. A sentence for people; empty where nothing speaks against them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/advice/load_finding.h"
#include "engine/advice/load_history.h"
#include "engine/model/model.h"

namespace dda {

class NoFigures {
 public:
  // `out_of_balance`: what is so when the run begins, as a share of the forces that act.
  NoFigures(const Model& model, double out_of_balance);

  // `wavelength` (m) is that of the load's main frequency, `block_size` (m) along the wave.
  [[nodiscard]] std::string why(const SceneLoad& load, std::size_t stage, double wavelength, double block_size) const;

  [[nodiscard]] const std::vector<LoadFinding>& unseen() const { return unseen_; }
  [[nodiscard]] const std::vector<LoadFinding>& sudden() const { return sudden_; }

 private:
  const Model& model_;
  double out_of_balance_;
  std::vector<LoadFinding> unseen_, sudden_;
};

}  // namespace dda
