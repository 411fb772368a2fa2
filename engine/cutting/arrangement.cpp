#include "engine/cutting/arrangement.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>

#include "engine/core/at_once.h"
#include "engine/core/parallel_sort.h"
#include "engine/cutting/edge_left_of.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr std::size_t worth_sharing = 1000;  // of walks

// A closed walk along half-edges with one face on the left.
struct Walk {
  int leftmost = 0;  // a half-edge that leaves the walk's first node from the left (from below where several)
  Wide double_area = 0;
};

struct Walks {
  std::vector<Walk> all;
  std::vector<int> number;  // by half-edge, of its walk
};

Walks walks_of(const Arrangement& arrangement) {
  Walks walks{{}, std::vector<int>(at(arrangement.half_edges()), -1)};
  for (int start = 0; start < arrangement.half_edges(); ++start) {
    if (walks.number[at(start)] >= 0) continue;
    Walk walk{start, 0};
    const Pixel& reference = arrangement.pixel(arrangement.origin(start));
    int half_edge = start;
    do {
      const int from = arrangement.origin(half_edge), to = arrangement.target(half_edge);
      walks.number[at(half_edge)] = static_cast<int>(walks.all.size());
      if (from < arrangement.origin(walk.leftmost)) walk.leftmost = half_edge;
      walk.double_area += cross(arrangement.pixel(from) - reference, arrangement.pixel(to) - reference);
      half_edge = arrangement.next(half_edge);
    } while (half_edge != start);
    walks.all.push_back(walk);
  }
  return walks;
}

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
  Walks walks;
  std::optional<EdgeLeftOf> left;
  at_once([&] { walks = walks_of(*this); }, [&] { left.emplace(pixels_, origin_); });
  std::vector<int> face_of_walk(walks.all.size(), 0);
  std::vector<int> around;
  faces_ = 1;
  for (std::size_t i = 0; i < walks.all.size(); ++i) {
    if (walks.all[i].double_area > 0)
      face_of_walk[i] = faces_++;
    else
      around.push_back(static_cast<int>(i));
  }
  const auto start = [&](int walk) { return origin(walks.all[at(walk)].leftmost); };
  std::sort(around.begin(), around.end(), [&](int a, int b) { return start(a) < start(b); });
  std::vector<int> beside(around.size());
  parallel_for_each(around.size(), worth_sharing, [&](std::size_t i) { beside[i] = left->of(start(around[i])); });
  for (std::size_t i = 0; i < around.size(); ++i)
    if (beside[i] >= 0) face_of_walk[at(around[i])] = face_of_walk[at(walks.number[at(beside[i])])];
  face_.resize(origin_.size());
  for (std::size_t h = 0; h < face_.size(); ++h) face_[h] = face_of_walk[at(walks.number[h])];
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
