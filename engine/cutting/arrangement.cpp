#include "engine/cutting/arrangement.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "engine/core/parallel_sort.h"
#include "engine/cutting/edge_left_of.h"

namespace dda {
namespace {

// A closed walk along half-edges with one face on the left.
struct Walk {
  int leftmost = 0;  // a half-edge that leaves the walk's first node from the left (from below where several)
  Wide double_area = 0;
};

}  // namespace

Arrangement::Arrangement(Noding noding)
    : pixels_(std::move(noding.pixels)),
      positions_(std::move(noding.positions)),
      drawn_nodes_(static_cast<int>(pixels_.size())) {
  make_edges(noding.links);
  sort_around_nodes();
  find_faces();
}

void Arrangement::make_edges(const std::vector<Link>& links) {
  for (std::size_t i = 0; i < links.size(); ++i) {
    const bool is_new = i == 0 || links[i].from != links[i - 1].from || links[i].to != links[i - 1].to;
    if (is_new) {
      straight_starts_.push_back(static_cast<int>(i));
      origin_.push_back(links[i].from);
      origin_.push_back(links[i].to);
    }
    straights_.push_back(links[i].straight);
  }
  straight_starts_.push_back(static_cast<int>(links.size()));
}

void Arrangement::sort_around_nodes() {
  std::vector<int> leaving(origin_.size());
  std::iota(leaving.begin(), leaving.end(), 0);
  const auto direction = [&](int half_edge) { return pixel(target(half_edge)) - pixel(origin(half_edge)); };
  parallel_sort(leaving, [&](int a, int b) {
    if (origin(a) != origin(b)) return origin(a) < origin(b);
    return before_in_angle(direction(a), direction(b));
  });
  clockwise_.resize(origin_.size());
  for (std::size_t first = 0, last = 0; first < leaving.size(); first = last) {
    while (last < leaving.size() && origin(leaving[last]) == origin(leaving[first])) ++last;
    for (std::size_t i = first; i < last; ++i) clockwise_[at(leaving[i])] = leaving[i == first ? last - 1 : i - 1];
  }
}

// A walk around an area goes counter-clockwise and has a face of its own. Every connected part has one walk that does
// not (clockwise, or there and back along a tree): its face is that in which the part lies, which is found by looking
// left from the walk's leftmost node. Nodes ascend in x, so parts further left are settled first.
void Arrangement::find_faces() {
  std::vector<Walk> walks;
  std::vector<int> walk_of(origin_.size(), -1);
  for (int start = 0; start < half_edges(); ++start) {
    if (walk_of[at(start)] >= 0) continue;
    Walk walk{start, 0};
    const Pixel& reference = pixel(origin(start));
    int half_edge = start;
    do {
      walk_of[at(half_edge)] = static_cast<int>(walks.size());
      if (origin(half_edge) < origin(walk.leftmost)) walk.leftmost = half_edge;
      walk.double_area += cross(pixel(origin(half_edge)) - reference, pixel(target(half_edge)) - reference);
      half_edge = next(half_edge);
    } while (half_edge != start);
    walks.push_back(walk);
  }
  std::vector<int> face_of_walk(walks.size(), 0);
  std::vector<int> around;
  faces_ = 1;
  for (std::size_t i = 0; i < walks.size(); ++i) {
    if (walks[i].double_area > 0)
      face_of_walk[i] = faces_++;
    else
      around.push_back(static_cast<int>(i));
  }
  std::sort(around.begin(), around.end(),
            [&](int a, int b) { return origin(walks[at(a)].leftmost) < origin(walks[at(b)].leftmost); });
  const EdgeLeftOf left(pixels_, origin_);
  for (const int walk : around) {
    const int half_edge = left.of(origin(walks[at(walk)].leftmost));
    if (half_edge >= 0) face_of_walk[at(walk)] = face_of_walk[at(walk_of[at(half_edge)])];
  }
  face_.resize(origin_.size());
  for (std::size_t h = 0; h < face_.size(); ++h) face_[h] = face_of_walk[at(walk_of[h])];
}

void Arrangement::part_node(int first, int last, const Vec2& position, const Pixel& pixel) {
  const int node = nodes();
  pixels_.push_back(pixel);
  positions_.push_back(position);
  int before = first;
  while (clockwise(before) != first) before = clockwise(before);
  clockwise_[at(before)] = clockwise(last);
  clockwise_[at(last)] = first;
  for (int half_edge = first; origin_[at(half_edge)] != node; half_edge = clockwise(half_edge))
    origin_[at(half_edge)] = node;
}

}  // namespace dda
