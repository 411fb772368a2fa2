// Chords of curves and the lines that are drawn up to the curve, or a little past it.
#include "engine/drawing/straighten.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "engine/geometry/segment.h"

namespace dda {
namespace {

constexpr double reach = 1e-6;  // m

class Lots {
 public:
  explicit Lots(unsigned seed) : random_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

 private:
  std::mt19937_64 random_;
};

DrawnLine closed_curve(const DrawnCurve& curve) {
  DrawnLine line;
  line.start = curve.at(curve.from);
  line.pieces.push_back({line.start, std::make_shared<DrawnCurve>(curve)});
  return line;
}

DrawnLine straight(const Vec2& from, const Vec2& to) {
  DrawnLine line;
  line.start = from;
  line.pieces.push_back({to, nullptr});
  return line;
}

bool meets(const std::vector<Vec2>& chords, const Segment& line) {
  for (std::size_t i = 1; i < chords.size(); ++i) {
    if (distance(Segment{chords[i - 1], chords[i]}, line) <= reach) return true;
  }
  return false;
}

// An ellipse, and lines from outside of it that end past it by anything from nothing to as much as chords may leave it.
struct CrossedEllipse {
  LineDrawing drawing;
  double size = 0;

  explicit CrossedEllipse(unsigned seed) {
    Lots lots(seed);
    size = lots.between(1, 10);
    const double turn = lots.between(0, 6.28);
    const Vec2 u = size * Vec2(std::cos(turn), std::sin(turn));
    const Vec2 v = lots.between(0.4, 1) * Vec2(-u.y(), u.x());
    const DrawnCurve curve = elliptic_arc({lots.between(-9, 9), lots.between(-9, 9)}, u, v, 0, 2 * std::numbers::pi);
    drawing.lines.push_back(closed_curve(curve));
    for (int k = 0; k < 6; ++k) {
      const double parameter = k + lots.between(0.1, 0.9);
      const Vec2 place = curve.at(parameter);
      const Vec2 outwards = (std::cos(parameter) / u.squaredNorm() * u + std::sin(parameter) / v.squaredNorm() * v);
      const double lean = lots.between(-0.8, 0.8);
      const Vec2 along = Eigen::Rotation2D<double>(lean) * outwards.normalized();
      const double past = size * std::pow(10, lots.between(-9, -2));
      const Segment line{place - past * along, place + 3 * size * along};
      drawing.lines.push_back(k % 2 == 0 ? straight(line.start, line.end) : straight(line.end, line.start));
    }
  }
};

TEST(Straighten, LinesThatCrossACurveMeetItsChords) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("ellipse " + std::to_string(seed));
    const CrossedEllipse made(seed);
    const auto lines = straightened(made.drawing, {}, reach);
    for (std::size_t i = 1; i < lines.size(); ++i)
      EXPECT_TRUE(meets(lines[0], {lines[i].front(), lines[i].back()})) << "line " << i;
  }
}

TEST(Straighten, LinesThatEndShortOfACurveGiveItNoCorner) {
  const DrawnCurve curve = elliptic_arc({0, 0}, {5, 0}, {0, 5}, 0, 2 * std::numbers::pi);
  LineDrawing drawing;
  drawing.lines = {closed_curve(curve)};
  const std::size_t corners = straightened(drawing, {}, reach)[0].size();
  drawing.lines.push_back(straight({4.99, 0.5}, {1, 0.3}));
  drawing.lines.push_back(straight({0.5, 5.02}, {0.6, 9}));
  EXPECT_EQ(straightened(drawing, {}, reach)[0].size(), corners);
}

}  // namespace
}  // namespace dda
