#include "verification/exact/layered_ground.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace exact {
namespace {

double pulse(double t) { return t > 0 && t < 0.1 ? std::pow(std::sin(31.4159265358979 * t), 2) : 0; }

TEST(LayeredGround, DoublesWhereTheLayerIsLikeWhatIsBelow) {
  const LayeredGround same{3e6, 3e6, 0.02, 0.03};
  EXPECT_NEAR(surface_velocity(same, pulse, 0.1), 2 * pulse(0.05), 1e-15);
  EXPECT_EQ(surface_velocity(same, pulse, 0.049), 0);
}

// After long, the surface goes with a steady stream as if there were no layer.
TEST(LayeredGround, ForgetsTheLayerInTheEnd) {
  const LayeredGround soft{3e6, 1e6, 0.02, 0.03};
  EXPECT_NEAR(surface_velocity(
                  soft, [](double) { return 1.0; }, 10),
              2, 1e-12);
  EXPECT_NEAR(surface_velocity(
                  soft, [](double) { return 1.0; }, 0.06),
              3, 1e-12);  // 2 T, T = 1.5, before it returns
}

// Amplification of a harmonic wave by a layer a quarter of a wavelength high: Z_b/Z_a, twice that of the surface.
TEST(LayeredGround, ResonatesAtAQuarterWavelength) {
  const LayeredGround soft{3e6, 1e6, 0, 0.25};
  double largest = 0;
  for (int i = 0; i < 1000; ++i)
    largest = std::max(largest, surface_velocity(
                                    soft, [](double t) { return std::sin(6.283185307179586 * t); }, 30 + i * 1e-3));
  EXPECT_NEAR(largest, 6, 1e-3);
}

}  // namespace
}  // namespace exact
