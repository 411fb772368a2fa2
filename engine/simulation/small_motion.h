// How far the blocks of a run in small kinematics have left the motions that these are right for.
//
// Geometry then stays as drawn: blocks grow as they turn, forces keep their places and directions, contacts act between
// the points where they were found, and blocks that did not touch at the start pass through each other.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/core/types.h"
#include "engine/model/model.h"
#include "engine/model/state.h"
#include "engine/simulation/stage_clock.h"
#include "engine/simulation/step_plan.h"

namespace dda {

enum class SmallMotionFault {
  turned,  // a block by an angle t: its lengths are wrong by the share t^2/2
  leaned,  // a block on a contact, sideways by this share of the contact's length: so wrong is the lever of its
           // weight
  slid,    // two blocks along each other: the share of their common face that is lost, or of the face of a block
           // that is not held by which a force on it should have moved
  passed,  // two blocks into each other: the share of the thinner one that is exceeded, 1 or 20 %
  may_have_passed  // the same on a straight way from the drawing, which may not be the one they took
};
inline constexpr std::size_t small_motion_faults = 5;

struct SmallMotionError {
  SmallMotionFault fault = SmallMotionFault::turned;
  double error = 0;   // a share, see above
  double amount = 0;  // rad, or m
  int block = -1, other = -1;
  Vec2 place = Vec2::Zero();  // m, of the block's centroid then

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [fault, error, amount, block, other, place] = self;
    archive(fault, error, amount, place);
    archive.blocks_or_none(block, other);
  }
};

// From which share on a result is doubtful, and meaningless: lengths wrong by 0.5 and 5 % (6 and 18 degrees), levers by
// 5 % and so far that the weight is beyond the contact's end, faces by 5 % and wholly, blocks 1 and 20 % in each other;
// what only may have happened is never more than doubtful.
double doubtful_error(SmallMotionFault fault);
double ruinous_error(SmallMotionFault fault);

using SmallMotionErrors = std::array<SmallMotionError, small_motion_faults>;

// What is looked at.
struct BlocksInMotion {
  const Model& model;
  const State& state;
  const ContactSet& contacts;
  const StepPlan& plan;  // of the stage
  const StageClock& clock;
  const std::vector<bool>& absent;  // of each block; empty: none is
};

// Watches the stages of a run that are in small kinematics. Turns, leans and slides are those of a stage's end; whether
// blocks pass through each other is looked at on their way too, wherever one has gone a quarter of its thickness, or in
// a scene that stays linear on straight ways at the end of a stage.
class SmallMotionWatch {
 public:
  void begin_stage(const BlocksInMotion& blocks);
  // To be called after every step. It asks in every step of stages that pace themselves, and in every eighth of others,
  // between which ways are taken for straight.
  void follow(const BlocksInMotion& blocks);
  void end_stage(const BlocksInMotion& blocks);

  // The largest of every fault that is doubtful.
  [[nodiscard]] std::vector<SmallMotionError> errors() const;

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [worst, turns_before, looked_at, thickness, radius] = self;
    archive(worst);
    archive.of_blocks(turns_before);
    archive.of_blocks(looked_at);  // the others are the drawing's
  }

 private:
  void measure(const Model& model);
  [[nodiscard]] double gone(const BlocksInMotion& blocks) const;

  SmallMotionErrors worst_{};
  // The turns (rad) of all blocks after stages of finite kinematics, whose last geometry counts as drawn; else empty.
  std::vector<double> turns_before_;
  std::vector<Vec6> looked_at_;             // displacements where overlaps were looked at last
  std::vector<double> thickness_, radius_;  // m, of every block
};

}  // namespace dda
