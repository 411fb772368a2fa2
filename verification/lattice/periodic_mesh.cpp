#include "verification/lattice/periodic_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <utility>

namespace verify {
namespace {

constexpr int voronoi_side = 4;  // m, and blocks

// Least distance of two points whose pattern repeats itself.
double periodic_distance(const dda::Vec2& a, const dda::Vec2& b) {
  const auto wrapped = [](double x) { return x - voronoi_side * std::round(x / voronoi_side); };
  return std::hypot(wrapped(a.x() - b.x()), wrapped(a.y() - b.y()));
}

std::vector<dda::Vec2> scattered_points(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, voronoi_side);
  std::vector<dda::Vec2> points;
  while (points.size() < voronoi_side * voronoi_side) {
    const double x = place(random);
    const dda::Vec2 point(x, place(random));
    const bool clear = std::ranges::all_of(points, [&](const auto& p) { return periodic_distance(p, point) > 0.55; });
    if (clear) points.push_back(point);
  }
  return points;
}

}  // namespace

dda::Vec2 translation(const PeriodicMesh& mesh, int cell) {
  return (cell / 3 - 1) * mesh.first + (cell % 3 - 1) * mesh.second;
}

double PeriodicMesh::longest_side() const {
  double longest = 0;
  for (const dda::Ring& ring : cell)
    for (std::size_t i = 0; i < ring.size(); ++i)
      longest = std::max(longest, (ring[(i + 1) % ring.size()] - ring[i]).norm());
  return longest;
}

PeriodicMesh square_mesh() { return {{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, {1, 0}, {0, 1}}; }

PeriodicMesh brick_mesh() {
  return {{{{0, 0}, {1, 0}, {1, 0.5}, {0, 0.5}}, {{0.5, 0.5}, {1.5, 0.5}, {1.5, 1}, {0.5, 1}}}, {1, 0}, {0, 1}};
}

PeriodicMesh sheared_mesh() {
  const dda::Vec2 up(std::sin(std::numbers::pi / 6), std::cos(std::numbers::pi / 6));
  return {{{{0, 0}, {1, 0}, dda::Vec2(1, 0) + up, up}}, {1, 0}, up};
}

PeriodicMesh triangle_mesh() { return {{{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 1}}}, {1, 0}, {0, 1}}; }

PeriodicMesh irregular_mesh(unsigned seed) {
  constexpr int side = 4;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-0.2, 0.2);
  std::vector<dda::Vec2> shifts;
  for (int i = 0; i < side * side; ++i) {
    const double x = shift(random);
    shifts.emplace_back(x, shift(random));
  }
  const auto corner = [&](int i, int j) -> dda::Vec2 {
    const int index = (i % side) * side + j % side;
    return dda::Vec2(i, j) + shifts[static_cast<std::size_t>(index)];
  };
  PeriodicMesh mesh{{}, {side, 0}, {0, side}};
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      mesh.cell.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
  return mesh;
}

dda::Ring nearer_part(const dda::Ring& ring, const dda::Vec2& own, const dda::Vec2& other) {
  const dda::Vec2 outward = other - own;
  const auto beyond = [&](const dda::Vec2& p) { return outward.dot(p - (own + other) / 2); };
  dda::Ring kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const dda::Vec2& from = ring[i];
    const dda::Vec2& to = ring[(i + 1) % ring.size()];
    const double a = beyond(from);
    const double b = beyond(to);
    if (a <= 0) kept.push_back(from);
    if ((a < 0 && b > 0) || (a > 0 && b < 0)) kept.push_back(from + a / (a - b) * (to - from));
  }
  return kept;
}

PeriodicMesh voronoi_mesh(unsigned seed) {
  const std::vector<dda::Vec2> points = scattered_points(seed);
  PeriodicMesh mesh{{}, {voronoi_side, 0}, {0, voronoi_side}};
  for (const dda::Vec2& own : points) {
    dda::Ring ring;
    for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
      ring.push_back(own + voronoi_side / 2.0 * dda::Vec2(x, y));
    for (const dda::Vec2& other : points)
      for (int cell = 0; cell < 9; ++cell) {
        const dda::Vec2 image = other + translation(mesh, cell);
        if (image != own) ring = nearer_part(ring, own, image);
      }
    mesh.cell.push_back(ring);
  }
  return mesh;
}

}  // namespace verify
