// "point", "edge", "block" and "history" of loads, supports, boundaries and measurements.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "engine/builder/ground_plan.h"
#include "engine/model/time_function.h"
#include "engine/scene/field.h"
#include "engine/scene/record_files.h"

namespace dda {

struct PlacedPoint {
  int block = 0;
  Vec2 point;
};

// The block at owner.point: the only one there, or the one owner.block names.
PlacedPoint read_point(const Field& owner, const GroundPlan& plan, const Model& model);

// The block in which a line ends at the point `field`, coming from `other_end`: where several touch, the one that the
// line runs in.
int read_anchor(const Field& field, const Vec2& other_end, const GroundPlan& plan, const Model& model);

// The outlines along owner.edge - a line, the wall of a cavity or the outside of all blocks - of owner.block if that is
// given; at least one. Stretches of several blocks on the two sides of a joint are refused, as it is not said which are
// meant.
std::vector<Stretch> read_edge(const Field& owner, const GroundPlan& plan, const Model& model);

// Whether this edge is one of joints.
bool is_of_joints(const Field& edge);

// Those of owner.block, if that is given; at least one.
template <typename Face>
void keep_named_block(const Field& owner, const GroundPlan& plan, std::vector<Face>& faces,
                      const char* expected = "a block with a side along this edge") {
  const auto name = owner.find("block");
  if (!name) return;
  const int block = name->choice(plan.names());
  std::erase_if(faces, [block](const Face& face) { return face.block != block; });
  if (faces.empty()) name->fail(expected);
}

// The index of the joint that `field` names.
int read_joint_reference(const Field& field, const Model& model);

// The position of the stage that `field` names.
int read_stage_reference(const Field& field, const Model& model);

// The blocks that have the name `field`, or are of that group (`groups`: of each block); at least one.
std::vector<int> blocks_called(const Field& field, const std::vector<std::string>& groups, const Model& model);

// [time, factor] rows, times increasing.
PiecewiseLinear read_table(const Field& field);

// Names of blocks as a sentence lists them.
std::string listed(const std::vector<int>& blocks, const Model& model);

// Throws for the first of `keys` that `owner` has: "expected to be left out REASON".
void refuse(const Field& owner, std::initializer_list<const char*> keys, const char* reason);

// owner.history; Constant when left out. A record may have a unit of `dimension`.
TimeFunction read_history(const Field& owner, Dimension dimension, RecordFiles& records);

}  // namespace dda
