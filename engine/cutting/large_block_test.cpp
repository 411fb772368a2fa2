// Looking at what is near a corner that moved says the same as looking at the whole block.
#include "engine/cutting/large_block.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/cutting/cutting_test_support.h"

namespace dda {
namespace {

// A ragged round block with ragged islands, drawn node after node.
struct Lace {
  std::vector<Vec2> places;
  NodeRings rings;

  void add_ring(const Vec2& centre, double radius, int corners, bool outer, Lots& lots) {
    NodeRing& ring = rings.emplace_back();
    for (int i = 0; i < corners; ++i) {
      const double angle = (outer ? 1 : -1) * 2 * std::numbers::pi * (i + lots.between(0, 0.8)) / corners;
      ring.push_back(static_cast<int>(places.size()));
      places.push_back(centre + radius * lots.between(0.7, 1) * Vec2(std::cos(angle), std::sin(angle)));
    }
  }
};

Lace random_lace(Lots& lots) {
  Lace lace;
  lace.add_ring({0, 0}, 10, lots.whole(30, 120), true, lots);
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y)
      lace.add_ring(Vec2(2 * x, 2 * y), lots.between(0.01, 0.99), lots.whole(3, 9), false, lots);
  }
  return lace;
}

// Most moves are to the next corner of a ring, as those of short edges are; some go anywhere.
std::pair<int, int> random_nodes(const Lace& lace, const CornerPlaces& places, Lots& lots) {
  const auto count = static_cast<int>(lace.places.size());
  if (lots.whole(0, 9) == 0) return {places.node(lots.whole(0, count - 1)), places.node(lots.whole(0, count - 1))};
  const NodeRing& ring = lace.rings[static_cast<std::size_t>(lots.whole(0, static_cast<int>(lace.rings.size()) - 1))];
  const auto i = static_cast<std::size_t>(lots.whole(0, static_cast<int>(ring.size()) - 1));
  return {places.node(ring[i]), places.node(ring[(i + 1) % ring.size()])};
}

TEST(LargeBlock, SaysWhatTheWholePolygonSaysMoveByMove) {
  int sound = 0;
  int unsound = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Lots lots(seed);
    const Lace lace = random_lace(lots);
    CornerPlaces places(lace.places);
    ASSERT_FALSE(defect(polygon_of(lace.rings, places)));
    LargeBlock block(lace.rings, places);
    for (int i = 0; i < 100; ++i) {
      const auto [node, into] = random_nodes(lace, places, lots);
      if (node == into) continue;
      const double share = lots.whole(0, 2) / 2.0;
      const Vec2 goal = (1 - share) * places.position(node) + share * places.position(into);
      const CornerMove move{into, goal, places.position(node), places.position(into)};
      const auto undo = places.close(node, into, goal);
      const bool expected = !defect(polygon_of(lace.rings, places));
      ASSERT_EQ(block.is_sound_after(move), expected) << "move " << i;
      ++(expected ? sound : unsound);
      if (!expected || lots.whole(0, 3) == 0) undo();
    }
  }
  EXPECT_GT(sound, 500);
  EXPECT_GT(unsound, 500);
}

// Corners of short edges, each moved by far less than the size of what is around it.
TEST(LargeBlock, SmallMovesNeedNoLookAtTheWhole) {
  Lots lots(1);
  Lace lace = random_lace(lots);
  NodeRing& outer = lace.rings.front();
  const auto corners = static_cast<int>(outer.size());
  for (int i = corners; i > 0; --i) {
    const auto next = static_cast<std::size_t>(i % corners);
    const Vec2 corner = lace.places[static_cast<std::size_t>(outer[static_cast<std::size_t>(i - 1)])];
    const Vec2 to_next = lace.places[static_cast<std::size_t>(outer[next])] - corner;
    outer.insert(outer.begin() + i, static_cast<int>(lace.places.size()));
    lace.places.emplace_back(corner + 1e-6 * to_next.normalized());
  }
  CornerPlaces places(lace.places);
  LargeBlock block(lace.rings, places);
  int moves = 0;
  for (std::size_t i = 0; i < outer.size(); i += 2) {
    const CornerMove move{outer[i], places.position(outer[i]), places.position(outer[i + 1]),
                          places.position(outer[i])};
    places.close(outer[i + 1], outer[i], move.position);
    EXPECT_TRUE(block.is_sound_after(move));
    ++moves;
  }
  EXPECT_EQ(moves, corners);
  EXPECT_EQ(block.looked_at_whole(), 1);  // before the first
}

}  // namespace
}  // namespace dda
