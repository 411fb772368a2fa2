#include "verification/exact/voussoir_beam.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace exact {
namespace {

// The line of thrust under an even load is a parabola of this rise.
TEST(VoussoirBeam, ThrustBalancesHalfTheBeam) {
  const double weight = 6.5e4;
  const double span = 7;
  const double rise = 0.4;
  const double moment_of_weight = weight / 2 * span / 4;  // of one half about its springing
  const double moment_of_reaction = weight / 2 * span / 2;
  const double thrust = voussoir_thrust(weight, span, rise);
  EXPECT_NEAR(moment_of_reaction - moment_of_weight - thrust * rise, 0, 1e-9);
  EXPECT_NEAR(weight / 2 / thrust, voussoir_needed_friction(span, rise), 1e-15);
}

// The roof over the reservoir of Tel Beer-Sheva, 2.5 m thick over 7 m: Hatzor and Benary (1998) got 36 deg by Beer and
// Meek's procedure.
TEST(VoussoirBeam, BeerAndMeeksFriction) {
  const double degrees = std::atan(voussoir_needed_friction(7, beer_meek_rise(2.5))) * 180 / std::numbers::pi;
  EXPECT_NEAR(degrees, 36, 0.6);
}

}  // namespace
}  // namespace exact
