#include "engine/cutting/delaunay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/cutting/cutting_test_support.h"

namespace dda {
namespace {

std::vector<Pixel> random_sites(Lots& lots, int count, int extent) {
  std::vector<Pixel> sites;
  for (int i = 0; i < count; ++i) sites.push_back({lots.whole(-extent, extent), lots.whole(-extent, extent)});
  return sites;
}

// By the determinant of 4 rows (x, y, x2 + y2, 1), in whole numbers; written without the code under test.
bool inside_circle(const Pixel& a, const Pixel& b, const Pixel& c, const Pixel& d) {
  const auto row = [&](const Pixel& p) {
    const Wide x = p.x - d.x;
    const Wide y = p.y - d.y;
    return std::array<Wide, 3>{x, y, x * x + y * y};
  };
  const auto p = row(a);
  const auto q = row(b);
  const auto r = row(c);
  return p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0]) + p[2] * (q[0] * r[1] - q[1] * r[0]) >
         0;
}

void expect_delaunay(const std::vector<Pixel>& sites) {
  const Delaunay delaunay(sites);
  const std::set<Pixel> places(sites.begin(), sites.end());
  std::set<Pixel> seen;
  for (const DelaunayTriangle& triangle : delaunay.triangles()) {
    const bool inner = std::all_of(triangle.corners.begin(), triangle.corners.end(),
                                   [&](int corner) { return delaunay.is_site(corner); });
    for (const int corner : triangle.corners) {
      if (delaunay.is_site(corner)) seen.insert(sites[static_cast<std::size_t>(corner)]);
    }
    if (!inner) continue;
    const auto at = [&](std::size_t i) { return sites[static_cast<std::size_t>(triangle.corners[i])]; };
    EXPECT_GT(turn(at(0), at(1), at(2)), 0);
    for (const Pixel& other : places) EXPECT_FALSE(inside_circle(at(0), at(1), at(2), other));
  }
  EXPECT_EQ(seen, places);
  EXPECT_EQ(delaunay.triangles().size(), 2 * places.size() + 1);  // Euler: 2 n + 1 within a triangle
}

TEST(Delaunay, NoSiteLiesInACircle) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Lots lots(seed);
    expect_delaunay(random_sites(lots, lots.whole(1, 120), static_cast<int>(farthest_site)));
  }
}

// On a coarse grid most sites are doubled, in a row, or on a circle with others.
TEST(Delaunay, NorOnACoarseGrid) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Lots lots(seed);
    expect_delaunay(random_sites(lots, lots.whole(1, 150), lots.whole(1, 6)));
  }
}

TEST(Delaunay, CircumcentresAreAsFarFromAllCorners) {
  Lots lots(3);
  const std::vector<Pixel> sites = random_sites(lots, 200, static_cast<int>(farthest_site));
  const Delaunay delaunay(sites);
  for (const DelaunayTriangle& triangle : delaunay.triangles()) {
    if (!std::all_of(triangle.corners.begin(), triangle.corners.end(), [&](int c) { return delaunay.is_site(c); }))
      continue;
    const Vec2 centre = delaunay.circumcentre(triangle);
    const auto away = [&](std::size_t i) {
      const Pixel& p = sites[static_cast<std::size_t>(triangle.corners[i])];
      return (centre - Vec2(static_cast<double>(p.x), static_cast<double>(p.y))).norm();
    };
    const double tolerance = 1e-15 * centre.norm() + 1e-7;  // round-off of 2^27, and of a far centre
    EXPECT_NEAR(away(0), away(1), 4 * tolerance);
    EXPECT_NEAR(away(0), away(2), 4 * tolerance);
  }
}

}  // namespace
}  // namespace dda
