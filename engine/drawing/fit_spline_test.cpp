// Curves through fit points against curves that are known.
#include "engine/drawing/fit_spline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace dda {
namespace {

Vec2 at(const std::vector<DrawnCurve>& spans, double parameter) {
  for (const DrawnCurve& span : spans) {
    if (parameter <= span.to) return span.at(parameter);
  }
  return spans.back().at(spans.back().to);
}

Vec2 cubic(double t) { return {t * t * t - 2 * t * t + 0.5, -0.25 * t * t * t + 3 * t}; }
Vec2 slope_of_cubic(double t) { return {3 * t * t - 4 * t, -0.75 * t * t + 3}; }

// A cubic is the only curve of that kind through its points with its slopes at the ends; what is left is round-off of
// numbers up to 30, in a system whose rows are dominant.
TEST(FitSpline, ReproducesACubicWhoseEndSlopesAreGiven) {
  const std::vector<double> parameters{-1, -0.2, 0.3, 1.1, 1.7, 3};
  std::vector<Vec2> points;
  for (const double t : parameters) points.push_back(cubic(t));
  const auto spans = spans_of(cubic_through(points, parameters, {slope_of_cubic(-1), slope_of_cubic(3), false}));
  ASSERT_EQ(spans.size(), 5U);
  for (double t = -1; t <= 3; t += 0.01) EXPECT_LE((at(spans, t) - cubic(t)).norm(), 1e-13) << t;
}

// With natural ends the second derivative is nothing there, and in between it does not jump. Differences over 1e-4 of
// second derivatives of about 1 err by 1e-4 of the third.
TEST(FitSpline, IsSmoothAndUnbentAtFreeEnds) {
  const auto spline = fit_spline({{0, 0}, {1, 2}, {3, 1}, {4, 4}, {7, 3}}, {});
  ASSERT_TRUE(spline);
  const auto spans = spans_of(*spline);
  constexpr double h = 1e-4;
  const auto bend = [&](const DrawnCurve& span, double t) -> Vec2 {
    return (span.at(t - h) - 2 * span.at(t) + span.at(t + h)) / (h * h);
  };
  EXPECT_LE(bend(spans.front(), spans.front().from + h).norm(), 1e-3);
  EXPECT_LE(bend(spans.back(), spans.back().to - h).norm(), 1e-3);
  for (std::size_t i = 1; i < spans.size(); ++i)
    EXPECT_LE((bend(spans[i - 1], spans[i - 1].to - h) - bend(spans[i], spans[i].from + h)).norm(), 2e-3);
}

// Spline interpolation errs by 5/384 h^4 of the fourth derivative, which of a circle by its angle is the radius; chords
// as parameter are angles but for a factor.
TEST(FitSpline, PointsOfACircleGiveACircle) {
  constexpr double radius = 2;
  for (const int count : {8, 16, 64}) {
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count;
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    const auto spline = fit_spline(points, {{}, {}, true});
    ASSERT_TRUE(spline);
    const double h = 2 * std::numbers::pi / count;
    const double allowed = 5.0 / 384 * std::pow(h, 4) * radius;
    const auto spans = spans_of(*spline);
    const double length = spans.back().to;
    for (int i = 0; i <= 1000; ++i) EXPECT_NEAR(at(spans, length * i / 1000).norm(), radius, allowed) << count;
  }
}

TEST(FitSpline, PassesThroughEveryPointWithTheDirectionsGiven) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> lot(-5, 5);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Vec2> points;
    for (int i = 0; i < 3 + trial % 20; ++i) points.emplace_back(lot(random), lot(random));
    FitEnds ends;
    ends.closed = trial % 3 == 0;
    if (trial % 3 == 1) ends.start = Vec2(lot(random), lot(random));
    const auto spline = fit_spline(points, ends);
    ASSERT_TRUE(spline);
    const auto spans = spans_of(*spline);
    ASSERT_EQ(spans.size(), points.size() - (ends.closed ? 0 : 1));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 there = i < spans.size() ? spans[i].at(spans[i].from) : spans.back().at(spans.back().to);
      EXPECT_LE((there - points[i]).norm(), 1e-13);  // round-off of coordinates up to 5
    }
    if (!ends.start) continue;
    constexpr double h = 1e-7;  // of chords of 0.01 and more, so the difference errs by 1e-5 at most
    const Vec2 way = spans[0].at(h) - spans[0].at(0);
    EXPECT_GE(way.normalized().dot(ends.start->normalized()), 1 - 1e-6);
  }
}

TEST(FitSpline, PointsThatRepeatCountOnce) {
  EXPECT_FALSE(fit_spline({{1, 1}, {1, 1}}, {}));
  EXPECT_FALSE(fit_spline({{0, 0}, {0, 0}, {0, 0}}, {Vec2(1, 0), {}, false}));
  EXPECT_EQ(fit_spline({{0, 0}, {0, 1e-310}, {1, 0}}, {})->points.size(), 4U);
  EXPECT_FALSE(fit_spline({{0, 0}, {1, 1}, {0, 0}}, {{}, {}, true}));
  const auto spline = fit_spline({{0, 0}, {0, 0}, {3, 4}, {3, 4}}, {});
  ASSERT_TRUE(spline);
  EXPECT_EQ(spans_of(*spline).size(), 1U);
  EXPECT_EQ(spline->knots.back(), 5);
}

}  // namespace
}  // namespace dda
