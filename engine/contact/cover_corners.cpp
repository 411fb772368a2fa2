#include "engine/contact/cover_corners.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "engine/core/sort_few.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr double same_time = 1e-9;  // of a step

// Lists those of the covers' ends whose corners are within reach of each other, those of one corner one after the
// other.
void list_ends(const Outlines& outlines, double reach, std::vector<Cover>& covers, std::vector<CoverEnd>& ends) {
  ends.clear();
  for (Cover& cover : covers) {
    const VertexContact& contact = cover.contact;
    const double side = contact.vertex_block < contact.edge_block ? 1 : -1;
    const int last = outlines.next[at(contact.edge)];
    for (const int vertex : {contact.edge, last}) {
      const Vec2 apart = outlines.current[at(contact.vertex)] - outlines.current[at(vertex)];
      if (apart.squaredNorm() > reach * reach) continue;
      const Vec2 along = (vertex == last ? -side : side) * outlines.along(contact.edge);
      ends.push_back({std::minmax(contact.vertex, vertex), &cover, vertex, along, side * contact.normal});
    }
  }
  sort_few(ends, [](const CoverEnd& i, const CoverEnd& j) { return i.vertices < j.vertices; });
}

bool are_parallel(const CoverEnd& i, const CoverEnd& j) { return i.normal.dot(j.normal) >= same_direction; }

// Each goes on outside the other's line.
bool make_a_reflex_corner(const CoverEnd& i, const CoverEnd& j) {
  return !are_parallel(i, j) && i.normal.dot(j.along) > 0 && j.normal.dot(i.along) > 0;
}

// Whether the place taken now has come to the end, or past it.
bool is_at(const CoverEnd& end, double round_off) {
  return end.cover->beyond > 0 || (end.cover->beyond == 0 && end.gap() >= -round_off);
}

// Which is the larger: 1 the first, -1 the second, 0 neither, as far as `same` tells.
int compare(double first, double second, double same) {
  return first > second + same ? 1 : second > first + same ? -1 : 0;
}

// Which of two covers keeps the blocks apart longer in the foreseen motion: 1 the first, -1 the second, 0 neither, as
// far as round-off can tell. Covers that stay open do so longest, by their gap then, and so do those along which the
// blocks touch and go on touching: a block that falls flush beside another meets nothing of it, not its top. Next come
// those that close, by when; last those that are closed, by their gap, and where that is the same by what the motion
// makes of it.
int compare_stay(const Cover& first, const Cover& second, double round_off) {
  const auto kind = [&](const Cover& cover) {
    if (cover.contact.gap > round_off) return cover.coming_gap < 0 ? 1 : 2;
    return std::min(cover.contact.gap, cover.coming_gap) >= -round_off ? 2 : 0;
  };
  const auto closes_at = [](const Cover& cover) { return cover.contact.gap / (cover.contact.gap - cover.coming_gap); };
  if (kind(first) != kind(second)) return kind(first) > kind(second) ? 1 : -1;
  if (kind(first) == 1) return compare(closes_at(first), closes_at(second), same_time);
  if (kind(first) == 0)
    if (const int by_gap = compare(first.contact.gap, second.contact.gap, round_off); by_gap != 0) return by_gap;
  return compare(first.coming_gap, second.coming_gap, round_off);
}

// m, round the outline of a block.
double perimeter_of(const Outlines& outlines, int block) {
  double length = 0;
  for (int edge = outlines.starts[at(block)]; edge < outlines.starts[at(block) + 1]; ++edge)
    length += outlines.length_of(edge);
  return length;
}

// Two covers in line may be the same but for round-off, which must not choose: contacts that go on carry the load of
// before, and of two corners above each other that have been pushed past each other both are contacts. The one goes
// before whose vertex lies farther within its edge, as it stays on it the longer; else the one on the longer edge; else
// the one on the edge of the longer outline. Blocks of one shape leave it to their order, see acting_frame.h.
bool goes_before(const Outlines& outlines, const CoverEnd& one, const CoverEnd& other, double round_off) {
  if (const int within = compare(other.cover->past, one.cover->past, round_off); within != 0) return within > 0;
  const auto length = [&](const CoverEnd& end) { return outlines.length_of(end.cover->contact.edge); };
  if (const int edge = compare(length(one), length(other), round_off); edge != 0) return edge > 0;
  const auto perimeter = [&](const CoverEnd& end) { return perimeter_of(outlines, end.cover->contact.edge_block); };
  if (const int outline = compare(perimeter(one), perimeter(other), round_off); outline != 0) return outline > 0;
  return &one < &other;
}

// Calls act(ends) for the ends of every corner.
template <typename Act>
void for_each_corner(const std::vector<CoverEnd>& ends, Act act) {
  for (auto first = ends.begin(); first != ends.end();) {
    const auto last =
        std::find_if(first, ends.end(), [&](const CoverEnd& end) { return end.vertices != first->vertices; });
    act(std::span(first, last));
    first = last;
  }
}

