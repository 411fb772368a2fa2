// Where a section of a lining yields: plain concrete that is perfectly plastic in compression and in tension.
//
// With the whole section at one strength or the other, the part x of its thickness h under tension, the axial force is
// N = f_t x - f_c (h - x) (tension positive) and the moment (f_c + f_t) x (h - x)/2, so that in terms of the forces at
// crushing C = f_c h and at tearing T = f_t h the section carries moments up to
//   P(N) = h (C + N) (T - N)/(2 (C + T)),
// a parabola. An element is loaded at its ends, where the moments are M - Q/2 and M + Q/2: it is elastic where
// |M| + |Q|/2 <= P(N), a convex set. Beyond, plastic gaps grow along the normal of the set (associated flow), and what
// a step ends with is the point of the set nearest to the elastic trial in the energy of the element: the answer to a
// gap is the gradient of a convex potential.
#pragma once

#include "engine/core/types.h"

namespace dda {

struct LiningStrength {
  double thickness = 0;  // m
  double crushing = 0;   // N per m of thickness out of the plane, positive
  double tearing = 0;    // N, at least 0
};

// The largest moment beside an axial force (tension positive), N m; negative beyond crushing and tearing.
inline double plastic_moment(const LiningStrength& strength, double axial) {
  return strength.thickness * (strength.crushing + axial) * (strength.tearing - axial) /
         (2 * (strength.crushing + strength.tearing));
}

struct LiningAnswer {
  Vec3 force = Vec3::Zero();    // N, M, Q
  Mat3 tangent = Mat3::Zero();  // its derivative by the gaps: symmetric and positive semidefinite
  bool yields = false;
};

// The share of what an element can carry: the factor on all three forces at which it yields is one over it.
double utilisation(const LiningStrength& strength, const Vec3& force);

// `stiffness`: of the gaps of lining.h, of which `gap` is the elastic part before yielding.
LiningAnswer lining_answer(const LiningStrength& strength, const Vec3& stiffness, const Vec3& gap);

}  // namespace dda
