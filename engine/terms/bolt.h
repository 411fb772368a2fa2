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
inline BoltRows bolt_rows(const Vec2& direction, const Vec2& arm_a, const Vec2& arm_b) {
  Mat2 axes;
  axes << direction.x(), direction.y(), -direction.y(), direction.x();
  return {-axes * displacement_rows(arm_a), axes * displacement_rows(arm_b)};
}

struct BoltLaw {
  Vec2 stiffness = Vec2::Zero();                   // N/m per m of thickness: along, across
  Vec2 least = Vec2::Zero(), most = Vec2::Zero();  // N per m of thickness: bounds of the forces
};

struct BoltAnswer {
  Vec2 force;
  Vec2 active;  // 1 where the gap changes the force, 0 at a bound
};

inline BoltAnswer bolt_answer(const BoltLaw& law, const Vec2& gap) {
  BoltAnswer answer{law.stiffness.cwiseProduct(gap), Vec2::Ones()};
  for (Eigen::Index i = 0; i < 2; ++i) {
    if (answer.force(i) > law.least(i) && answer.force(i) < law.most(i)) continue;
    if (law.stiffness(i) == 0) continue;
    answer.force(i) = answer.force(i) >= law.most(i) ? law.most(i) : law.least(i);
    answer.active(i) = 0;
  }
  return answer;
}

// What of `gap` is elastic: all of it inside the bounds and where the bolt is slack, and what carries the force at a
// bound where it yields. The rest is plastic.
inline Vec2 elastic_part(const BoltLaw& law, const Vec2& gap) {
  Vec2 elastic = gap;
  for (Eigen::Index i = 0; i < 2; ++i) {
    const double stuck = law.stiffness(i) * gap(i);
    if (stuck > law.most(i)) elastic(i) = law.most(i) / law.stiffness(i);
    if (stuck < law.least(i) && law.least(i) < 0) elastic(i) = law.least(i) / law.stiffness(i);
  }
  return elastic;
}

// Stored energy, J per m of thickness.
inline double bolt_energy(const BoltLaw& law, const Vec2& force) {
  double energy = 0;
  for (Eigen::Index i = 0; i < 2; ++i)
    if (law.stiffness(i) > 0) energy += force(i) * force(i) / (2 * law.stiffness(i));
  return energy;
}

}  // namespace dda
