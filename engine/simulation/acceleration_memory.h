// What accelerations remember of a step that is cut, when steps are whole again.
//
// The generalized-alpha method balances forces with a mean of the accelerations at both ends of a step. So what a step
// has found goes on in the next ones, and each turns it into velocity in proportion to its dt. After an impact in a
// short part of a step that was cut, the whole steps that follow would make several times the velocity of it that the
// impact has left to give: two free blocks flew apart up to 3.2 times as fast as they had met. So what the parts of a
// step have changed of the accelerations shrinks as the steps grow: it gives what it would have given in steps as short
// as those it comes from.
#pragma once

#include <vector>

#include "engine/core/types.h"

namespace dda {

class AccelerationMemory {
 public:
  // Before the first part of a step.
  void note_start(const std::vector<Vec6>& acceleration) { start_ = acceleration; }

  // What follows is twice as long as the last part. 6 entries a block.
  void halve(std::vector<Vec6>& acceleration) const;

 private:
  std::vector<Vec6> start_;
};

}  // namespace dda
