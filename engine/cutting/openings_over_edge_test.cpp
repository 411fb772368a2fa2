// Openings that reach out of the rock take what of them lies in it. The oracle is the part of a turned rectangle in a
// square, clipped side by side (Sutherland and Hodgman 1974).
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "engine/cutting/cut_rock.h"
#include "engine/cutting/cutting_test_support.h"
#include "engine/cutting/opening_shapes.h"
#include "engine/geometry/rotation.h"

namespace dda {
namespace {

constexpr double size = 10;  // m, of the rock

// What of the ring lies where `inside` is not negative, which is linear.
template <typename Inside>
Ring clipped(const Ring& ring, const Inside& inside) {
  Ring part;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& from = ring[i];
    const Vec2& to = ring[(i + 1) % ring.size()];
    const double a = inside(from), b = inside(to);
    if (a >= 0) part.push_back(from);
    if ((a >= 0) != (b >= 0)) part.push_back(from + a / (a - b) * (to - from));
  }
  return part;
}

double area_in_rock(Ring ring) {
  for (const int axis : {0, 1}) {
    ring = clipped(ring, [axis](const Vec2& p) { return p(axis); });
    ring = clipped(ring, [axis](const Vec2& p) { return size - p(axis); });
  }
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& to = ring[(i + 1) % ring.size()];
    twice += ring[i].x() * to.y() - ring[i].y() * to.x();
  }
  return twice / 2;
}

struct Case {
  RockPlan plan;
  double area = 0;  // m2, of the opening in the rock
};

Case random_case(std::mt19937& random) {
  const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  Case made;
  made.plan = square_plan(size);
  for (int i = 0; i < 6; ++i)
    add_line(made.plan, {{between(-2, 12), between(-2, 12)}, {between(-2, 12), between(-2, 12)}});
  while (made.area < 0.01) {
    const double angle = between(0, std::numbers::pi);
    Ring outline = rectangle({0, 0}, between(1, 30), between(1, 8));
    const Vec2 centre(between(-4, 14), between(-4, 14));
    for (Vec2& corner : outline) corner = rotation(angle) * corner + centre;
    made.area = area_in_rock(outline);
    made.plan.openings = {{"bench", outline, "", false, "openings[0]"}};
  }
  return made;
}

TEST(OpeningsOverTheEdge, TakeWhatOfThemLiesInTheRock) {
  std::mt19937 random(19);
  for (int i = 0; i < 300; ++i) {
    Case each = random_case(random);
    if (each.area > 0.99 * size * size) continue;  // nothing would be left
    const CutRock kept = cut_rock(each.plan);
    double area = 0;
    for (const CutBlock& block : kept.blocks)
      if (block.opening == 0) area += area_moments(block.shape).area;
    // Slivers between an outline and a joint go to a neighbour, which may be on its other side: up to the tolerance of
    // 1e-6 of the diagonal along the way across the rock, a few times.
    EXPECT_NEAR(area, each.area, 1e-3) << i;
    EXPECT_NEAR(total_area(kept), size * size, 1e-10) << i;
    each.plan.openings[0].left_out = true;
    const CutRock without = cut_rock(each.plan);
    EXPECT_NEAR(without.left_out_area, each.area, 1e-9) << i;
    EXPECT_NEAR(total_area(without), size * size - each.area, 1e-9) << i;
  }
}

}  // namespace
}  // namespace dda
