#include "engine/geometry/triangulate.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace dda {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// Sum of doubles without rounding, as an expansion of non-overlapping parts in increasing order (Shewchuk 1997).
class ExactSum {
 public:
  void add_product(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }

  // The last part outweighs all others together.
  [[nodiscard]] int sign() const {
    for (std::size_t i = count_; i-- > 0;) {
      if (parts_[i] != 0) return parts_[i] > 0 ? 1 : -1;
    }
    return 0;
  }

 private:
  void add(double value) {
    for (std::size_t i = 0; i < count_; ++i) {
      const double sum = value + parts_[i];
      const double rounded = sum - value;
      parts_[i] = (value - (sum - rounded)) + (parts_[i] - rounded);
      value = sum;
    }
    parts_[count_++] = value;
  }

  std::array<double, 12> parts_{};
  std::size_t count_ = 0;
};

int exact_side(const Vec2& a, const Vec2& b, const Vec2& c) {
  ExactSum sum;
  sum.add_product(a.x(), b.y());
  sum.add_product(-a.x(), c.y());
  sum.add_product(-c.x(), b.y());
  sum.add_product(-a.y(), b.x());
  sum.add_product(a.y(), c.x());
  sum.add_product(c.y(), b.x());
  return sum.sign();
}

// 1 when c lies left of the line from a to b, -1 right of it, 0 on it, without error.
int side(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  const double determinant = left - right;
  constexpr double round_off = 3.4e-16;  // a little over (3 + 16 u) u, u = 2^-53: Shewchuk 1997, orient2d filter A
  if (std::abs(determinant) > round_off * (std::abs(left) + std::abs(right))) return determinant > 0 ? 1 : -1;
  return exact_side(a, b, c);
}

bool between(double p, double q, double value) { return std::min(p, q) <= value && value <= std::max(p, q); }

// One closed chain of vertex indices with the interior on its left; first the outer ring, then all rings bridged.
class EarClipper {
 public:
  explicit EarClipper(const Polygon& polygon) {
    chain_ = append(polygon.outer, 1);
    for (const Ring& hole : polygon.holes) waiting_.push_back(append(hole, -1));
  }

  std::vector<Triangle> run() {
    join_holes();
    clip_ears();
    return std::move(triangles_);
  }

 private:
  using Chain = std::vector<int>;

  // Adds a ring's points; returns its indices, turned so that the signed area has the sign of `orientation`.
  Chain append(const Ring& ring, int orientation) {
    Chain indices(ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i) indices[i] = static_cast<int>(points_.size() + i);
    points_.insert(points_.end(), ring.begin(), ring.end());
    if (signed_area(ring) * orientation < 0) std::reverse(indices.begin(), indices.end());
    return indices;
  }

  [[nodiscard]] const Vec2& point(int vertex) const { return points_[at(vertex)]; }
  [[nodiscard]] int side_of(int a, int b, int c) const { return side(point(a), point(b), point(c)); }

  // The hole that reaches farthest to the right first: its rightmost vertex then sees the chain, past no other hole.
  void join_holes() {
    const auto reach = [this](int a, int b) { return point(a).x() < point(b).x(); };
    for (Chain& hole : waiting_)
      std::rotate(hole.begin(), std::max_element(hole.begin(), hole.end(), reach), hole.end());
    std::sort(waiting_.begin(), waiting_.end(),
              [&](const Chain& a, const Chain& b) { return reach(a.front(), b.front()); });
    while (!waiting_.empty()) {
      join(waiting_.back());
      waiting_.pop_back();
    }
  }

  void join(const Chain& hole) {
    const int start = hole.front();
    const std::size_t position = bridge_end(start);
    Chain loop = hole;
    loop.push_back(start);
    loop.push_back(chain_[position]);
    chain_.insert(chain_.begin() + static_cast<std::ptrdiff_t>(position) + 1, loop.begin(), loop.end());
  }

