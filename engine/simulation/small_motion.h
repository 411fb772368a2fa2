// How far the blocks of a run in small kinematics have left the motions that these are right for.
//
// Geometry then stays as drawn: blocks grow as they turn, forces keep their places and directions, contacts act between
// the points where they were found, and blocks that did not touch at the start pass through each other.
#pragma once

#include <vector>

#include "engine/core/types.h"
#include "engine/simulation/simulation.h"

namespace dda {

enum class SmallMotionFault {
  turned,  // a block by an angle t: its lengths are wrong by the share t^2/2
  leaned,  // a block on a contact, sideways by this share of the contact's length: so wrong is the lever of its weight
  slid,    // two blocks along each other: the share of their common face that is lost, or of the face of a block that
           // is not held by which a force on it should have moved
  passed   // two blocks into each other, now or on straight ways from the drawing: the share of the thinner one that is
           // exceeded, 1 or 20 %
};

struct SmallMotionError {
  SmallMotionFault fault = SmallMotionFault::turned;
  double error = 0;   // a share, see above
  double amount = 0;  // rad, or m
  int block = -1, other = -1;
  Vec2 place = Vec2::Zero();  // m, of the block's centroid now
};

// From which share on a result is doubtful, and meaningless: lengths wrong by 0.5 and 5 % (6 and 18 degrees), levers by
// 5 % and so far that the weight is beyond the contact's end, faces by 5 % and wholly, blocks 1 and 20 % in each other.
double doubtful_error(SmallMotionFault fault);
double ruinous_error(SmallMotionFault fault);

// The largest of every fault, as the blocks are now (what came and went before is not known); without those that are
// not doubtful. Empty where some stage has finite kinematics.
std::vector<SmallMotionError> errors_of_small_motion(const Simulation& simulation);

}  // namespace dda
