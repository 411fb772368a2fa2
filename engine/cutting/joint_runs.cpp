#include "engine/cutting/joint_runs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <tuple>
#include <utility>

#include "engine/cutting/line_report.h"
#include "engine/geometry/box.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class BorderCollector {
 public:
  BorderCollector(const Arrangement& arrangement, const FaceGroups& groups, const Corners& corners,
                  const PlanPieces& pieces, const RockPlan& plan)
      : arrangement_(arrangement), groups_(groups), corners_(corners), pieces_(pieces), plan_(plan) {}

  // `walk` is closed and has the block on its left.
  void add(const std::vector<int>& walk) {
    const auto is_corner = [&](int h) { return !corners_.is_superfluous(arrangement_.origin(h)); };
    const auto first = std::find_if(walk.begin(), walk.end(), is_corner);
    if (first == walk.end()) return;
    std::vector<int> round(first, walk.end());
    round.insert(round.end(), walk.begin(), first);
    for (auto part = round.begin(), next = part; part != round.end(); part = next) {
      next = std::find_if(part + 1, round.end(), is_corner);
      if (is_mine(*part)) add_edge({part, next});
    }
  }

  std::vector<BorderEdge> take() {
    std::sort(edges_.begin(), edges_.end(), [](const BorderEdge& a, const BorderEdge& b) {
      return std::tuple(a.straight, a.way, a.from) < std::tuple(b.straight, b.way, b.from);
    });
    return std::move(edges_);
  }

 private:
  // Both blocks come by the edge: it is added with the one of them.
  [[nodiscard]] bool is_mine(int half_edge) const {
    const int other = groups_.of(arrangement_.face(twin(half_edge)));
    return other != FaceGroups::outside && groups_.of(arrangement_.face(half_edge)) < other;
  }

  [[nodiscard]] bool runs_along(int straight, std::span<const int> part) const {
    return std::ranges::all_of(part, [&](int h) {
      const auto straights = arrangement_.straights(h / 2);
      return std::find(straights.begin(), straights.end(), straight) != straights.end();
    });
  }

  // The one whose joint counts, as far as it runs along all of the part.
  [[nodiscard]] int straight_along(std::span<const int> part, int counting) const {
    if (part.size() == 1 || runs_along(counting, part)) return counting;
    const auto all = arrangement_.straights(part.front() / 2);
    const auto along = std::find_if(all.begin(), all.end(), [&](int each) { return runs_along(each, part); });
    return along == all.end() ? counting : *along;
  }

  void add_edge(std::span<const int> part) {
    const int counting = counting_straight(arrangement_, part.front() / 2, pieces_, plan_);
    const int straight = straight_along(part, counting);
    const Straight& line = pieces_.straights[at(straight)];
    const auto way = [&](int node) { return (line.to - line.from).dot(arrangement_.position(node) - line.from); };
    int from = arrangement_.origin(part.front());
    int to = arrangement_.target(part.back());
    if (way(from) > way(to)) std::swap(from, to);
    edges_.push_back({straight, way(from), from, to, &joint_of(pieces_.sources[at(counting)], plan_)});
  }

  const Arrangement& arrangement_;
  const FaceGroups& groups_;
  const Corners& corners_;
  const PlanPieces& pieces_;
  const RockPlan& plan_;
  std::vector<BorderEdge> edges_;
};

// m, by which nodes of a run may lie beside its straight: twice what welding moves them with the default tolerance, and
// a fifth of what scenes allow a joint line to leave the blocks along it (point_tolerance).
double aside_allowed(const RockPlan& plan) {
  constexpr double of_diagonal = 2e-8;
  const Box box = bounding_box(plan.boundary);
  return of_diagonal * (box.upper - box.lower).norm();
}

}  // namespace

std::vector<BorderEdge> border_edges(const Arrangement& arrangement, const FaceGroups& groups,
                                     const std::vector<Outline>& outlines, const Corners& corners,
                                     const PlanPieces& pieces, const RockPlan& plan) {
  BorderCollector edges(arrangement, groups, corners, pieces, plan);
  for (const Outline& outline : outlines) {
    edges.add(outline.outer);
    for (const auto& hole : outline.holes) edges.add(hole);
  }
  return edges.take();
}

void fill_joints(const std::vector<BorderEdge>& edges, const CornerPlaces& places, const PlanPieces& pieces,
                 const RockPlan& plan, CutRock& rock) {
  const double aside = aside_allowed(plan);
  const auto is_on_straight = [&](int node, int straight) {
    const Straight& line = pieces.straights[at(straight)];
    const Vec2 along = (line.to - line.from).normalized();
    return std::abs(cross(along, places.position(node) - line.from)) <= aside;
  };
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last + 1) {
    last = first;
    const auto goes_on = [&](const BorderEdge& each, const BorderEdge& next) {
      return next.straight == each.straight && next.from == each.to && *next.joint == *each.joint &&
             is_on_straight(each.from, each.straight) && is_on_straight(each.to, each.straight) &&
             is_on_straight(next.to, each.straight);
    };
    while (last + 1 < edges.size() && goes_on(edges[last], edges[last + 1])) ++last;
    const int from = places.node(edges[first].from);
    const int to = places.node(edges[last].to);
    if (from == to) continue;  // a short edge that was closed
    rock.joints.push_back({places.position(from), places.position(to), *edges[first].joint});
  }
}

}  // namespace dda
