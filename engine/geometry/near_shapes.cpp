#include "engine/geometry/near_shapes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "engine/geometry/nearness.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// A rectangle with sides along and across a direction.
struct TurnedBox {
  Vec2 along;  // unit
  Vec2 middle;
  Vec2 half;  // m, of the sides along and across
};

Vec2 across(const Vec2& along) { return {-along.y(), along.x()}; }

TurnedBox turned_around(std::span<const Vec2> points, const Vec2& along, double margin) {
  Box box;
  for (const Vec2& point : points) box = expanded(box, Vec2(along.dot(point), cross(along, point)));
  const Vec2 middle = (box.lower + box.upper) / 2;
  return {along, middle.x() * along + middle.y() * across(along), (box.upper - box.lower) / 2 + Vec2::Constant(margin)};
}

TurnedBox level_box(const Box& box) {
  return {Vec2::UnitX(), (box.lower + box.upper) / 2, (box.upper - box.lower) / 2};
}

double reach(const TurnedBox& box, const Vec2& axis) {
  return box.half.x() * std::abs(axis.dot(box.along)) + box.half.y() * std::abs(cross(box.along, axis));
}

// Separating axes.
bool overlap(const TurnedBox& a, const TurnedBox& b) {
  const Vec2 between = b.middle - a.middle;
  const auto meet = [&](const Vec2& axis) { return std::abs(axis.dot(between)) <= reach(a, axis) + reach(b, axis); };
  return meet(across(a.along)) && meet(across(b.along)) && meet(a.along) && meet(b.along);
}

const Vec2& farthest_from(const Vec2& place, const Ring& ring) {
  return *std::ranges::max_element(ring, {}, [&](const Vec2& vertex) { return (vertex - place).squaredNorm(); });
}

// From end to end, roughly.
Vec2 longest_way(const Ring& ring) {
  const Vec2& end = farthest_from(ring.front(), ring);
  const Vec2 way = farthest_from(end, ring) - end;
  const double length = way.norm();
  return length > 0 ? Vec2(way / length) : Vec2(Vec2::UnitX());
}

// Parts shapes at the median of their middles, again and again.
class ShapeTree {
 public:
  explicit ShapeTree(std::span<const Ring* const> shapes) : order_(shapes.size()) {
    double largest = 0;
    for (const Ring* ring : shapes) largest = std::max(largest, largest_coordinate_of(*ring));
    margin_ = 4 * coordinate_tolerance(largest);
    for (const Ring* ring : shapes) shapes_.push_back(turned_around(*ring, longest_way(*ring), margin_));
    std::iota(order_.begin(), order_.end(), 0);
    if (!order_.empty()) build(0, order_.size());
  }

  // Calls visit(i) for shapes whose rectangles overlap this one.
  template <typename Visit>
  void visit_near(const TurnedBox& box, const Visit& visit) const {
    if (!nodes_.empty()) visit_near(box, 0, visit);
  }

  [[nodiscard]] const TurnedBox& shape(int i) const { return shapes_[at(i)]; }
  [[nodiscard]] double margin() const { return margin_; }

 private:
  static constexpr std::size_t few = 4;  // shapes that are looked at one by one

  struct Node {
    TurnedBox box;
    std::size_t first = 0, last = 0;  // of order_
    std::size_t other = 0;            // the second part; the first one follows at once. 0: it has no parts
  };

  [[nodiscard]] TurnedBox around(std::size_t first, std::size_t last) const {
    const auto length = [&](int i) { return shape(i).half.x(); };
    const std::span<const int> members = std::span(order_).subspan(first, last - first);
    const Vec2 along = shape(*std::ranges::max_element(members, {}, length)).along;
    std::vector<Vec2> corners;
    for (const int i : members) {
      const TurnedBox& each = shape(i);
      const Vec2 x = each.half.x() * each.along;
      const Vec2 y = each.half.y() * across(each.along);
      for (const Vec2& way : {Vec2(x + y), Vec2(x - y)}) {
        corners.emplace_back(each.middle + way);
        corners.emplace_back(each.middle - way);
      }
    }
    return turned_around(corners, along, margin_);
  }

