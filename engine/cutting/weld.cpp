#include "engine/cutting/weld.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "engine/core/parallel_sort.h"
#include "engine/core/where.h"
#include "engine/cutting/needless_prolongations.h"
#include "engine/cutting/passed_nodes.h"
#include "engine/cutting/quadrants.h"
#include "engine/geometry/box_pairs.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

// The share of round-off by which a link may pass a node without going through it: 1/sqrt(2). Let the corners A and B
// of a triangle be further apart than round-off, and A as near to BC as B is to AC. Were both links led through the
// other corner, they would change places, round after round. With this share the angles at A and B are less than 45
// degrees in that case, so the one at C is obtuse, and B is not beside AC but beyond its end.
constexpr double share_beside_links = 0.7071;
constexpr int none = -1;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// A link that passes a node that it should go through.
struct Detour {
  int link = 0;
  double share = 0;  // of the link, at the node
  int node = 0;
};

using Places = std::vector<PixelBox>;

// One round: which nodes become one, where links have to be led, and what comes of it.
class Welder {
 public:
  // `unseen`: around what came or changed since nodes and links were last compared.
  Welder(Noding& noding, const PlanPieces& pieces, const RockPlan& plan, const Places& unseen,
         std::vector<Cleaned>& cleaned)
      : noding_(noding),
        pieces_(pieces),
        plan_(plan),
        cleaned_(cleaned),
        round_off_(round_off_of(pieces)),
        reach_(static_cast<std::int64_t>(2 * round_off_ / pieces.grid.step() + 2 * least_steps_of_round_off)),
        region_(noding.pixels, unseen, reach_),
        into_(noding.pixels.size()),
        is_drawn_(drawn_nodes(noding.pixels, pieces)),
        bounds_(noding.pixels.size(), {none, none}),
        links_at_(noding.pixels.size(), 0),
        is_moved_(noding.pixels.size(), false),
        is_dropped_(needless_prolongations(noding, pieces)) {
    std::iota(into_.begin(), into_.end(), 0);
    for (const Link& link : noding_.links) {
      for (const int node : {link.from, link.to}) {
        ++links_at_[at(node)];
        if (is_bound(pieces_, link.straight, plan_)) note_bound(node, link.straight);
      }
    }
  }

  // Whether there was anything to weld.
  bool weld() {
    put_on_bounds();
    const bool any_dropped = std::find(is_dropped_.begin(), is_dropped_.end(), true) != is_dropped_.end();
    if (take_away_passed() || any_dropped) return true;
    has_compared_ = true;
    const bool any_joined = join_nodes();
    find_detours();
    return any_joined || !detours_.empty();
  }

  // Whether nodes and links were compared, and not only those taken away that are not needed.
  [[nodiscard]] bool has_compared() const { return has_compared_; }

  // What comes of it, to be noded again.
  [[nodiscard]] Renoding renoding() {
    Renoding changed;
    changed.links.reserve(noding_.links.size() + detours_.size());
    lead_links(changed);
    // Links that are the same may come in any order: it is only asked whether all of them have changed.
    sort_others(changed.links, [](const ChangedLink& a, const ChangedLink& b) { return a.link < b.link; });
    keep_one_of_each(changed.links);
    changed.stays.resize(into_.size());
    for (std::size_t node = 0; node < into_.size(); ++node) changed.stays[node] = at(into_[node]) == node;
    changed.reach = reach_;
    changed.pixels = std::move(noding_.pixels);
    changed.positions = std::move(noding_.positions);
    return changed;
  }

 private:
  void keep_one_of_each(std::vector<ChangedLink>& links) const {
    auto end = links.begin();
    for (auto first = links.begin(), last = first; first != links.end(); first = last) {
      const ChangedLink& one = *first;
      last = std::find_if(first, links.end(), [&](const ChangedLink& each) { return !(each.link == one.link); });
      const bool closed = pieces_.sources[at(one.link.straight)].curve != no_curve;
      if (closed && (last - first) % 2 == 0) continue;  // there and back: it encloses nothing
      *end++ = {one.link, std::all_of(first, last, [](const ChangedLink& each) { return each.is_changed; })};
    }
    links.erase(end, links.end());
  }

