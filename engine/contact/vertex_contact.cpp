#include "engine/contact/vertex_contact.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr double notch_turn = 0.1;  // sine of the turn beyond which a reflex corner is a notch with two sides

struct Candidate {
  VertexContact contact;
  int corner = -1;  // vertex of the edge's block that the vertex meets, where that is no notch
  int notch = -1;   // vertex of the notch at the edge's end that the vertex meets or has gone past
};

// One block's vertices against another's edges.
class Side {
 public:
  Side(const Outlines& outlines, int vertex_block, int edge_block, double reach, double depth, double corner)
      : outlines_(outlines),
        vertex_block_(vertex_block),
        edge_block_(edge_block),
        reach_(reach),
        depth_(depth),
        corner_(corner) {}

  void collect(std::vector<Candidate>& found) const {
    const Box near = expanded(outlines_.boxes[at(edge_block_)], reach_);
    for (int vertex = first(vertex_block_); vertex < last(vertex_block_); ++vertex) {
      const Vec2& point = outlines_.current[at(vertex)];
      if ((point.array() < near.lower.array()).any() || (point.array() > near.upper.array()).any()) continue;
      const std::size_t before = found.size();
      for (int edge = first(edge_block_); edge < last(edge_block_); ++edge) try_pair(vertex, edge, found);
      if (found.size() - before > 1) keep_nearest(before, found);
    }
  }

 private:
  [[nodiscard]] int first(int block) const { return outlines_.starts[at(block)]; }
  [[nodiscard]] int last(int block) const { return outlines_.starts[at(block) + 1]; }

  void try_pair(int vertex, int edge, std::vector<Candidate>& found) const {
    const int end = outlines_.next[at(edge)];
    const Vec2& start = outlines_.current[at(edge)];
    const Vec2 along = outlines_.along(edge);
    const Vec2 offset = outlines_.current[at(vertex)] - start;
    const double squared = along.squaredNorm();
    const double gap_by_length = offset.x() * along.y() - offset.y() * along.x();
    if (gap_by_length * gap_by_length > squared * std::max(reach_ * reach_, depth_ * depth_)) return;
    const double length = std::sqrt(squared);
    const double gap = gap_by_length / length;
    const double place = offset.dot(along) / length;
    const int nearer = place < length / 2 ? edge : end;
    const double inside = std::min(place, length - place);  // negative beyond an end
    const bool notch = inside <= corner_ && is_notch(nearer);
    const Vec2 normal = Vec2(along.y(), -along.x()) / length;
    if (inside < -(notch ? reach_ : corner_) || gap > reach_ || gap < -depth_ || !enters(vertex, normal)) return;
    found.push_back({{edge_block_, vertex_block_, edge, vertex, normal, gap},
                     inside <= corner_ && !notch ? nearer : -1,
                     notch ? nearer : -1});
  }

  [[nodiscard]] bool is_notch(int vertex) const {
    const Vec2 in = outlines_.along(outlines_.previous[at(vertex)]);
    const Vec2 out = outlines_.along(vertex);
    return in.x() * out.y() - in.y() * out.x() < -notch_turn * in.norm() * out.norm();
  }

  [[nodiscard]] bool enters(int vertex, const Vec2& normal) const {
    const Vec2& point = outlines_.current[at(vertex)];
    const auto stays_outside = [&](int neighbour) {
      const Vec2 edge = outlines_.current[at(neighbour)] - point;
      return normal.dot(edge) >= -entrance_slack * edge.norm();
    };
    return stays_outside(outlines_.next[at(vertex)]) && stays_outside(outlines_.previous[at(vertex)]);
  }

  // True when the way out through `deep` would lead the vertex past the line of `shallow` first.
  [[nodiscard]] bool is_behind(const VertexContact& deep, const VertexContact& shallow) const {
    return deep.gap < std::min(0.0, shallow.gap) && shallow.gap - deep.gap * deep.normal.dot(shallow.normal) <= corner_;
  }

  // Edges that bound a notch do not hide each other: a vertex pressed into it is behind both.
  [[nodiscard]] bool bounds_notch_of(const Candidate& deep, const Candidate& shallow) const {
    return shallow.notch >= 0 &&
           (deep.contact.edge == shallow.notch || outlines_.next[at(deep.contact.edge)] == shallow.notch);
  }

  // A vertex inside a block has come in through the edge nearest to it. Only in a notch it is behind two at once.
  void keep_nearest(std::size_t begin, std::vector<Candidate>& found) const {
    const std::vector<Candidate> all(found.begin() + static_cast<std::ptrdiff_t>(begin), found.end());
    const auto is_hidden = [&](const Candidate& deep) {
      return deep.notch < 0 && std::any_of(all.begin(), all.end(), [&](const Candidate& shallow) {
               return !bounds_notch_of(deep, shallow) && is_behind(deep.contact, shallow.contact);
             });
    };
    found.erase(std::remove_if(found.begin() + static_cast<std::ptrdiff_t>(begin), found.end(), is_hidden),
                found.end());
  }

  const Outlines& outlines_;
  int vertex_block_;
  int edge_block_;
  double reach_;
  double depth_;
  double corner_;
};

bool of_same_corners(const Candidate& a, const Candidate& b) {
  return std::minmax(a.contact.vertex, a.corner) == std::minmax(b.contact.vertex, b.corner);
}

// Among contacts of the same two corners keeps the first with the largest gap.
void keep_one_a_corner(std::vector<Candidate>& found) {
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i].corner < 0) continue;
    for (std::size_t j = found.size() - 1; j > i; --j) {
      if (found[j].corner < 0 || !of_same_corners(found[i], found[j])) continue;
      if (found[j].contact.gap > found[i].contact.gap) std::swap(found[i], found[j]);
      found.erase(found.begin() + static_cast<std::ptrdiff_t>(j));
    }
  }
}

}  // namespace

int facing_edge(const Outlines& outlines, const VertexContact& contact) {
  const Vec2 along = outlines.along(contact.edge);
  const auto runs_along = [&](int edge) { return std::abs(along.dot(outlines.along(edge).normalized())); };
  const int before = outlines.previous[at(contact.vertex)];
  return runs_along(contact.vertex) >= runs_along(before) ? contact.vertex : before;
}

double common_length(const Outlines& outlines, const VertexContact& contact) {
  const Vec2 along = outlines.along(contact.edge);
  const double length = along.norm();
  const int facing = facing_edge(outlines, contact);
  const auto place = [&](int vertex) {
    return (outlines.current[at(vertex)] - outlines.current[at(contact.edge)]).dot(along) / length;
  };
  const auto [low, high] = std::minmax({place(facing), place(outlines.next[at(facing)])});
  return std::max(0.0, std::min(high, length) - std::max(low, 0.0));
}

void find_vertex_contacts(const Outlines& outlines, int a, int b, double reach, double depth, double corner,
                          std::vector<VertexContact>& found) {
  std::vector<Candidate> candidates;
  Side(outlines, a, b, reach, depth, corner).collect(candidates);
  Side(outlines, b, a, reach, depth, corner).collect(candidates);
  keep_one_a_corner(candidates);
  for (const Candidate& each : candidates) found.push_back(each.contact);
}

}  // namespace dda
