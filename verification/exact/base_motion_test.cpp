#include "verification/exact/base_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace exact {
namespace {

const Accelerogram quake{{0, 0.3, 0.5, 1.1, 1.3}, {0, 2, -3, 1, 0.5}};

// Simpson's rule between the samples is exact for cubics; in pieces of 1e-3 of an interval good to 1e-12 for sines.
template <typename Function>
double integral(const Function& f, double from, double to) {
  constexpr int pieces = 2000;
  const double h = (to - from) / pieces;
  double sum = 0;
  for (int i = 0; i < pieces; ++i)
    sum += (f(from + i * h) + 4 * f(from + (i + 0.5) * h) + f(from + (i + 1) * h)) * h / 6;
  return sum;
}

double acceleration(double t) {
  for (std::size_t i = 1; i < quake.times.size(); ++i)
    if (t <= quake.times[i]) {
      const double share = (t - quake.times[i - 1]) / (quake.times[i] - quake.times[i - 1]);
      return quake.values[i - 1] + share * (quake.values[i] - quake.values[i - 1]);
    }
  return 0;
}

// Up to `to` or the end of the record.
template <typename Function>
double integral_over_record(const Function& f, double to) {
  double sum = 0;
  for (std::size_t i = 1; i < quake.times.size() && quake.times[i - 1] < to; ++i)
    sum += integral(f, quake.times[i - 1], std::min(to, quake.times[i]));
  return sum;
}

// u = integral of (t - s) a(s) ds, v = integral of a.
TEST(BaseMotion, IsTheIntegralOfTheRecord) {
  for (const double t : {0.1, 0.3, 0.4, 0.9, 1.3, 1.8}) {
    const double u = integral_over_record([t](double s) { return (t - s) * acceleration(s); }, t);
    EXPECT_NEAR(base_motion(quake, t).velocity, integral_over_record(acceleration, t), 1e-12);
    EXPECT_NEAR(base_motion(quake, t).displacement, u, 1e-12);
  }
}

// Duhamel: u = -1/omega integral of a(s) sin(omega (t - s)) ds.
TEST(OscillatorOnBase, IsDuhamelsIntegral) {
  for (const double omega : {0.7, 6.0, 40.0})
    for (const double t : {0.1, 0.4, 0.9, 1.3, 1.8}) {
      const BaseMotion motion = oscillator_on_base(quake, omega, t);
      const auto displacement = [&](double s) { return -acceleration(s) * std::sin(omega * (t - s)) / omega; };
      const auto velocity = [&](double s) { return -acceleration(s) * std::cos(omega * (t - s)); };
      EXPECT_NEAR(motion.displacement, integral_over_record(displacement, t), 1e-11);
      EXPECT_NEAR(motion.velocity, integral_over_record(velocity, t), 1e-11);
    }
}

}  // namespace
}  // namespace exact
