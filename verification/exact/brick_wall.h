// Settlement of a dry brick wall in running bond under its own weight, by hand.
#pragma once

namespace exact {

struct BrickWall {
  int rows = 0;
  double brick_width = 0, brick_height = 0;  // m
  double unit_weight = 0;                    // N/m3
  double young = 0;                          // Pa, plane stress
  double corner_spring = 0;                  // N/m per m of thickness, of each contact of a corner with an edge
};

// Settlement of the centroids of the top row against the ground (m). Row i, counted from 0 below, carries in its middle
// the stress unit_weight h (rows - i - 1/2). In a bed joint every half brick has two corners in contact, so 4 springs a
// brick carry the rows above; on the ground the corners of the bricks alone are in contact, 2 a brick.
inline double settlement(const BrickWall& wall) {
  const double row = wall.unit_weight * wall.brick_height;  // Pa
  const double on_a_spring = row * wall.brick_width / wall.corner_spring;
  double sum = wall.rows * on_a_spring / 2;
  for (int i = 0; i < wall.rows; ++i) {
    const bool top = i == wall.rows - 1;
    sum += (top ? 0.5 : 1.0) * wall.brick_height * row * (wall.rows - i - 0.5) / wall.young;
    if (i > 0) sum += (wall.rows - i) * on_a_spring / 4;
  }
  return sum;
}

}  // namespace exact