  // Position in the chain of the nearest vertex that `start` sees.
  [[nodiscard]] std::size_t bridge_end(int start) const {
    std::vector<std::size_t> candidates(chain_.size());
    for (std::size_t i = 0; i < candidates.size(); ++i) candidates[i] = i;
    const auto distance = [&](std::size_t i) { return (point(chain_[i]) - point(start)).squaredNorm(); };
    std::sort(candidates.begin(), candidates.end(),
              [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
    for (const std::size_t candidate : candidates) {
      if (opens_towards(candidate, start) && sees(start, chain_[candidate])) return candidate;
    }
    throw std::invalid_argument("triangulate: a hole is not inside the outer ring");
  }

  // Whether the interior at this passage of the chain lies towards `target`: a vertex with bridges is passed
  // repeatedly.
  [[nodiscard]] bool opens_towards(std::size_t position, int target) const {
    const int before = previous(position);
    const int vertex = chain_[position];
    const int after = next(position);
    if (side_of(before, vertex, after) >= 0) {
      return side_of(before, vertex, target) > 0 && side_of(vertex, after, target) > 0;
    }
    return side_of(before, vertex, target) > 0 || side_of(vertex, after, target) > 0;
  }

  [[nodiscard]] bool sees(int from, int to) const {
    return !blocks(chain_, from, to) &&
           std::none_of(waiting_.begin(), waiting_.end(), [&](const Chain& hole) { return blocks(hole, from, to); });
  }

  [[nodiscard]] bool blocks(const Chain& obstacle, int from, int to) const {
    for (std::size_t i = 0; i < obstacle.size(); ++i) {
      const int a = obstacle[i];
      const int b = obstacle[(i + 1) % obstacle.size()];
      if (lies_within(a, from, to) || cross_properly(a, b, from, to)) return true;
    }
    return false;
  }

  [[nodiscard]] bool lies_within(int vertex, int from, int to) const {
    return vertex != from && vertex != to && side_of(from, to, vertex) == 0 &&
           between(point(from).x(), point(to).x(), point(vertex).x()) &&
           between(point(from).y(), point(to).y(), point(vertex).y());
  }

  [[nodiscard]] bool cross_properly(int a, int b, int c, int d) const {
    return side_of(a, b, c) * side_of(a, b, d) < 0 && side_of(c, d, a) * side_of(c, d, b) < 0;
  }

  void clip_ears() {
    std::size_t position = 0;
    std::size_t failures = 0;
    while (chain_.size() >= 3) {
      if (failures == chain_.size()) throw std::invalid_argument("triangulate: the rings of the polygon cross");
      position %= chain_.size();
      failures = clip_ear(position) ? 0 : failures + 1;
      ++position;  // also after an ear: taking every other corner gives fewer thin triangles than a fan
    }
  }

  bool clip_ear(std::size_t position) {
    const Triangle ear{previous(position), chain_[position], next(position)};
    if (side_of(ear[0], ear[1], ear[2]) <= 0) return false;
    if (std::any_of(chain_.begin(), chain_.end(), [&](int vertex) { return covers(ear, vertex); })) return false;
    triangles_.push_back(ear);
    chain_.erase(chain_.begin() + static_cast<std::ptrdiff_t>(position));
    return true;
  }

  [[nodiscard]] bool covers(const Triangle& ear, int vertex) const {
    if (std::find(ear.begin(), ear.end(), vertex) != ear.end()) return false;
    return side_of(ear[0], ear[1], vertex) >= 0 && side_of(ear[1], ear[2], vertex) >= 0 &&
           side_of(ear[2], ear[0], vertex) >= 0;
  }

  [[nodiscard]] int previous(std::size_t position) const {
    return chain_[(position + chain_.size() - 1) % chain_.size()];
  }
  [[nodiscard]] int next(std::size_t position) const { return chain_[(position + 1) % chain_.size()]; }

  std::vector<Vec2> points_;
  Chain chain_;
  std::vector<Chain> waiting_;  // holes not yet joined
  std::vector<Triangle> triangles_;
};

}  // namespace

std::vector<Triangle> triangulate(const Polygon& polygon) { return EarClipper(polygon).run(); }

bool is_convex(const Polygon& polygon) {
  const Ring& ring = polygon.outer;
  const int orientation = signed_area(ring) < 0 ? -1 : 1;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& corner = ring[(i + 1) % ring.size()];
    if (side(ring[i], corner, ring[(i + 2) % ring.size()]) * orientation < 0) return false;
  }
  return polygon.holes.empty();
}

}  // namespace dda
