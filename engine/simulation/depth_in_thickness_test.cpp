// Blocks that have gone through another are known to have been deep in it, and those that have not are not.
#include "engine/simulation/depth_in_thickness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "engine/contact/make_contacts.h"
#include "engine/geometry/rotation.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

Ring convex_ring(std::mt19937& random) {
  std::uniform_real_distribution<double> angle(0, 2 * std::numbers::pi);
  std::vector<double> angles(7);
  std::ranges::generate(angles, [&] { return angle(random); });
  std::ranges::sort(angles);
  Ring ring;
  for (const double each : angles) ring.push_back({3 * std::cos(each), std::sin(each)});
  return ring;
}

// How far it is to the nearest of the lines that bound a convex block, along a ray that begins in it.
double nearest_line(const Ring& ring, const Vec2& from, const Vec2& along) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 edge = ring[(i + 1) % ring.size()] - ring[i];
    const Vec2 out(edge.y(), -edge.x());
    if (out.dot(along) > 1e-12 * edge.norm()) nearest = std::min(nearest, out.dot(ring[i] - from) / out.dot(along));
  }
  return nearest;
}

TEST(DepthInThickness, IsMeasuredStraightThroughTheBlock) {
  std::mt19937 random(3);
  for (int scene = 0; scene < 200; ++scene) {
    const Ring ring = convex_ring(random);
    const Model model = model_of({{ring, {}}});
    const State state = initial_state(model);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 from = ring[i], to = ring[(i + 1) % ring.size()];
      const Vec2 normal = Vec2((to - from).y(), -(to - from).x()).normalized();
      const Vec2 face = from + std::uniform_real_distribution(0.05, 0.95)(random) * (to - from);
      const double expected = nearest_line(ring, face, -normal);
      // Faces are given up to what contacts are closed by, on either side.
      for (const double off : {-1e-6, 0.0, 1e-6})
        EXPECT_NEAR(thickness_behind(model, state, 0, face + off * normal, normal), expected + off, 1e-9)
            << scene << ", edge " << i;
    }
  }
}

// A block that falls corner first on a plate which does not move.
Simulation thrown(double thickness, double speed, double young) {
  Ring ring = box_ring(-0.1, -0.1, 0.1, 0.1);
  for (Vec2& vertex : ring) vertex = rotation(0.7) * vertex + Vec2(0, 0.16);
  Model model =
      model_of({{box_ring(-1.1, -thickness, 1.1, 0), {}}, {ring, {}}}, {"rock", 2600, young, 0.2, PlaneState::stress});
  model.held_blocks.emplace_back().block = 0;
  model.joints[0].law = InterfaceLaw::classical;
  model.blocks[1].initial_velocity = {0, -speed};
  model.stages = {
      stage_of(generalized_alpha_integrator(0), 5e-5, static_cast<int>(15 / speed / 5e-4), Kinematics::finite)};
  return simulation_of(std::move(model));
}

// A needle under a block, pressed in evenly by 0.1 mm: at the tip that is more than all there is of it. Of the block,
// which is thick, it is less.
TEST(DepthInThickness, OfNeedlesIsNotThatAtTheirTips) {
  for (const double height : {0.1, 0.01, 0.001}) {
    Model model = model_of({{{{0, 0}, {1, 0}, {0, height}}, {}}, {{{1, 0}, {1, 1}, {0, 1}, {0, height}}, {}}});
    model.joints[0].law = InterfaceLaw::classical;
    finish_model(model);
    const State state = initial_state(model);
    ContactSet contacts = make_contacts(model);
    ASSERT_EQ(contacts.interfaces.size(), 1U);
    for (const int row : {0, 2}) contacts.states[0].gap(row) = -1e-4;
    DepthInThickness deepest;
    const std::vector<double> widths(2, 0.0);
    note_depths_in_thickness(model, state, contacts, {widths, 0}, {}, deepest);
    if (height > 0.01) {  // less than a thousandth of its side, which is the root of half its height times its length
      EXPECT_EQ(deepest.share, 0) << height;
    } else {
      // Straight through from the slope a tenth of it towards the thick end. As the slope has not moved here, the face
      // is taken to be 0.1 mm before the corner.
      const double middle = 0.6 * height * std::hypot(1, height) + 1e-4;
      EXPECT_NEAR(deepest.share, 1e-4 / middle, 1e-3 * 1e-4 / middle) << height;
    }
  }
}

// The oracle is where the block ends: below a plate that neither moves nor breaks.
TEST(DepthInThickness, OfBlocksThatHavePassedIsMoreThanHalf) {
  std::mt19937 random(11);
  const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  int passed = 0, stayed_and_shallow = 0;
  for (int scene = 0; scene < 200; ++scene) {
    const double thickness = std::pow(10, number(-3, -0.7)), young = std::pow(10, number(7.5, 10));
    const double waves = std::sqrt(young / 2600);  // at their speed a block is squashed, and means nothing
    const double speed = std::min(std::pow(10, number(0.3, 2)), 0.4 * waves);
    Simulation simulation = thrown(thickness, speed, young);
    while (!simulation.finished())
      if (simulation.step() != Status::ok) break;
    const double share = simulation.deepest_penetration().in_thickness.share;
    const bool is_below = 0.16 + simulation.state().displacement[1](1) < -thickness;
    passed += is_below;
    stayed_and_shallow += !is_below && share < passing_share;
    if (is_below) {
      EXPECT_GT(share, passing_share) << "scene " << scene << ": " << thickness << " m, " << speed << " m/s";
    }
  }
  EXPECT_GE(passed, 5);  // or the test says nothing
  EXPECT_GE(stayed_and_shallow, 100);
}

}  // namespace
}  // namespace dda
