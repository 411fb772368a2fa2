// For programs that only use others' libraries: the dry brick wall of ci/compare-peers, 1 x 0.5 m bricks in running
// bond.
#pragma once

#include <algorithm>
#include <cmath>
#include <ctime>
#include <vector>

namespace peers {

constexpr double brick_height = 0.5, density = 2600, gravity = 9.81, friction = 0.6;

struct Brick {
  double x, y, width;  // of its middle
};

// Every second course begins and ends with half a brick.
inline std::vector<Brick> wall_of(int side) {
  std::vector<Brick> bricks;
  for (int row = 0; row < side; ++row) {
    const double y = brick_height * (row + 0.5);
    const bool shifted = row % 2 == 1;
    if (shifted) bricks.push_back({0.25, y, 0.5});
    for (int i = 0; i < side - (shifted ? 1 : 0); ++i) bricks.push_back({i + (shifted ? 1.0 : 0.5), y, 1});
    if (shifted) bricks.push_back({side - 0.25, y, 0.5});
  }
  return bricks;
}

inline double seconds_since(std::clock_t begin) { return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC; }

}  // namespace peers
