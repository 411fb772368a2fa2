// A rigid block on a rough level plane, pulled by a spring whose far end moves on at constant speed V; one coefficient
// of friction, at rest and sliding. omega^2 = stiffness/mass, a = mu g. At time 0 the spring carries just what friction
// can hold, m a, and the block runs at v0 > 2 V in the direction of the pull. (Derived here.)
//
//   1. slides: x = V t + (v0 - V)/omega sin(omega t), until x' = 0 at cos(omega t1) = -V/(v0 - V)
//   2. sticks: the spring is short of m a by m omega (v0 - V) sin(omega t1), which takes (v0 - V) sin(omega t1)/(omega
//      V) to come back
//   3. slides: x' = V (1 - cos(omega (t - t2))) for ever, at rest for a moment after every period
//
// Precondition: omega (v0 - V) sin(omega t1) <= 2 a, or it would slide back after phase 1.
#pragma once

#include <cmath>

namespace exact {

class SpringPulledBlock {
 public:
  // Pull speed and velocity at time 0 in m/s, omega in rad/s.
  SpringPulledBlock(double pull_speed, double start_velocity, double omega)
      : pull_(pull_speed), swing_(start_velocity - pull_speed), omega_(omega) {
    stops_ = std::acos(-pull_ / swing_) / omega_;
    slips_again_ = stops_ + swing_ * std::sin(omega_ * stops_) / (omega_ * pull_);
  }

  [[nodiscard]] double stops_at() const { return stops_; }              // t1, s
  [[nodiscard]] double slips_again_at() const { return slips_again_; }  // t2, s

  [[nodiscard]] double velocity(double t) const {
    if (t < stops_) return pull_ + swing_ * std::cos(omega_ * t);
    return t < slips_again_ ? 0 : pull_ * (1 - std::cos(omega_ * (t - slips_again_)));
  }
  [[nodiscard]] double position(double t) const {
    if (t < stops_) return pull_ * t + swing_ / omega_ * std::sin(omega_ * t);
    const double stuck_at = pull_ * stops_ + swing_ / omega_ * std::sin(omega_ * stops_);
    if (t < slips_again_) return stuck_at;
    const double since = t - slips_again_;
    return stuck_at + pull_ * (since - std::sin(omega_ * since) / omega_);
  }
  // How far the spring's force per unit mass is below friction when the block sticks, m/s2.
  [[nodiscard]] double shortfall() const { return omega_ * swing_ * std::sin(omega_ * stops_); }

 private:
  double pull_;
  double swing_;  // v0 - V
  double omega_;
  double stops_ = 0;
  double slips_again_ = 0;
};

}  // namespace exact
