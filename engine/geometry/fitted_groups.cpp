#include "engine/geometry/fitted_groups.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "engine/core/parallel_sort.h"
#include "engine/geometry/edge_index.h"

// Add up by polygon how often its outline goes around a place: that is the number of polygons that hold the place. Two
// sides that run there and back between the same corners cancel in the sum. So it is the number of times that the sides
// which are left go around the place; and where these are the outline of one polygon with holes, it is one within and
// none outside: no place is in two polygons.

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

struct Side {
  std::uint64_t key = 0;  // the same for both ways between two corners, another one for most other corners
  const Vec2* from = nullptr;
  const Vec2* to = nullptr;
  int polygon = 0;
};

std::uint64_t mixed(std::uint64_t bits) {  // the finalizer of MurmurHash3
  bits = (bits ^ (bits >> 33)) * 0xFF51AFD7ED558CCDu;
  bits = (bits ^ (bits >> 33)) * 0xC4CEB9FE1A85EC53u;
  return bits ^ (bits >> 33);
}

std::uint64_t key_of(const Vec2& corner) {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value + 0.0); };  // -0 is 0
  return mixed(mixed(bits(corner.x())) + bits(corner.y()));
}

void fill_sides(const Polygon& polygon, int number, Side* side) {
  const auto go_round = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2& from = ring[i];
      const Vec2& to = ring[i + 1 < ring.size() ? i + 1 : 0];
      *side++ = {key_of(from) + key_of(to), &from, &to, number};
    }
  };
  go_round(polygon.outer);
  for (const Ring& hole : polygon.holes) go_round(hole);
}

// Sides with the same key one behind the other. In which order those are depends on chance, and nothing on that.
std::vector<Side> sides_of(std::span<const Polygon* const> polygons) {
  std::vector<std::size_t> first(polygons.size() + 1, 0);
  for (std::size_t i = 0; i < polygons.size(); ++i) first[i + 1] = first[i] + corner_count(*polygons[i]);
  std::vector<Side> sides(first.back());
  constexpr std::size_t worth_sharing = 1000;  // polygons
  parallel_for_each(polygons.size(), worth_sharing,
                    [&](std::size_t i) { fill_sides(*polygons[i], static_cast<int>(i), &sides[first[i]]); });
  parallel_sort(sides, [](const Side& a, const Side& b) { return a.key < b.key; });
  return sides;
}

bool cancel(const Side& a, const Side& b) { return *a.from == *b.to && *a.to == *b.from; }

// Polygons that sides hold together, by one of them.
class Groups {
 public:
  explicit Groups(std::size_t polygons) : parent_(polygons), has_many_(polygons, 0) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  [[nodiscard]] int of(int polygon) {
    while (parent_[at(polygon)] != polygon) polygon = parent_[at(polygon)] = parent_[at(parent_[at(polygon)])];
    return polygon;
  }
  void join(int a, int b) {
    const auto [into, other] = std::minmax({of(a), of(b)});
    parent_[at(other)] = into;
    has_many_[at(into)] = 1;
  }
  [[nodiscard]] bool has_many(int group) const { return has_many_[at(group)] != 0; }

 private:
  std::vector<int> parent_;
  std::vector<char> has_many_;  // by group
};

// Joins what pairs of sides hold together, and returns the sides without a partner. Of more than two with the same key
// none has one: more than two polygons at one side do not fit.
std::vector<Side> join_by_sides(const std::vector<Side>& sides, Groups& groups) {
  std::vector<Side> left;
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    while (last < sides.size() && sides[last].key == sides[first].key) ++last;
    if (last - first == 2 && cancel(sides[first], sides[first + 1]))
      groups.join(sides[first].polygon, sides[first + 1].polygon);
    else
      left.insert(left.end(), &sides[first], &sides[first] + (last - first));
  }
  return left;
}

auto start_of(const Side& side) { return std::tuple(side.from->x(), side.from->y()); }

// Those of groups of several, by group and then by where they start: side.polygon is the group.
std::vector<Side> sorted_by_group(std::vector<Side> left, Groups& groups) {
  for (Side& side : left) side.polygon = groups.of(side.polygon);
  std::erase_if(left, [&](const Side& side) { return !groups.has_many(side.polygon); });
  parallel_sort(left, [](const Side& a, const Side& b) {
    return std::tuple(a.polygon, start_of(a), a.to->x(), a.to->y()) <
           std::tuple(b.polygon, start_of(b), b.to->x(), b.to->y());
  });
  return left;
}

// The rings that the sides make. Nothing where two sides start in one place: the rings touch.
std::optional<std::vector<Ring>> rings_of(std::span<const Side> sides) {
  const auto same_start = [](const Side& a, const Side& b) { return *a.from == *b.from; };
  if (std::ranges::adjacent_find(sides, same_start) != sides.end()) return std::nullopt;
  std::vector<char> is_used(sides.size(), 0);
  std::vector<Ring> rings;
  for (std::size_t start = 0; start < sides.size(); ++start) {
    if (is_used[start] != 0) continue;
    Ring& ring = rings.emplace_back();
    for (std::size_t i = start; is_used[i] == 0;) {
      is_used[i] = 1;
      ring.push_back(*sides[i].from);
      const auto goal = std::tuple(sides[i].to->x(), sides[i].to->y());
      const auto next = std::ranges::lower_bound(sides, goal, {}, start_of);
      i = static_cast<std::size_t>(next - sides.begin());  // one starts there, as whole outlines were added up
    }
  }
  return rings;
}

// Whether the sides are all of the outline of a polygon that they have on their left.
bool outline_a_polygon(std::span<const Side> sides) {
  const auto rings = rings_of(sides);
  if (!rings) return false;
  Polygon polygon;
  for (const Ring& ring : *rings) {
    if (signed_area(ring) < 0)
      polygon.holes.push_back(ring);
    else if (!std::exchange(polygon.outer, ring).empty())
      return false;  // two parts that share no side
  }
  return !polygon.outer.empty() && !defect(polygon);
}

}  // namespace

std::vector<int> groups_that_fit(std::span<const Polygon* const> polygons) {
  Groups groups(polygons.size());
  const std::vector<Side> left = sorted_by_group(join_by_sides(sides_of(polygons), groups), groups);
  std::vector<char> fits(polygons.size(), 0);
  for (auto first = left.begin(), last = first; first != left.end(); first = last) {
    last = std::find_if(first, left.end(), [&](const Side& side) { return side.polygon != first->polygon; });
    fits[at(first->polygon)] = outline_a_polygon({first, last}) ? 1 : 0;
  }
  std::vector<int> group_of(polygons.size(), no_group);
  for (int i = 0; i < static_cast<int>(group_of.size()); ++i)
    if (fits[at(groups.of(i))] != 0) group_of[at(i)] = groups.of(i);
  return group_of;
}

}  // namespace dda
