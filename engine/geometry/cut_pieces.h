// Random blocks as rock is cut: one piece, cut by straight lines into convex cells with short faces, needles and
// slivers on purpose, some of them joined again into concave blocks. For tests of populations; the same seed gives the
// same blocks everywhere.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "engine/geometry/polygon.h"
#include "engine/geometry/segment.h"

namespace dda {

// The distributions of the standard library differ from one implementation to the next; these do not.
class SeededNumbers {
 public:
  explicit SeededNumbers(std::uint64_t seed) : engine_(seed) {}

  double number(double lower, double upper) {
    return lower + (upper - lower) * std::ldexp(static_cast<double>(engine_() >> 11), -53);
  }
  int integer(int lower, int upper) { return std::min(upper, static_cast<int>(number(lower, upper + 1.0))); }
  bool chance(double probability) { return number(0, 1) < probability; }
  // A power of ten with an exponent between the two.
  double magnitude(double lower, double upper) { return std::pow(10.0, number(lower, upper)); }
  Vec2 direction() {
    const double angle = number(0, 2 * std::numbers::pi);
    return {std::cos(angle), std::sin(angle)};
  }
  template <typename List>
  const auto& one_of(const List& list) {
    return list[static_cast<std::size_t>(integer(0, static_cast<int>(list.size()) - 1))];
  }

 private:
  std::mt19937_64 engine_;
};

// Vertices nearer to the one before than this (m) are left out.
inline constexpr double least_face = 1e-9;

inline Ring without_repetitions(const Ring& ring) {
  Ring kept;
  for (const Vec2& vertex : ring)
    if (kept.empty() || (vertex - kept.back()).norm() > least_face) kept.push_back(vertex);
  while (kept.size() > 1 && (kept.front() - kept.back()).norm() <= least_face) kept.pop_back();
  return kept;
}

// The two parts of a convex ring left and right of a line; one is empty where the line misses it.
inline std::pair<Ring, Ring> cut(const Ring& ring, const Vec2& point, const Vec2& along) {
  std::pair<Ring, Ring> parts;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& start = ring[i];
    const Vec2& end = ring[(i + 1) % ring.size()];
    const double side = cross(along, start - point);
    const double end_side = cross(along, end - point);
    if (side >= 0) parts.first.push_back(start);
    if (side <= 0) parts.second.push_back(start);
    if (side * end_side >= 0) continue;
    const Vec2 crossing = start + side / (side - end_side) * (end - start);
    parts.first.push_back(crossing);
    parts.second.push_back(crossing);
  }
  parts = {without_repetitions(parts.first), without_repetitions(parts.second)};
  return parts;
}

// A convex polygon of 3 to 8 corners on the unit circle, not too thin.
inline Ring random_piece(SeededNumbers& random) {
  while (true) {
    std::vector<double> angles(static_cast<std::size_t>(random.integer(3, 8)));
    for (double& angle : angles) angle = random.number(0, 2 * std::numbers::pi);
    std::sort(angles.begin(), angles.end());
    Ring ring;
    for (const double angle : angles) ring.emplace_back(std::cos(angle), std::sin(angle));
    ring = without_repetitions(ring);
    if (ring.size() > 2 && signed_area(ring) > 0.3) return ring;
  }
}

// Cuts go all the way through or through one cell, past a vertex at 1e-6 to 0.1 or anywhere, at any angle or nearly
// along an earlier cut.
inline std::vector<Ring> random_cells(SeededNumbers& random, int cuts, double least_area = 1e-9) {
  std::vector<Ring> cells{random_piece(random)};
  std::vector<Vec2> lines;
  for (int i = 0; i < cuts; ++i) {
    const Ring near = random.one_of(cells);
    const Vec2 corner = random.one_of(near);
    const double aside = random.chance(0.6) ? random.magnitude(-6, -1) : random.number(0, 1);
    const Vec2 point = corner + aside * random.direction();
    Vec2 along = random.direction();
    if (!lines.empty() && random.chance(0.2)) along = random.one_of(lines) + random.magnitude(-4, -1.5) * along;
    lines.push_back(along);
    const bool through_all = random.chance(0.5);
    std::vector<Ring> next;
    for (const Ring& cell : cells) {
      auto [left, right] = cut(cell, point, along);
      const bool is_cut = (through_all || cell == near) && left.size() > 2 && right.size() > 2 &&
                          signed_area(left) > least_area && signed_area(right) > least_area;
      if (is_cut) {
        next.push_back(std::move(left));
        next.push_back(std::move(right));
      } else {
        next.push_back(cell);
      }
    }
    cells = std::move(next);
  }
  return cells;
}

// One block of two convex cells that lie along each other; nothing where they do not.
inline std::optional<Ring> joined(const Ring& a, const Ring& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Segment edge{a[i], a[(i + 1) % a.size()]};
    for (std::size_t j = 0; j < b.size(); ++j) {
      const Segment other{b[j], b[(j + 1) % b.size()]};
      if ((edge.end - edge.start).dot(other.end - other.start) > 0) continue;
      const auto common = collinear_overlap(edge, other, 1e-10);
      if (!common || (common->second - common->first).norm() < 1e-3) continue;
      Ring whole;
      for (std::size_t k = 1; k <= a.size(); ++k) whole.push_back(a[(i + k) % a.size()]);
      for (std::size_t k = 1; k <= b.size(); ++k) whole.push_back(b[(j + k) % b.size()]);
      whole = without_repetitions(whole);
      if (!defect({whole, {}})) return whole;
    }
  }
  return std::nullopt;
}

// The cells, and sometimes two of them as one concave block.
inline std::vector<Ring> random_blocks(SeededNumbers& random, int cuts, double least_area = 1e-9) {
  std::vector<Ring> blocks = random_cells(random, cuts, least_area);
  for (int attempt = 0; attempt < 2 && blocks.size() > 3; ++attempt) {
    const auto i = static_cast<std::size_t>(random.integer(0, static_cast<int>(blocks.size()) - 1));
    const auto j = static_cast<std::size_t>(random.integer(0, static_cast<int>(blocks.size()) - 1));
    if (i == j || !random.chance(0.5)) continue;
    const std::optional<Ring> whole = joined(blocks[i], blocks[j]);
    if (!whole) continue;
    blocks[i] = *whole;
    blocks.erase(blocks.begin() + static_cast<std::ptrdiff_t>(j));
  }
  return blocks;
}

}  // namespace dda