  void build(std::size_t first, std::size_t last) {
    const std::size_t number = nodes_.size();
    nodes_.push_back({around(first, last), first, last, 0});
    if (last - first <= few) return;
    const std::size_t middle = (first + last) / 2;
    part(first, middle, last, nodes_[number].box.along);
    build(first, middle);
    nodes_[number].other = nodes_.size();
    build(middle, last);
  }

  // Along or across the way of the longest, whichever way their middles lie further apart.
  void part(std::size_t first, std::size_t middle, std::size_t last, const Vec2& along) {
    Box spread;
    for (std::size_t k = first; k < last; ++k) {
      const Vec2& place = shape(order_[k]).middle;
      spread = expanded(spread, Vec2(along.dot(place), cross(along, place)));
    }
    const Vec2 sides = spread.upper - spread.lower;
    const Vec2 axis = sides.x() > sides.y() ? along : across(along);
    const auto offset = [&](int i) { return std::pair(axis.dot(shape(i).middle), i); };
    const auto place = [&](std::size_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(place(first), place(middle), place(last), [&](int a, int b) { return offset(a) < offset(b); });
  }

  template <typename Visit>
  void visit_near(const TurnedBox& box, std::size_t number, const Visit& visit) const {
    const Node& node = nodes_[number];
    if (!overlap(node.box, box)) return;
    if (node.other > 0) {
      visit_near(box, number + 1, visit);
      visit_near(box, node.other, visit);
      return;
    }
    for (std::size_t k = node.first; k < node.last; ++k)
      if (overlap(shape(order_[k]), box)) visit(order_[k]);
  }

  double margin_ = 0;  // m, more than the round-off of turning
  std::vector<TurnedBox> shapes_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

// Whether many boxes lie over most places.
bool is_crowded(std::span<const Box> boxes) {
  constexpr double many = 6;
  Box bounds;
  double sum = 0;
  const auto area = [](const Box& box) { return (box.upper - box.lower).prod(); };
  for (const Box& box : boxes) {
    if (is_empty(box)) continue;
    bounds = expanded(expanded(bounds, box.lower), box.upper);
    sum += area(box);
  }
  return !is_empty(bounds) && sum > many * area(bounds);
}

}  // namespace

struct ShapeIndex::Tree {
  explicit Tree(std::span<const Ring* const> given) : shapes(given) {}
  ShapeTree shapes;
};

ShapeIndex::ShapeIndex(std::span<const Ring* const> shapes) {
  for (const Ring* ring : shapes) boxes_.push_back(bounding_box(*ring));
  if (is_crowded(boxes_))
    tree_ = std::make_unique<const Tree>(shapes);
  else
    grid_ = std::make_unique<const BoxIndex>(boxes_);
}

ShapeIndex::~ShapeIndex() = default;

template <typename Rectangle>
std::vector<int> ShapeIndex::in_tree(const Rectangle& rectangle, const Box& box) const {
  std::vector<int> found;
  tree_->shapes.visit_near(rectangle, [&](int i) {
    if (overlap(boxes_[at(i)], box)) found.push_back(i);
  });
  std::ranges::sort(found);
  return found;
}

std::vector<int> ShapeIndex::near(const Box& box) const {
  return grid_ ? grid_->overlapping(box) : in_tree(level_box(box), box);
}

std::vector<int> ShapeIndex::near(const Segment& line, double reach) const {
  const Box box = edge_box(line, reach);
  if (grid_) return grid_->overlapping(box);
  const Ring ends{line.start, line.end};
  return in_tree(turned_around(ends, longest_way(ends), reach + tree_->shapes.margin()), box);
}

std::vector<std::pair<int, int>> pairs_of_near_shapes(std::span<const Ring* const> shapes, std::span<const Box> boxes) {
  if (!is_crowded(boxes)) return overlapping_pairs(boxes);
  const ShapeTree tree(shapes);
  std::vector<std::pair<int, int>> pairs;
  for (int i = 0; i < static_cast<int>(shapes.size()); ++i) {
    const auto first = static_cast<std::ptrdiff_t>(pairs.size());
    tree.visit_near(tree.shape(i), [&](int j) {
      const bool is_pair = j > i && !is_empty(boxes[at(i)]) && !is_empty(boxes[at(j)]);
      if (is_pair && overlap(boxes[at(i)], boxes[at(j)])) pairs.emplace_back(i, j);
    });
    std::sort(pairs.begin() + first, pairs.end());
  }
  return pairs;
}

}  // namespace dda