  void note_bound(int node, int straight) {
    auto& [one, other] = bounds_[at(node)];
    if (one == straight || other == straight) return;
    (one == none ? one : other) = straight;
  }

  [[nodiscard]] bool has_bound(int node, int straight) const {
    return straight == none || bounds_[at(node)][0] == straight || bounds_[at(node)][1] == straight;
  }

  // Boundary and holes would not bend.
  [[nodiscard]] bool may_join(int node, int into) const {
    return has_bound(into, bounds_[at(node)][0]) && has_bound(into, bounds_[at(node)][1]);
  }

  // The lower stay where they are: corners of boundary and holes, what lies on these, crossings, so that lines stay
  // straight, ends and corners as drawn, ends of what was prolonged.
  [[nodiscard]] int rank(int node) const {
    const auto& [one, other] = bounds_[at(node)];
    if (one != none) return other != none ? 0 : 1;
    if (is_drawn_[at(node)]) return 3;
    return links_at_[at(node)] > 1 ? 2 : 4;
  }

  // An end drawn within a step of the grid beside the boundary counts as on it, and would bend it by as much.
  void put_on_bounds() {
    constexpr double few_ulps = 16 * std::numeric_limits<double>::epsilon();
    for (std::size_t node = 0; node < bounds_.size(); ++node) {
      const auto [straight, other] = bounds_[node];
      if (straight == none || other != none) continue;
      Vec2& position = noding_.positions[node];
      const Vec2 foot =
          closest_point({pieces_.straights[at(straight)].from, pieces_.straights[at(straight)].to}, position);
      if ((foot - position).norm() > few_ulps * position.cwiseAbs().maxCoeff()) position = foot;
    }
  }

  // A node that lines only pass, as where lines along each other cross by round-off, is taken away; to one where links
  // end, as prolongations do, nothing is joined.
  bool take_away_passed() {
    const auto goal = [&](int node) {
      while (into_[at(node)] != node) node = into_[at(node)];
      return node;
    };
    PassedNodes found = passed_nodes(noding_, is_dropped_, is_drawn_);
    is_tip_ = std::move(found.is_tip);
    for (const auto& [node, one, other] : found.passed) into_[at(node)] = goal(one) != node ? goal(one) : goal(other);
    for (int& into : into_) into = goal(into);
    return !found.passed.empty();
  }

  [[nodiscard]] double distance_of(int a, int b) const {
    return (noding_.positions[at(a)] - noding_.positions[at(b)]).norm();
  }

  [[nodiscard]] bool is_unseen(const PixelBox& box) const { return region_.meets(box); }
  [[nodiscard]] bool is_unseen_node(std::size_t node) const {
    return is_unseen({noding_.pixels[node], noding_.pixels[node]});
  }

  [[nodiscard]] std::vector<std::pair<int, int>> near_pairs() const {
    std::vector<Box> boxes;
    const std::vector<std::size_t> nodes =
        numbers_where(noding_.positions.size(), [&](std::size_t node) { return is_unseen_node(node); });
    for (const std::size_t node : nodes) {
      const Vec2& position = noding_.positions[node];
      boxes.push_back(expanded(Box{position, position}, round_off_ / 2));
    }
    std::vector<std::pair<int, int>> pairs = overlapping_pairs(boxes);
    for (auto& [a, b] : pairs) {
      a = static_cast<int>(nodes[at(a)]);
      b = static_cast<int>(nodes[at(b)]);
    }
    std::erase_if(pairs, [&](const auto& pair) {
      const auto& [a, b] = pair;
      return is_tip_[at(a)] || is_tip_[at(b)] || distance_of(a, b) > round_off_;
    });
    return pairs;
  }

