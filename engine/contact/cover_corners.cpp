#include "engine/contact/cover_corners.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>
#include <utility>

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// One end of a cover, as translations of the block with the lower number see it.
struct CoverEnd {
  std::pair<int, int> vertices;  // that meet there
  Cover* cover;
  int vertex;   // the one of the edge's block
  Vec2 along;   // from the end along the cover; not a unit vector
  Vec2 normal;  // unit, out of the entrance block

  [[nodiscard]] bool is_near() const { return cover->beyond <= 0 || cover->corner == vertex; }
  [[nodiscard]] double gap() const { return cover->contact.gap; }
};

// Of the covers' ends those whose corners are within reach of each other, those of one corner one after the other.
std::vector<CoverEnd> ends_of(const Outlines& outlines, double reach, std::vector<Cover>& covers) {
  std::vector<CoverEnd> ends;
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
  std::stable_sort(ends.begin(), ends.end(),
                   [](const CoverEnd& i, const CoverEnd& j) { return i.vertices < j.vertices; });
  return ends;
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

// How long a cover keeps the blocks apart in the foreseen motion: those that do to its end, by their gap then; those
// that close, by when; those that are closed, by their gap. Without motion the order of gaps.
std::pair<int, double> stay(const CoverEnd& end) {
  const double gap = end.gap(), coming = end.cover->coming_gap;
  if (gap <= 0) return {0, gap};
  return coming < 0 ? std::pair(1, gap / (gap - coming)) : std::pair(2, coming);
}

// Whether a cover whose end is reached still counts among the others of its corner.
bool counts_at(const CoverEnd& end, double round_off, std::span<const CoverEnd> corner) {
  bool is_farthest = end.gap() >= -round_off;
  for (const CoverEnd& other : corner) {
    if (other.cover == end.cover) continue;
    if (make_a_reflex_corner(end, other)) return true;
    if (!other.cover->counts || !other.is_near()) continue;
    const bool is_first = stay(other) == stay(end) && &other < &end;
    const bool takes_its_place = end.cover->beyond > 0 && other.cover->beyond <= 0 && are_parallel(other, end);
    if (stay(other) > stay(end) || is_first || takes_its_place) is_farthest = false;
  }
  return is_farthest;
}

bool are_one(const Outlines& outlines, const CoverEnd& i, const CoverEnd& j, double round_off) {
  if (!are_parallel(i, j)) return false;
  if (i.along.dot(j.along) < 0) return true;
  const Vec2 apart = outlines.current[at(i.vertices.first)] - outlines.current[at(i.vertices.second)];
  return std::abs(apart.dot(i.along.normalized())) <= std::max({round_off, -i.gap(), -j.gap()});
}

void choose_at(const Outlines& outlines, double round_off, std::span<const CoverEnd> ends) {
  for (const CoverEnd& end : ends)
    if (end.cover->counts && is_at(end, round_off) && end.cover->corner == end.vertex &&
        !counts_at(end, round_off, ends))
      end.cover->counts = false;
  for (const CoverEnd& i : ends)
    for (const CoverEnd& j : ends) {
      if (&j <= &i || !i.cover->counts || !j.cover->counts || !are_one(outlines, i, j, round_off)) continue;
      (i.gap() >= j.gap() ? j : i).cover->counts = false;
    }
}

}  // namespace

void choose_at_corners(const Outlines& outlines, double reach, double round_off, std::vector<Cover>& covers) {
  const std::vector<CoverEnd> ends = ends_of(outlines, reach, covers);
  for (auto first = ends.begin(); first != ends.end();) {
    const auto last =
        std::find_if(first, ends.end(), [&](const CoverEnd& end) { return end.vertices != first->vertices; });
    choose_at(outlines, round_off, std::span(first, last));
    first = last;
  }
  std::erase_if(covers, [](const Cover& cover) { return !cover.counts; });
}

}  // namespace dda
