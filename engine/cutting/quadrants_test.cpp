#include "engine/cutting/quadrants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace dda {
namespace {

constexpr double size = 1e9;  // pixels

Pixel pixel(double x, double y) {
  return {static_cast<std::int64_t>(std::llround(x * size)), static_cast<std::int64_t>(std::llround(y * size))};
}

// Through a square of side 1, parallel but for `scatter` of their direction.
std::vector<Piece> joint_set(int count, double slope, double scatter) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> aside(-scatter, scatter);
  std::vector<Piece> pieces;
  for (int i = 0; i < count; ++i) {
    const double start = static_cast<double>(i) / count;
    pieces.push_back({{pixel(0, start), pixel(1, start + slope + aside(random))}, i});
  }
  return pieces;
}

struct Seen {
  std::size_t compared = 0;
  std::set<std::pair<int, int>> crossings;
};

Seen look_at(const std::vector<Piece>& pieces) {
  Seen seen;
  visit_crowds(pieces, [&](std::size_t, const Quadrant& quadrant, std::span<const NearPiece> crowd) {
    seen.compared += crowd.size() * (crowd.size() - 1) / 2;
    for (const NearPiece& a : crowd) {
      for (const NearPiece& b : crowd) {
        const auto met = crossing(a.segment, b.segment);
        if (a.piece < b.piece && met && quadrant.holds(*met)) seen.crossings.insert({a.piece, b.piece});
      }
    }
  });
  return seen;
}

std::set<std::pair<int, int>> brute_force(const std::vector<Piece>& pieces) {
  std::set<std::pair<int, int>> crossings;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t j = i + 1; j < pieces.size(); ++j) {
      if (crossing(pieces[i].segment, pieces[j].segment)) crossings.insert({static_cast<int>(i), static_cast<int>(j)});
    }
  }
  return crossings;
}

// All of them lie in all squares along them: 100 comparisons of each at this number, and twice as many at twice that.
TEST(Crowds, OneJointSetIsComparedWithNeighboursOnly) {
  for (const double slope : {1.0, 0.3, -2.0}) {
    constexpr std::size_t count = 4000;
    EXPECT_LT(look_at(joint_set(count, slope, 0)).compared, 60 * count) << slope;
  }
}

TEST(Crowds, CrossingsOfASetThatIsNotQuiteParallel) {
  for (const double scatter : {1e-4, 1e-3, 1e-2, 0.1, 1.0}) {
    const std::vector<Piece> pieces = joint_set(600, 0.7, scatter);
    EXPECT_EQ(look_at(pieces).crossings, brute_force(pieces)) << scatter;
  }
}

TEST(Crowds, CrossingsOfASetWithOthers) {
  std::vector<Piece> pieces = joint_set(400, 0.7, 1e-3);
  for (const Piece& each : joint_set(60, -0.5, 0.2)) pieces.push_back({each.segment, 400 + each.straight});
  pieces.push_back({{pixel(0.2, 0.1), pixel(0.21, 1.2)}, 460});
  EXPECT_EQ(look_at(pieces).crossings, brute_force(pieces));
}

// Ends of many lines on one pixel come up as that many nodes.
TEST(Meetings, NodesOnOnePixel) {
  std::vector<Piece> pieces = joint_set(40, 0.7, 1.0);
  const Pixel place = pieces.front().segment.to;
  for (int i = 0; i < 40; ++i) pieces.push_back({{pixel(0.02 * i, 0.9), place}, 40 + i});
  const std::vector<Pixel> nodes(60, place);
  std::vector<std::set<int>> met(nodes.size());
  visit_meetings(pieces, nodes, 2, [&](std::size_t, std::span<const NearPiece> crowd, std::span<const NearNode> near) {
    for (const NearNode& node : near) {
      for (const NearPiece& each : crowd) met[static_cast<std::size_t>(node.node)].insert(each.piece);
    }
  });
  for (const std::set<int>& each : met) {
    EXPECT_TRUE(each.contains(0));
    for (int i = 40; i < 80; ++i) EXPECT_TRUE(each.contains(i)) << i;
  }
}

// A tolerance may be anything, so that a reach may lead beyond the integers.
TEST(Meetings, BeyondTheGridAllAreNear) {
  const std::vector<Piece> pieces = joint_set(20, 0.7, 1.0);
  const std::vector<Pixel> nodes{pixel(0.5, 0.5), pixel(-900, 900)};
  for (const double reach : {1e14, 9.2e18, 1e300, std::numeric_limits<double>::infinity()}) {
    std::size_t pairs = 0;
    visit_meetings(pieces, nodes, reach,
                   [&](std::size_t, std::span<const NearPiece> crowd, std::span<const NearNode> near) {
                     pairs += crowd.size() * near.size();
                   });
    EXPECT_EQ(pairs, pieces.size() * nodes.size()) << reach;
  }
}

}  // namespace
}  // namespace dda