  // The nearest of those that stay: what goes to one of them then lies between no two that go to another.
  bool join_nodes() {
    std::vector<std::pair<int, int>> pairs = near_pairs();
    for (std::size_t i = pairs.size(); i-- > 0;) pairs.emplace_back(pairs[i].second, pairs[i].first);
    const auto key = [&](int node) { return std::pair(rank(node), node); };
    std::sort(pairs.begin(), pairs.end(), [&](const auto& a, const auto& b) {
      return std::pair(key(a.first), a.second) < std::pair(key(b.first), b.second);
    });
    const auto visit = [&](auto&& each) {
      for (auto first = pairs.begin(), last = first; first != pairs.end(); first = last) {
        while (last != pairs.end() && last->first == first->first) ++last;
        each(first->first, first, last);
      }
    };
    std::vector<bool> stays(into_.size(), true);
    std::vector<bool> seen(into_.size(), false);
    visit([&](int node, auto first, auto last) {
      seen[at(node)] = true;
      stays[at(node)] = std::none_of(first, last, [&](const auto& pair) {
        return seen[at(pair.second)] && stays[at(pair.second)] && may_join(node, pair.second);
      });
    });
    bool any = false;
    visit([&](int node, auto first, auto last) {
      if (stays[at(node)]) return;
      double least = 0;
      for (auto pair = first; pair != last; ++pair) {
        if (!stays[at(pair->second)] || !may_join(node, pair->second)) continue;
        const double way = distance_of(node, pair->second);
        if (into_[at(node)] != node && way >= least) continue;
        least = way;
        into_[at(node)] = pair->second;
      }
      note(noding_.positions[at(node)], noding_.positions[at(into_[at(node)])]);
      any = true;
    });
    return any;
  }

  [[nodiscard]] Link joined(const Link& link) const {
    const auto [from, to] = std::minmax(into_[at(link.from)], into_[at(link.to)]);
    return {from, to, link.straight};
  }

  void find_detours() {
    const std::vector<std::size_t> links = numbers_where(noding_.links.size(), [&](std::size_t i) {
      const Link link = joined(noding_.links[i]);
      return link.from != link.to && is_unseen(box_between(link.from, link.to));
    });
    std::vector<Piece> pieces;
    for (const std::size_t i : links) {
      const Link link = joined(noding_.links[i]);
      pieces.push_back({{noding_.pixels[at(link.from)], noding_.pixels[at(link.to)]}, link.straight});
    }
    const std::vector<std::size_t> nodes = numbers_where(into_.size(), [&](std::size_t node) {
      return at(into_[node]) == node && !is_tip_[node] && is_unseen_node(node);
    });
    std::vector<Pixel> pixels;
    for (const std::size_t node : nodes) pixels.push_back(noding_.pixels[node]);
    const double steps = steps_of_round_off(pieces_);
    std::vector<std::vector<Detour>> parts(most_parts_of_plane);
    visit_meetings(
        pieces, pixels, steps, [&](std::size_t part, std::span<const NearPiece> crowd, std::span<const NearNode> near) {
          for (const NearPiece& piece : crowd) {
            for (const NearNode& node : near)
              add_detour(static_cast<int>(links[at(piece.piece)]), static_cast<int>(nodes[at(node.node)]), parts[part]);
          }
        });
    detours_ = in_one_list(std::move(parts));
    std::sort(detours_.begin(), detours_.end(), [](const Detour& a, const Detour& b) {
      return std::tie(a.link, a.share, a.node) < std::tie(b.link, b.share, b.node);
    });
    move_onto_bounds();
  }

  void add_detour(int number, int node, std::vector<Detour>& found) const {
    const Link link = joined(noding_.links[at(number)]);
    if (node == link.from || node == link.to) return;
    const Segment way{noding_.positions[at(link.from)], noding_.positions[at(link.to)]};
    const double share = closest_parameter(way, noding_.positions[at(node)]);
    if (share <= 0 || share >= 1 || distance(way, noding_.positions[at(node)]) > share_beside_links * round_off_)
      return;
    const bool is_kept =
        is_bound(pieces_, link.straight, plan_) && bounds_[at(node)][0] != none;  // two that would not bend
    if (!is_kept) found.push_back({number, share, node});
  }

