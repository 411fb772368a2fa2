// Excess shear stress on the faces of joints (J. A. Ryder 1988, Excess shear stress in the assessment of geologically
// hazardous situations, J. S. Afr. Inst. Min. Metall. 88, 27-39):
//
//   tau_e = |tau| - (c - sigma_n tan phi)        Pa; sigma_n tension positive, the bracket not below 0
//
// tau and sigma_n are means over a face. Where joints slide at their strength it is zero at most; where they are stuck
// whatever they carry (stages of unlimited strength, bonded joints) it says by how much that is too much.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/core/types.h"
#include "engine/model/model.h"

namespace dda {

struct BlockSystem;
struct Measurement;

// A strength to judge by in place of a joint's own.
struct JudgedStrength {
  double friction = 0;  // tangent of the friction angle
  double cohesion = 0;  // Pa
};

// Where two blocks touch along a length: one stretch, or the contacts of their vertices that have one normal.
struct LoadedFace {
  int block_a = 0, block_b = 0;  // the smaller first
  int joint = 0;                 // index into Model::joints
  Vec2 place = Vec2::Zero();     // m, its middle, now
  Vec2 from, to;                 // m, its ends as drawn
  double length = 0;             // m
  double normal = 0, shear = 0;  // Pa, means; tension positive
  double strength = 0;           // Pa, what it can carry in shear under `normal`

  [[nodiscard]] double excess() const;  // Pa
};

// Returns all faces whose joint has a strength: by `judged`, or by that of each joint as it is now (a bonded one has
// that of its friction and cohesion where any is given).
std::vector<LoadedFace> loaded_faces(const BlockSystem& system, const std::optional<JudgedStrength>& judged);

// What the faces of one joint come to.
struct ExcessShear {
  int stage = 0;                    // at the end of which
  int joint = 0;                    // index into Model::joints
  double largest = 0;               // Pa
  int block_a = 0, block_b = 0;     // where
  Vec2 place = Vec2::Zero();        // m
  double normal = 0, shear = 0;     // Pa, there
  double length = 0, positive = 0;  // m, of all faces, and of those where the excess is above 0

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [stage, joint, largest, block_a, block_b, place, normal, shear, length, positive] = self;
    archive.stages(stage);
    archive.joints(joint);
    archive.blocks(block_a, block_b);
    archive(largest, place, normal, shear, length, positive);
  }
};

// Sums up the faces of every joint that has any, as they are now.
std::vector<ExcessShear> excess_by_joint(const BlockSystem& system);

// A measurement of it: the largest excess (Pa; not a number where there is no face) and the length on which it is above
// zero (m).
Vec2 excess_shear(const BlockSystem& system, const Measurement& measurement);

// True when there is a face to measure on now.
bool has_faces(const BlockSystem& system, const Measurement& measurement);

}  // namespace dda
