#include "verification/exact/coulomb_sliding.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace exact {
namespace {

constexpr double no_event = std::numeric_limits<double>::infinity();

// Samples between two of which a sign change is looked for: a slip that is shorter is missed.
constexpr int samples_per_period = 4000;

// A block exactly at its limit, but for round-off, starts to slide if the drive outgrows the limit.
constexpr double round_off = 1e-12;

// First t in (from, to] at which f, positive right after `from`, is no longer so.
template <typename Function>
double first_root(const Function& f, double from, double to, double step) {
  for (double low = from; low < to; low += step) {
    double high = std::min(low + step, to);
    if (f(high) > 0) continue;
    for (int i = 0; i < 200; ++i) {
      const double middle = (low + high) / 2;
      (f(middle) > 0 ? low : high) = middle;
    }
    return high;
  }
  return no_event;
}

double step_of(const Harmonic& a, const Harmonic& b, double duration) {
  const double omega = std::max(a.amplitude != 0 ? a.omega : 0, b.amplitude != 0 ? b.omega : 0);
  const double period = omega > 0 ? 2 * std::numbers::pi / omega : duration;
  return std::min(period, duration) / samples_per_period;
}

}  // namespace

double Harmonic::at(double t) const { return mean + amplitude * std::sin(omega * t + phase); }

double Harmonic::integral(double from, double to) const {
  const double steady = mean * (to - from);
  if (amplitude == 0) return steady;
  return steady - amplitude / omega * (std::cos(omega * to + phase) - std::cos(omega * from + phase));
}

double Harmonic::double_integral(double from, double to) const {
  const double duration = to - from;
  const double steady = mean * duration * duration / 2;
  if (amplitude == 0) return steady;
  return steady + amplitude / omega * duration * std::cos(omega * from + phase) -
         amplitude / (omega * omega) * (std::sin(omega * to + phase) - std::sin(omega * from + phase));
}

InclineForces incline_forces(double gravity, double slope, double friction_angle, const Harmonic& shaking) {
  InclineForces forces{shaking, shaking};
  const double along = std::cos(slope);
  const double normal = std::sin(slope);
  const double friction = std::tan(friction_angle);
  forces.drive.mean = gravity * std::sin(slope) + along * shaking.mean;
  forces.drive.amplitude = along * shaking.amplitude;
  forces.limit.mean = friction * (gravity * std::cos(slope) - normal * shaking.mean);
  forces.limit.amplitude = -friction * normal * shaking.amplitude;
  return forces;
}

CoulombSlider::CoulombSlider(const Harmonic& drive, const Harmonic& limit, double start, double end, double velocity)
    : drive_(drive), limit_(limit), end_(end) {
  Phase phase{start, velocity > 0 ? 1 : -1, 0, velocity};
  if (velocity == 0) phase.direction = direction_from_rest(start);
  while (true) {
    phases_.push_back(phase);
    const double over = end_of(phase);
    if (!(over < end_)) return;
    phase = {over, 0, position_in(phase, over), 0};
    phase.direction = direction_from_rest(over);
    // Stuck and released at the same moment: it slides on the side on which the limit was reached.
    if (phases_.back().direction == 0 && phase.direction == 0) phase.direction = drive_.at(over) > 0 ? 1 : -1;
  }
}

int CoulombSlider::direction_from_rest(double t) const {
  const double drive = drive_.at(t);
  if (std::abs(drive) <= limit_.at(t) * (1 + round_off)) return 0;
  return drive > 0 ? 1 : -1;
}

double CoulombSlider::end_of(const Phase& phase) const {
  const double step = step_of(drive_, limit_, end_ - phase.start);
  if (phase.direction == 0)
    return first_root([this](double t) { return limit_.at(t) - std::abs(drive_.at(t)); }, phase.start, end_, step);
  return first_root([&](double t) { return phase.direction * velocity_in(phase, t); }, phase.start, end_, step);
}

const CoulombSlider::Phase& CoulombSlider::phase_at(double t) const {
  const auto after =
      std::upper_bound(phases_.begin(), phases_.end(), t, [](double time, const Phase& p) { return time < p.start; });
  return after == phases_.begin() ? *after : *(after - 1);
}

double CoulombSlider::velocity_in(const Phase& phase, double t) const {
  if (phase.direction == 0) return 0;
  return phase.velocity + drive_.integral(phase.start, t) - phase.direction * limit_.integral(phase.start, t);
}

double CoulombSlider::position_in(const Phase& phase, double t) const {
  if (phase.direction == 0) return phase.position;
  return phase.position + phase.velocity * (t - phase.start) + drive_.double_integral(phase.start, t) -
         phase.direction * limit_.double_integral(phase.start, t);
}

double CoulombSlider::position(double t) const { return position_in(phase_at(t), t); }

double CoulombSlider::velocity(double t) const { return velocity_in(phase_at(t), t); }

double CoulombSlider::acceleration(double t) const {
  const Phase& phase = phase_at(t);
  return phase.direction == 0 ? 0 : drive_.at(t) - phase.direction * limit_.at(t);
}

}  // namespace exact
