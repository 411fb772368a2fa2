// Inertia of a block: kinetic energy 1/2 v M v with the velocities v of the six unknowns, M the integral of rho T^T T
// (Shi 1988).
#pragma once

#include <cmath>

#include "engine/core/types.h"
#include "engine/geometry/polygon.h"

namespace dda {

// Mean squares of the offsets from the centroid, m^2: (x x), (y y), (x y).
Vec3 mean_squares(const AreaMoments& moments);

// The same after the deformation F of the block, which carries its mass along: F J F^T.
Vec3 deformed_mean_squares(const Vec3& mean_squares, const Mat2& deformation);

struct Inertia {
  double mass = 0;              // kg per m of thickness
  Vec3 squares = Vec3::Zero();  // mean squares, m^2
  double strain_inertia = 1;    // factor on the inertia of the strains alone (see Stage)
  // m^2, what the block has more against rotation than `squares` say, if its shape has changed since these were
  // measured.
  double beyond = 0;

  // Mean square of the distances from the centroid, m^2.
  [[nodiscard]] double polar() const { return squares(0) + squares(1) + beyond; }
  // How the inertia between rotation and strains follows `beyond`: as the root of that of rotation does. A thin block
  // that turns and one that shears move nearly alike, and the little that is between them would be lost: the inertia of
  // a sliver would no longer be positive.
  [[nodiscard]] double coupling() const { return beyond == 0 ? 1 : std::sqrt(polar() / (squares(0) + squares(1))); }
};

Mat6 mass_matrix(const Inertia& inertia);

// M v without forming M.
inline Vec6 momentum(const Inertia& inertia, const Vec6& v) {
  const double xx = inertia.squares(0);
  const double yy = inertia.squares(1);
  const double xy = inertia.squares(2);
  const double strain = inertia.strain_inertia;
  const double coupling = inertia.coupling();
  const double along = coupling * xy;
  const double across = coupling * (xx - yy) / 2;
  Vec6 p;
  p << v(0), v(1),                                                     //
      inertia.polar() * v(2) + along * (v(4) - v(3)) + across * v(5),  //
      -along * v(2) + strain * (xx * v(3) + xy / 2 * v(5)),            //
      along * v(2) + strain * (yy * v(4) + xy / 2 * v(5)),             //
      across * v(2) + strain * (xy / 2 * (v(3) + v(4)) + (xx + yy) / 4 * v(5));
  return inertia.mass * p;
}

}  // namespace dda