void let_go(const std::vector<CoverEnd>& ends) {
  for (const CoverEnd& end : ends)
    if (end.cover->goes) end.cover->counts = false;
}

// What is asked about an end of a cover that the place taken now has come to: whether the cover is to go.
using Question = bool (*)(const Outlines& outlines, const CoverEnd& end, double round_off,
                          std::span<const CoverEnd> corner);

// Puts a question to all ends and then takes out the covers that are to go: the order of blocks and vertices decides
// nothing.
void ask(Question goes, const Outlines& outlines, double round_off, const std::vector<CoverEnd>& ends) {
  for_each_corner(ends, [&](std::span<const CoverEnd> corner) {
    for (const CoverEnd& end : corner)
      if (end.cover->counts && goes(outlines, end, round_off, corner)) end.cover->goes = true;
  });
  let_go(ends);
}

bool has_come_to(const CoverEnd& end, double round_off) {
  return is_at(end, round_off) && end.cover->corner == end.vertex;
}

// The foreseen motion leads the vertex past this end before it closes the gap: it will not meet the edge there.
bool is_missed(const CoverEnd& end, double round_off) {
  const bool is_first = end.vertex == end.cover->contact.edge;
  return end.gap() > round_off && end.cover->met_past[is_first ? 0 : 1] >= -round_off;
}

bool makes_a_reflex_corner(const CoverEnd& end, std::span<const CoverEnd> corner) {
  return std::ranges::any_of(
      corner, [&](const CoverEnd& other) { return other.cover != end.cover && make_a_reflex_corner(end, other); });
}

// Its end is passed, and a cover in line goes on there.
bool is_followed(const Outlines& /*outlines*/, const CoverEnd& end, double round_off,
                 std::span<const CoverEnd> corner) {
  if (end.cover->beyond <= 0 || !has_come_to(end, round_off) || makes_a_reflex_corner(end, corner)) return false;
  return std::ranges::any_of(corner, [&](const CoverEnd& other) {
    return other.cover != end.cover && other.cover->counts && other.cover->beyond <= 0 && are_parallel(other, end) &&
           !is_missed(other, round_off);
  });
}

// Another cover keeps the blocks apart longer. Of two in line that do so as long one goes, others count both.
bool is_outlasted(const Outlines& outlines, const CoverEnd& end, double round_off, std::span<const CoverEnd> corner) {
  const bool is_here = has_come_to(end, round_off);
  if ((!is_here && !is_missed(end, round_off)) || makes_a_reflex_corner(end, corner)) return false;
  if (end.gap() < -round_off) return true;
  return std::ranges::any_of(corner, [&](const CoverEnd& other) {
    if (other.cover == end.cover || !other.cover->counts || !other.is_near()) return false;
    const int longer = compare_stay(*other.cover, *end.cover, round_off);
    const bool is_one = is_here && longer == 0 && are_parallel(other, end);
    return longer > 0 || (is_one && goes_before(outlines, other, end, round_off));
  });
}

bool are_one(const CoverEnd& i, const CoverEnd& j, const Vec2& apart, double round_off) {
  if (!are_parallel(i, j)) return false;
  if (i.along.dot(j.along) < 0) return true;
  return std::abs(apart.dot(i.along.normalized())) <= std::max({round_off, -i.gap(), -j.gap()});
}

bool lasts_longer(const Outlines& outlines, const CoverEnd& i, const CoverEnd& j, double round_off) {
  return std::abs(i.gap() - j.gap()) > round_off ? i.gap() > j.gap() : goes_before(outlines, i, j, round_off);
}

// Where covers are one and the same, only the one with the largest gap stays.
void drop_doubles(const Outlines& outlines, double round_off, const std::vector<CoverEnd>& ends) {
  for_each_corner(ends, [&](std::span<const CoverEnd> corner) {
    const auto& [vertex, other] = corner.front().vertices;
    const Vec2 apart = outlines.current[at(vertex)] - outlines.current[at(other)];
    for (const CoverEnd& i : corner)
      for (const CoverEnd& j : corner)
        if (&i < &j && i.cover->counts && j.cover->counts && are_one(i, j, apart, round_off))
          (lasts_longer(outlines, i, j, round_off) ? j : i).cover->goes = true;
  });
  let_go(ends);
}

}  // namespace

void choose_at_corners(const Outlines& outlines, double reach, double round_off, std::vector<Cover>& covers,
                       std::vector<CoverEnd>& ends) {
  list_ends(outlines, reach, covers, ends);
  ask(is_followed, outlines, round_off, ends);
  ask(is_outlasted, outlines, round_off, ends);
  drop_doubles(outlines, round_off, ends);
  std::erase_if(covers, [](const Cover& cover) { return !cover.counts; });
}

}  // namespace dda
