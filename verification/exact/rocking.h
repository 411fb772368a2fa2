// A rigid rectangle that rocks on a rigid floor without sliding (Housner 1963): SI units, angles in rad.
//
// The corner it turns about lies R from the centroid, and the line to it stands at alpha from the vertical when the
// rectangle is upright. Tilted by theta < alpha it turns back by theta'' = -p^2 sin(alpha - theta), p^2 = 3 g/(4 R).
#pragma once

#include <functional>

namespace exact {

struct RockingBlock {
  double width = 0;   // m
  double height = 0;  // m

  [[nodiscard]] double slenderness_angle() const;  // alpha, tan alpha = width/height
  [[nodiscard]] double radius() const;             // R, m
};

[[nodiscard]] double rocking_frequency(const RockingBlock& block, double gravity);  // p, 1/s

// Period of rocking with amplitude theta0 (no loss at impacts) of the equation linearised in alpha and theta: four
// times the fall to the upright position, (4/p) acosh(1/(1 - theta0/alpha)). Housner 1963.
[[nodiscard]] double housner_period(const RockingBlock& block, double gravity, double theta0);

// The same of the full equation. With sin((alpha - theta)/2) = s cosh u, s = sin((alpha - theta0)/2), conservation of
// energy becomes p dt = du/sqrt(1 - s^2 cosh^2 u): a smooth integral, by Simpson's rule to 1e-13.
[[nodiscard]] double rocking_period(const RockingBlock& block, double gravity, double theta0);

// Angular speed after over before an impact without bounce: angular momentum about the corner that lands is kept,
// 1 - (3/2) sin^2 alpha. Housner 1963.
[[nodiscard]] double rocking_impact_ratio(const RockingBlock& block);

// Angular speed (1/s) with which a block let go at tilt theta0 passes theta: energy conserved.
[[nodiscard]] double rocking_speed(const RockingBlock& block, double gravity, double theta0, double theta);

// The tilt from which a block let go passes the upright position with this angular speed: where it comes to rest when
// it leaves that position so fast. `speed` must be too slow to topple it.
[[nodiscard]] double rocking_amplitude(const RockingBlock& block, double gravity, double speed);

// Horizontal acceleration of the floor at which one corner starts to lift: g width/height.
[[nodiscard]] double uplift_acceleration(const RockingBlock& block, double gravity);

// Tilt (rad) at `time` of a block at rest on a floor that moves with the acceleration a(t) (m/s2), not decreasing from
// a(0) = 0: theta'' = p^2 (a/g cos(alpha - theta) - sin(alpha - theta)) from the moment of uplift on. By Runge and
// Kutta's method with `steps` steps.
[[nodiscard]] double tilt_on_moving_floor(const RockingBlock& block, double gravity,
                                          const std::function<double(double)>& acceleration, double time,
                                          int steps = 4000);

}  // namespace exact
