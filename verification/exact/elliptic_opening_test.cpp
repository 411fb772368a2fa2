#include "verification/exact/elliptic_opening.h"

#include <gtest/gtest.h>

#include <cmath>

#include "verification/exact/kirsch.h"

namespace exact {
namespace {

TEST(EllipticOpening, IsGriffithsCrackAndASuddenCircle) {
  const double a = 1.3;
  EXPECT_NEAR(released_by_ellipse({40e9, 0.25, 0, 10e6}, a, 0), std::numbers::pi * a * a * 1e14 * (1 - 0.0625) / 40e9,
              1e-9);
  const double shear = 40e9 / 2.5;
  EXPECT_NEAR(released_by_ellipse({40e9, 0.25, -10e6, -10e6}, a, a),
              2 * (1 - 0.25) * std::numbers::pi * a * a * 1e14 / (2 * shear), 1e-9);
}

// The energy that a growing circle releases for each metre of radius is the strain energy of its wall, the integral of
// (1 - nu^2) s_hoop^2/(2 E) over it (Rice & Drucker 1967), with Kirsch's hoop stress.
TEST(EllipticOpening, ReleasesTheWallsEnergyAsItGrows) {
  const PlaneRock rock{40e9, 0.25, -12e6, -40e6};
  for (const double a : {0.5, 2.0}) {
    double energy = 0;
    const int parts = 64;
    for (int i = 0; i < parts; ++i) {
      const double angle = 2 * std::numbers::pi * i / parts;
      const double hoop = kirsch(rock.xx, rock.yy, 1, angle).hoop;
      energy += (1 - rock.poisson * rock.poisson) * hoop * hoop / (2 * rock.young) * a * 2 * std::numbers::pi / parts;
    }
    const double h = 1e-4;
    EXPECT_NEAR((released_by_ellipse(rock, a + h, a + h) - released_by_ellipse(rock, a - h, a - h)) / (2 * h), energy,
                1e-6 * energy);
  }
}

}  // namespace
}  // namespace exact
