#include "engine/contact/real_overlap.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "engine/core/sort_few.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr double true_share = 0.05;  // of the gap, by which the overlap must be there
constexpr double flat = 0.99;        // cosine from which two faces lie on each other
constexpr double nearby = 3;         // gaps from a vertex, within which another way out changes whether it is needed

// One block's claims on another, the vertex' block being moved by `shift`.
class Claim {
 public:
  Claim(const Outlines& outlines, const Cover& cover, const Vec2& shift)
      : outlines_(outlines),
        contact_(cover.contact),
        shift_(shift),
        point_(outlines.current[at(cover.contact.vertex)] + shift),
        gap_(cover.contact.gap + shift.dot(cover.contact.normal)) {}

  [[nodiscard]] bool is_true() const {
    if (is_inside(contact_.edge_block, point_, -true_share * gap_)) return true;
    return is_true_of_face(contact_.vertex) || is_true_of_face(outlines_.previous[at(contact_.vertex)]);
  }

 private:
  // Whether the point is in the block, at least `margin` (m) from its outline.
  [[nodiscard]] bool is_inside(int block, const Vec2& point, double margin) const {
    bool inside = false;
    for (int edge = outlines_.starts[at(block)]; edge < outlines_.starts[at(block) + 1]; ++edge) {
      const Segment side = segment_of(edge);
      if ((closest_point(side, point) - point).squaredNorm() < margin * margin) return false;
      if ((side.start.y() > point.y()) == (side.end.y() > point.y())) continue;
      if ((cross(side.end - side.start, point - side.start) > 0) == (side.end.y() > side.start.y())) inside = !inside;
    }
    return inside;
  }

  [[nodiscard]] Segment segment_of(int edge) const {
    return {outlines_.current[at(edge)], outlines_.current[at(outlines_.next[at(edge)])]};
  }

  [[nodiscard]] bool is_true_of_face(int face) const {
    if (normal_of(outlines_, face).dot(contact_.normal) > -flat) return false;
    const int edge = contact_.edge;
    return is_end_inside(edge, face) || is_end_inside(outlines_.next[at(edge)], face) || is_middle_inside(face);
  }

  // An end of the edge, behind the face and in its block.
  [[nodiscard]] bool is_end_inside(int end, int face) const {
    const Segment own = segment_of(face);
    const Vec2 offset = outlines_.current[at(end)] - shift_ - own.start;
    const double length = (own.end - own.start).norm();
    const Vec2 along = (own.end - own.start) / length;
    const double gap = cross(offset, along);
    const double place = offset.dot(along);
    if (gap >= 0 || place < 2 * gap || place > length - 2 * gap) return false;
    return faces(end, Vec2(along.y(), -along.x())) &&
           is_inside(contact_.vertex_block, outlines_.current[at(end)] - shift_, -true_share * gap);
  }

  // Whether the corner's edges leave on the side of the normal.
  [[nodiscard]] bool faces(int corner, const Vec2& normal) const {
    return outlines_.along(corner).normalized().dot(normal) >= -entrance_slack &&
           outlines_.along(outlines_.previous[at(corner)]).normalized().dot(normal) <= entrance_slack;
  }

  // The middle of that part of the face which is over the edge and behind its line.
  [[nodiscard]] bool is_middle_inside(int face) const {
    const Segment edge = segment_of(contact_.edge);
    const Segment own = segment_of(face);
    const double length = (edge.end - edge.start).norm();
    const Vec2 along = (edge.end - edge.start) / length;
    const Vec2 start = own.start + shift_ - edge.start;
    const Vec2 run = own.end - own.start;
    double low = std::clamp(-start.dot(along) / run.dot(along), 0.0, 1.0);  // shares of the face
    double high = std::clamp((length - start.dot(along)) / run.dot(along), 0.0, 1.0);
    if (low == high) return false;
    const auto gap = [&](double share) { return cross(start + share * run, along); };
    const double at_low = gap(low);
    const double at_high = gap(high);
    if (at_low > 0 && at_high > 0) return false;
    if (at_low > 0) low += (high - low) * at_low / (at_low - at_high);
    if (at_high > 0) high = low + (high - low) * at_low / (at_low - at_high);
    const double middle = (low + high) / 2;
    const Vec2 point = point_at(own, middle);
    const double depth = -gap(middle);
    return depth > 0 && (is_inside(contact_.edge_block, point + shift_, true_share * depth) ||
                         is_inside(contact_.vertex_block, point + depth * contact_.normal, true_share * depth));
  }

