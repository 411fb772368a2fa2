// What acted at the end of the last step, where gaps have been measured anew since (measured_anew.h).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/contact/interface_element.h"
#include "engine/core/types.h"

namespace dda {

struct KeptForces {
  struct OfInterface {
    int block_a, block_b;
    Vec2 from;
    Vec4 force, gap;
  };

  bool are_noted = false;  // in the step under way
  std::vector<OfInterface> interfaces;
  std::vector<Vec2> supports, links;
  std::vector<Vec3> linings;

  // Forces on the blocks' unknowns, 6 a block, which acted at the start by so much less than is measured; empty where
  // there never were any.
  Eigen::VectorXd jump;

  // The step is over. Memory is kept for the next one.
  void forget() {
    if (!are_noted) return;
    are_noted = false;
    interfaces.clear();
    supports.clear();
    links.clear();
    linings.clear();
    jump.setZero();
  }
};

}  // namespace dda
