// A rigid block on a plane under Coulomb friction with one coefficient, at rest and sliding: when it sticks, when it
// slides, how far. All accelerations are forces per unit mass, m/s2, along the plane; velocity and position are
// relative to the plane.
//
//   sliding in direction s = +1, -1:  acceleration = drive - s limit, until the velocity is zero
//   stuck:                            as long as |drive| <= limit
//
// Drive and limit are harmonic in time, so every phase integrates in closed form; only its end is a root, found by
// bisection to round-off.
#pragma once

#include <cmath>
#include <vector>

namespace exact {

// mean + amplitude sin(omega t + phase)
struct Harmonic {
  double mean = 0;
  double amplitude = 0;
  double omega = 0;  // rad/s, not zero unless the amplitude is
  double phase = 0;  // rad

  [[nodiscard]] double at(double t) const;
  [[nodiscard]] double integral(double from, double to) const;
  // Integral over t in [from, to] of integral(from, t).
  [[nodiscard]] double double_integral(double from, double to) const;
};

// What drives a block down an incline and what friction can hold, per unit mass. `shaking`: horizontal acceleration
// a(t) that the block feels down the incline (the base's is the opposite). While sliding down the difference is
//   g (sin a - cos a tan f) + a(t) (cos a + sin a tan f).
struct InclineForces {
  Harmonic drive;  // g sin a + a(t) cos a
  Harmonic limit;  // tan f (g cos a - a(t) sin a)
};
[[nodiscard]] InclineForces incline_forces(double gravity, double slope, double friction_angle,
                                           const Harmonic& shaking = {});

// v0^2/(2 mu g), m: a block that slides to rest on a level plane.
[[nodiscard]] inline double stopping_distance(double velocity, double friction, double gravity) {
  return velocity * velocity / (2 * friction * gravity);
}

class CoulombSlider {
 public:
  // From rest at position 0, or moving, at time `start`. `end`: up to when the motion is asked for, s.
  CoulombSlider(const Harmonic& drive, const Harmonic& limit, double start, double end, double velocity = 0);

  struct Phase {
    double start = 0;     // s
    int direction = 0;    // 0: stuck
    double position = 0;  // m, at the start
    double velocity = 0;  // m/s, at the start
  };
  [[nodiscard]] const std::vector<Phase>& phases() const { return phases_; }

  [[nodiscard]] double position(double t) const;
  [[nodiscard]] double velocity(double t) const;
  [[nodiscard]] double acceleration(double t) const;

 private:
  [[nodiscard]] const Phase& phase_at(double t) const;
  [[nodiscard]] double velocity_in(const Phase& phase, double t) const;
  [[nodiscard]] double position_in(const Phase& phase, double t) const;
  [[nodiscard]] int direction_from_rest(double t) const;
  [[nodiscard]] double end_of(const Phase& phase) const;

  Harmonic drive_;
  Harmonic limit_;
  double end_;
  std::vector<Phase> phases_;
};

}  // namespace exact
