// One link of a rock bolt: a spring along the bolt and one across it, each elastic between two bounds and perfectly
// plastic at them.
//
// The gap is the elastic elongation e and shear s, e including what stands for the pretension N0 (e = N0/k at the
// start), so that force = stiffness * gap inside the bounds. The answer to a gap is the gradient of a convex potential
// (Huber's function; half a parabola for a bolt that goes slack), which the open-close iteration needs.
#pragma once

#include "engine/core/types.h"

namespace dda {

// Rows of the link's two gaps: (along; across) = rows_a d_a + rows_b d_b.
struct BoltRows {
  Mat26 a = Mat26::Zero(), b = Mat26::Zero();
};

// `direction`: unit, from block a to block b; arms from the blocks' centroids, m. Across is a quarter turn
// counter-clockwise from along.
BoltRows bolt_rows(const Vec2& direction, const Vec2& arm_a, const Vec2& arm_b);

struct BoltLaw {
  Vec2 stiffness = Vec2::Zero();                   // N/m per m of thickness: along, across
  Vec2 least = Vec2::Zero(), most = Vec2::Zero();  // N per m of thickness: bounds of the forces
};

struct BoltAnswer {
  Vec2 force;
  Vec2 active;  // 1 where the gap changes the force, 0 at a bound
};

BoltAnswer bolt_answer(const BoltLaw& law, const Vec2& gap);

// What of `gap` is elastic: all of it inside the bounds and where the bolt is slack, and what carries the force at a
// bound where it yields. The rest is plastic.
Vec2 elastic_part(const BoltLaw& law, const Vec2& gap);

// Stored energy, J per m of thickness.
double bolt_energy(const BoltLaw& law, const Vec2& force);

}  // namespace dda