  // Links of boundary and holes do not bend: the node moves.
  void move_onto_bounds() {
    for (const Detour& detour : detours_) {
      const Link link = joined(noding_.links[at(detour.link)]);
      Vec2& position = noding_.positions[at(detour.node)];
      const Vec2 foot = point_at({noding_.positions[at(link.from)], noding_.positions[at(link.to)]}, detour.share);
      if (!is_repeated(detour.link)) note(position, foot);
      if (!is_bound(pieces_, link.straight, plan_)) continue;
      position = foot;
      noding_.pixels[at(detour.node)] = pieces_.grid.pixel_of(foot);
      is_moved_[at(detour.node)] = true;
    }
  }

  // True where the link before this one joins the same nodes along another straight.
  [[nodiscard]] bool is_repeated(int link) const {
    if (link == 0) return false;
    const Link one = joined(noding_.links[at(link - 1)]);
    const Link other = joined(noding_.links[at(link)]);
    return one.from == other.from && one.to == other.to;
  }

  [[nodiscard]] PixelBox box_between(int a, int b) const {
    return box_of({noding_.pixels[at(a)], noding_.pixels[at(b)]});
  }

  void lead_links(Renoding& changed) const {
    auto detour = detours_.begin();
    const auto add = [&](int a, int b, int straight, bool is_changed) {
      if (a == b) return;
      changed.links.push_back({{std::min(a, b), std::max(a, b), straight}, is_changed});
      if (is_changed) changed.places.push_back(box_between(a, b));
    };
    for (std::size_t i = 0; i < noding_.links.size(); ++i) {
      const Link& old = noding_.links[i];
      const Link link = joined(old);
      const bool is_led = detour != detours_.end() && at(detour->link) == i;
      const bool is_changed =
          is_dropped_[i] || is_led || !(link == old) || is_moved_[at(link.from)] || is_moved_[at(link.to)];
      if (is_changed) changed.places.push_back(box_between(old.from, old.to));
      if (is_dropped_[i]) continue;
      int from = link.from;
      for (; detour != detours_.end() && at(detour->link) == i; ++detour) {
        add(from, detour->node, link.straight, true);
        from = detour->node;
      }
      add(from, link.to, link.straight, is_changed);
    }
  }

  void note(const Vec2& from, const Vec2& to) {
    const double size = (to - from).norm();
    if (size > pieces_.grid.step()) cleaned_.push_back({Cleaning::round_off_closed, from, to, size, {}});
  }

  Noding& noding_;
  const PlanPieces& pieces_;
  const RockPlan& plan_;
  std::vector<Cleaned>& cleaned_;
  double round_off_;
  std::int64_t reach_;  // pixels around what changed in which something else may be near it
  PixelRegion region_;
  bool has_compared_ = false;
  std::vector<int> into_;                   // by node: that which it becomes, itself where it stays
  std::vector<bool> is_drawn_;              // by node
  std::vector<std::array<int, 2>> bounds_;  // by node: straights of boundary and holes that it lies on
  std::vector<int> links_at_;
  std::vector<bool> is_tip_;
  std::vector<bool> is_moved_;
  std::vector<bool> is_dropped_;  // by link
  std::vector<Detour> detours_;
};

}  // namespace

Noding welded(Noding noding, const PlanPieces& pieces, const RockPlan& plan, std::vector<Cleaned>& cleaned,
              int most_rounds) {
  Places unseen = std::move(noding.crowded);
  for (int round = 0; round < most_rounds; ++round) {
    Welder welder(noding, pieces, plan, unseen, cleaned);
    if (!welder.weld()) return noding;
    const std::size_t noded = noding.pieces_noded, looked_at = noding.pairs_looked_at;
    const Renoding changed = welder.renoding();
    if (welder.has_compared())
      unseen = changed.places;
    else
      unseen.insert(unseen.end(), changed.places.begin(), changed.places.end());
    noding = node_again(changed, pieces.straights, pieces.grid);
    noding.pieces_noded += noded;
    noding.pairs_looked_at += looked_at;
  }
  noding.is_unfinished = true;
  return noding;
}

}  // namespace dda
