#include "engine/model/extent.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/geometry/rotation.h"

namespace dda {
namespace {

// Two boxes side by side, 3 m long, and one on top of the first: from its upper left corner to the lower right one.
TEST(Extent, DiameterIsTheSameWhicheverWayTheSceneIsTurned) {
  for (const double angle : {0.0, 0.3, 1.5, -2.0}) {
    Model model;
    for (const Ring& drawn : {Ring{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, Ring{{2, 0}, {3, 0}, {3, 1}, {2, 1}},
                              Ring{{0, 1}, {2, 1}, {2, 2}, {0, 2}}}) {
      Ring& ring = model.blocks.emplace_back().shape.outer;
      for (const Vec2& corner : drawn) ring.emplace_back(rotation(angle) * corner);
    }
    EXPECT_NEAR(diameter(model), std::hypot(3, 2), 1e-12) << angle;
  }
}

}  // namespace
}  // namespace dda
