// Energies of elliptical openings in endless elastic rock under far stresses along their axes, in plane strain. Per
// metre of thickness; stresses are positive in tension.
#pragma once

#include <numbers>

namespace exact {

struct PlaneRock {
  double young = 0, poisson = 0;  // Pa
  double xx = 0, yy = 0;          // Pa, far away
};

// What the potential energy of rock and loads falls by when an opening with the half axes `a` along x and `b` along y
// is made, the strain energy of the rock in it included (Eshelby 1957; as a compliance of cavities Kachanov 1993,
// Elastic solids with many cracks and related problems, Adv. Appl. Mech. 30, 259-445):
//   pi (1 - nu^2)/(2 E) (a b (s_x - s_y)^2 + 2 a^2 s_y^2 + 2 b^2 s_x^2).
// A circle under equal stresses p gives 2 (1 - nu) pi a^2 p^2/(2 G), a crack pi a^2 s_y^2 (1 - nu^2)/E (Griffith).
[[nodiscard]] inline double released_by_ellipse(const PlaneRock& rock, double a, double b) {
  const double difference = rock.xx - rock.yy;
  return std::numbers::pi * (1 - rock.poisson * rock.poisson) / (2 * rock.young) *
         (a * b * difference * difference + 2 * a * a * rock.yy * rock.yy + 2 * b * b * rock.xx * rock.xx);
}

}  // namespace exact