  const Outlines& outlines_;
  const VertexContact& contact_;
  Vec2 shift_;
  Vec2 point_;
  double gap_;
};

bool are_nearby(const Outlines& outlines, const Cover& deep, const Cover& shallow) {
  const Vec2 apart = outlines.current[at(shallow.contact.vertex)] - outlines.current[at(deep.contact.vertex)];
  return apart.norm() <= -nearby * deep.contact.gap;
}

// A true claim of a cover that the vertex is on.
bool is_way_out(const Cover& cover) { return cover.counts && cover.beyond <= 0; }

// Whether the deep cover's claim holds where the shallow one's way out has been taken.
bool is_needed_after(const Outlines& outlines, const Cover& deep, const Cover& shallow) {
  const double side = deep.contact.vertex_block == shallow.contact.vertex_block ? 1 : -1;
  const Vec2 way_out = -side * shallow.contact.gap * shallow.contact.normal;
  if (deep.contact.gap + way_out.dot(deep.contact.normal) >= true_share * deep.contact.gap)
    return true;  // the same way
  return Claim(outlines, deep, way_out).is_true();
}

// Whether the ends of `b` lie on different sides of the line of `a`, at least `margin` (m) from it.
bool leads_over(const Segment& a, const Segment& b, double margin) {
  const Vec2 along = (a.end - a.start).normalized();
  const double start = cross(along, b.start - a.start);
  const double end = cross(along, b.end - a.start);
  return std::min(start, end) < -margin && std::max(start, end) > margin;
}

// Whether some edges of the blocks cross and go on for at least `margin` (m) behind each other.
bool outlines_cross(const Outlines& outlines, int a, int b, double margin) {
  const auto edge = [&](int i) { return Segment{outlines.current[at(i)], outlines.current[at(outlines.next[at(i)])]}; };
  for (int i = outlines.starts[at(a)]; i < outlines.starts[at(a) + 1]; ++i)
    for (int j = outlines.starts[at(b)]; j < outlines.starts[at(b) + 1]; ++j)
      if (leads_over(edge(i), edge(j), margin) && leads_over(edge(j), edge(i), margin)) return true;
  return false;
}

// The shallowest way out, where the outlines cross by as much as its gap makes one expect. Faces in line that round-off
// lets cross do not.
void keep_where_corners_passed(const Outlines& outlines, const std::vector<Cover*>& pressed) {
  const auto first = std::find_if(pressed.begin(), pressed.end(), [](const Cover* each) { return each->beyond <= 0; });
  if (first == pressed.end()) return;
  const VertexContact& contact = (*first)->contact;
  (*first)->counts = outlines_cross(outlines, contact.edge_block, contact.vertex_block, -true_share * contact.gap);
}

}  // namespace

void drop_unreal(const Outlines& outlines, double round_off, std::vector<Cover>& covers, std::vector<Cover*>& pressed) {
  pressed.clear();
  for (Cover& cover : covers)
    if (cover.contact.gap < -round_off) pressed.push_back(&cover);
  if (pressed.empty()) return;
  sort_few(pressed, [](const Cover* i, const Cover* j) { return i->contact.gap > j->contact.gap; });
  for (auto each = pressed.begin(); each != pressed.end(); ++each) {
    Cover& cover = **each;
    cover.counts = Claim(outlines, cover, Vec2::Zero()).is_true();
    if (!is_way_out(cover)) continue;
    cover.counts = std::all_of(pressed.begin(), each, [&](const Cover* shallow) {
      return !is_way_out(*shallow) || !are_nearby(outlines, cover, *shallow) ||
             is_needed_after(outlines, cover, *shallow);
    });
  }
  if (std::ranges::none_of(pressed, [](const Cover* cover) { return is_way_out(*cover); }))
    keep_where_corners_passed(outlines, pressed);
  std::erase_if(covers, [](const Cover& cover) { return !cover.counts; });
}

}  // namespace dda
