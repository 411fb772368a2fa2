#include "engine/cutting/weld.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "engine/cutting/needless_prolongations.h"
#include "engine/cutting/quadrants.h"
#include "engine/geometry/box_pairs.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

constexpr double share_of_tolerance = 1e-2;
constexpr double least_steps = 4;  // of the grid: twice what rounding moves a node, on either side
constexpr int most_rounds = 20;    // two do; more only where welding brings other places together
constexpr int none = -1;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// A link that passes a node that it should go through.
struct Detour {
  int link = 0;
  double share = 0;  // of the link, at the node
  int node = 0;
};

// One round: which nodes become one, where links have to be led, and the pieces that come of it.
class Welder {
 public:
  Welder(Noding& noding, const PlanPieces& pieces, const RockPlan& plan, std::vector<Cleaned>& cleaned)
      : noding_(noding),
        pieces_(pieces),
        plan_(plan),
        cleaned_(cleaned),
        round_off_(round_off_of(pieces)),
        into_(noding.pixels.size()),
        bounds_(noding.pixels.size(), {none, none}),
        links_at_(noding.pixels.size(), 0),
        is_tip_(noding.pixels.size(), false),
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
    const bool any_joined = join_nodes();
    find_detours();
    return any_joined || !detours_.empty();
  }

  [[nodiscard]] std::vector<Piece> new_pieces() {
    std::vector<Link> links = led_links();
    std::sort(links.begin(), links.end());
    std::vector<Piece> pieces;
    for (std::size_t first = 0, last = 0; first < links.size(); first = last) {
      while (last < links.size() && links[last] == links[first]) ++last;
      const Link& link = links[first];
      const bool closed = pieces_.sources[at(link.straight)].curve != no_curve;
      if (closed && (last - first) % 2 == 0) continue;  // there and back: it encloses nothing
      pieces.push_back({{noding_.pixels[at(link.from)], noding_.pixels[at(link.to)]}, link.straight});
    }
    return pieces;
  }

  [[nodiscard]] std::vector<KnownNode> nodes_left() const {
    std::vector<KnownNode> left;
    for (std::size_t node = 0; node < into_.size(); ++node) {
      if (at(into_[node]) == node) left.push_back({noding_.pixels[node], noding_.positions[node]});
    }
    return left;
  }

 private:
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

  [[nodiscard]] bool is_drawn(int node) const {
    const Pixel& pixel = noding_.pixels[at(node)];
    const auto end = std::lower_bound(pieces_.ends.begin(), pieces_.ends.end(), pixel,
                                      [](const KnownNode& a, const Pixel& b) { return a.pixel < b; });
    return end != pieces_.ends.end() && end->pixel == pixel;
  }

  // The lower stay where they are: corners of boundary and holes, what lies on these, crossings, so that lines stay
  // straight, ends and corners as drawn, ends of what was prolonged.
  [[nodiscard]] int rank(int node) const {
    const auto& [one, other] = bounds_[at(node)];
    if (one != none) return other != none ? 0 : 1;
    if (is_drawn(node)) return 3;
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

  // Up to three nodes that links lead to, by node.
  [[nodiscard]] std::vector<std::array<int, 3>> neighbours() const {
    std::vector<std::array<int, 3>> found(into_.size(), {none, none, none});
    const auto add = [&](int node, int other) {
      auto& others = found[at(node)];
      const auto place =
          std::find_if(others.begin(), others.end(), [&](int each) { return each == none || each == other; });
      if (place != others.end()) *place = other;
    };
    for (std::size_t i = 0; i < noding_.links.size(); ++i) {
      if (is_dropped_[i]) continue;
      add(noding_.links[i].from, noding_.links[i].to);
      add(noding_.links[i].to, noding_.links[i].from);
    }
    return found;
  }

  // No line starts, ends or turns at nodes that were not drawn. One that links only pass, as where lines along each
  // other cross by round-off, is taken away; to one where links end, as prolongations do, nothing is joined.
  bool take_away_passed() {
    const auto near = neighbours();
    const auto goal = [&](int node) {
      while (node != none && into_[at(node)] != node) node = into_[at(node)];
      return node;
    };
    bool any = false;
    for (int node = 0; at(node) < into_.size(); ++node) {
      const auto& [one, other, third] = near[at(node)];
      if (third != none || is_drawn(node)) continue;
      is_tip_[at(node)] = other == none;
      if (other == none) continue;
      into_[at(node)] = goal(one) != node ? goal(one) : goal(other);
      any = true;
    }
    for (int& into : into_) into = goal(into);
    return any;
  }

  [[nodiscard]] double distance_of(int a, int b) const {
    return (noding_.positions[at(a)] - noding_.positions[at(b)]).norm();
  }

  [[nodiscard]] std::vector<std::pair<int, int>> near_pairs() const {
    std::vector<Box> boxes;
    boxes.reserve(noding_.positions.size());
    for (const Vec2& position : noding_.positions) boxes.push_back(expanded(Box{position, position}, round_off_ / 2));
    std::vector<std::pair<int, int>> pairs = overlapping_pairs(boxes);
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
    std::vector<Piece> pieces;
    std::vector<int> links;
    for (std::size_t i = 0; i < noding_.links.size(); ++i) {
      const Link link = joined(noding_.links[i]);
      if (link.from == link.to) continue;
      pieces.push_back({{noding_.pixels[at(link.from)], noding_.pixels[at(link.to)]}, link.straight});
      links.push_back(static_cast<int>(i));
    }
    std::vector<Pixel> pixels;
    std::vector<int> nodes;
    for (std::size_t node = 0; node < into_.size(); ++node) {
      if (at(into_[node]) != node || is_tip_[node]) continue;
      pixels.push_back(noding_.pixels[node]);
      nodes.push_back(static_cast<int>(node));
    }
    const double steps = round_off_ / pieces_.grid.step() + least_steps;
    visit_meetings(pieces, pixels, steps, [&](const std::vector<int>& crowd, const std::vector<int>& near) {
      for (const int piece : crowd) {
        for (const int node : near) add_detour(links[at(piece)], nodes[at(node)]);
      }
    });
    std::sort(detours_.begin(), detours_.end(), [](const Detour& a, const Detour& b) {
      return std::tie(a.link, a.share, a.node) < std::tie(b.link, b.share, b.node);
    });
    move_onto_bounds();
  }

  void add_detour(int number, int node) {
    const Link link = joined(noding_.links[at(number)]);
    if (node == link.from || node == link.to) return;
    const Segment way{noding_.positions[at(link.from)], noding_.positions[at(link.to)]};
    const double share = closest_parameter(way, noding_.positions[at(node)]);
    if (share <= 0 || share >= 1 || distance(way, noding_.positions[at(node)]) > round_off_) return;
    const bool is_kept =
        is_bound(pieces_, link.straight, plan_) && bounds_[at(node)][0] != none;  // two that would not bend
    if (!is_kept) detours_.push_back({number, share, node});
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
    }
  }

  // Another straight between the same nodes.
  [[nodiscard]] bool is_repeated(int link) const {
    if (link == 0) return false;
    const Link one = joined(noding_.links[at(link - 1)]);
    const Link other = joined(noding_.links[at(link)]);
    return one.from == other.from && one.to == other.to;
  }

  [[nodiscard]] std::vector<Link> led_links() const {
    std::vector<Link> led;
    auto detour = detours_.begin();
    const auto add = [&](int a, int b, int straight) {
      if (a != b) led.push_back({std::min(a, b), std::max(a, b), straight});
    };
    for (std::size_t i = 0; i < noding_.links.size(); ++i) {
      if (is_dropped_[i]) continue;
      const Link link = joined(noding_.links[i]);
      int from = link.from;
      for (; detour != detours_.end() && at(detour->link) == i; ++detour) {
        add(from, detour->node, link.straight);
        from = detour->node;
      }
      add(from, link.to, link.straight);
    }
    return led;
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
  std::vector<int> into_;                   // by node: that which it becomes, itself where it stays
  std::vector<std::array<int, 2>> bounds_;  // by node: straights of boundary and holes that it lies on
  std::vector<int> links_at_;
  std::vector<bool> is_tip_;
  std::vector<bool> is_dropped_;  // by link
  std::vector<Detour> detours_;
};

}  // namespace

double round_off_of(const PlanPieces& pieces) {
  return std::max(share_of_tolerance * pieces.tolerance, least_steps * pieces.grid.step());
}

Noding welded(Noding noding, const PlanPieces& pieces, const RockPlan& plan, std::vector<Cleaned>& cleaned) {
  for (int round = 0; round < most_rounds; ++round) {
    Welder welder(noding, pieces, plan, cleaned);
    if (!welder.weld()) break;
    noding = node_pieces(welder.new_pieces(), pieces.straights, welder.nodes_left(), pieces.grid);
  }
  return noding;
}

}  // namespace dda
