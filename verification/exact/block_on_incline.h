// How a rigid rectangle let go on an inclined plane starts to move (SI units, angles in rad).
//
// The chart of slope angle a and friction angle f for given width over height b/h has four regions. Statics alone
// (a < f, tan a < b/h) gives the stable one. Of the others, the moving block's own inertia decides:
//   slides only          a > f and tan f <= b/h: the friction of a block that slides, mu N, passes inside its foot;
//   topples only         b/h < tan a, and what a block that turns about its toe needs, T/N below, is at most tan f;
//   slides and topples   the rest.
// Turning about the toe without sliding has the angular acceleration A = (3/4)(g/R) sin(a - d), tan d = b/h, R half of
// the diagonal, so T/N = (g sin a - A h/2)/(g cos a + A b/2), which is below tan a: some blocks with f < a topple
// without sliding. These are the dynamic boundaries of Voegele (1979) and Sagaseta (1986), which correct the kinematic
// ones (a = f, tan a = b/h throughout) of Bray and Goodman's (1981) chart; derived here from the equations of motion.
#pragma once

namespace exact {

struct InclinedBlock {
  double width = 0;     // m, along the plane
  double height = 0;    // m
  double slope = 0;     // rad
  double friction = 0;  // rad, friction angle
};

// Accelerations from rest; both are zero of a block that stays.
struct InclineMotion {
  double sliding = 0;   // m/s2, of the toe, down the plane
  double toppling = 0;  // rad/s2, of turning about the toe, downhill

  [[nodiscard]] bool slides() const { return sliding > 0; }
  [[nodiscard]] bool topples() const { return toppling > 0; }
};

// Below a friction coefficient of 4/3 (53 deg) the motion exists and is unique for every block; above it a sliding and
// toppling block can jam (Painleve's paradox).
[[nodiscard]] InclineMotion initial_motion(const InclinedBlock& block, double gravity);

// True when a change of either angle by `distance` (rad) leaves the region the same: no boundary is nearer along either
// axis of the chart.
[[nodiscard]] bool is_clear_of_boundaries(const InclinedBlock& block, double distance);

}  // namespace exact
