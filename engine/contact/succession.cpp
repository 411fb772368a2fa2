#include "engine/contact/succession.h"

#include <algorithm>
#include <tuple>

#include "engine/contact/covered_corners.h"

namespace dda {
namespace {

constexpr double least_way = 1e-5;  // of an edge's length: how far past its end a vertex has left it

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

Succession::Succession(const std::vector<VertexContact>& known, const std::vector<VertexContact>& found,
                       const std::vector<bool>& of_faces, const Outlines& outlines)
    : known_(known), outlines_(outlines), taken_(known.size(), false), earlier_(found.size(), -1) {
  continue_by(&Succession::same, found);
  continue_by(&Succession::next_edge, found);
  for (const Rule rule : {&Succession::gone_over_a_joint, &Succession::back_over_a_joint})
    for (std::size_t i = 0; i < found.size(); ++i)
      if (earlier_[i] < 0 && !of_faces[i]) earlier_[i] = (this->*rule)(found[i]);
  continue_by(&Succession::exchanged, found);
  continue_by(&Succession::over_a_joint, found);
  some_have_ended_ = std::ranges::find(taken_, false) != taken_.end();  // seldom
}

void Succession::continue_by(Rule rule, const std::vector<VertexContact>& found) {
  for (std::size_t i = 0; i < found.size(); ++i)
    if (earlier_[i] < 0) earlier_[i] = (this->*rule)(found[i]);
}

// Calls act(index) for every known contact of a vertex.
template <typename Act>
void Succession::for_each_at(int vertex, Act act) {
  if (by_vertex_.size() != known_.size()) list_by_vertex();
  const auto first = std::lower_bound(by_vertex_.begin(), by_vertex_.end(), std::pair{vertex, std::size_t{0}});
  for (auto known = first; known != by_vertex_.end() && known->first == vertex; ++known) act(known->second);
}

// Calls act(index) for every known contact on an edge.
template <typename Act>
void Succession::for_each_on(int edge, Act act) const {
  const auto begin = std::lower_bound(known_.begin(), known_.end(), contact_named(edge, 0));
  for (auto known = begin; known != known_.end() && known->edge == edge; ++known)
    act(static_cast<std::size_t>(known - known_.begin()));
}

// Which of two corners above each other is the vertex of a known contact, either block's numbering may say, so that
// both are looked for. What is new because corners drawn in one point are past each other by round-off takes nothing
// over.
std::vector<Succession::InLine> Succession::in_line_with(const VertexContact& contact) {
  std::vector<InLine> found;
  const double apart = least_way * outlines_.along(contact.edge).norm();
  const auto look = [&](std::size_t i, const Vec2& normal) {
    const VertexContact& known = known_[i];
    const double distance = (outlines_.current[at(known.vertex)] - outlines_.current[at(contact.vertex)]).norm();
    if (known.normal.dot(normal) < same_direction || (distance < apart && !has_left(known))) return;
    found.push_back({i, distance, blocks_of(known) == blocks_of(contact)});
  };
  const auto look_at_face = [&](int edge, const Vec2& normal) {
    for_each_on(edge, [&](std::size_t i) { look(i, normal); });
    for (const int end : {edge, outlines_.next[at(edge)]}) for_each_at(end, [&](std::size_t i) { look(i, -normal); });
  };
  look_at_face(contact.edge, contact.normal);
  for (const int edge : {contact.vertex, outlines_.previous[at(contact.vertex)]}) look_at_face(edge, -contact.normal);
  return found;
}

std::ptrdiff_t Succession::beside(const VertexContact& contact, std::span<const InterfaceState> states) {
  const std::vector<InLine> found = in_line_with(contact);
  if (found.empty()) return -1;
  const double nearest = std::ranges::min(found, {}, &InLine::distance).distance;
  const double one_place = nearest + in_line * outlines_.along(contact.edge).norm();
  const auto rank = [&](const InLine& each) {
    return std::tuple(each.distance > one_place, !each.same_blocks, -states[each.index].force(0));
  };
  return static_cast<std::ptrdiff_t>(std::ranges::min(found, {}, rank).index);
}

// Whether the vertex of a known contact is past the end of its edge by more than round-off. Corners drawn in one point
// are so but for that, and it must not move loads.
bool Succession::has_left(const VertexContact& known) const {
  const Vec2 along = outlines_.along(known.edge);
  const Vec2 offset = outlines_.current[at(known.vertex)] - outlines_.current[at(known.edge)];
  const double place = offset.dot(along) / along.squaredNorm();
  return std::max(-place, place - 1) > least_way;
}

std::ptrdiff_t Succession::same(const VertexContact& contact) {
  return take(contact.edge, contact.vertex, contact.normal);
}

std::ptrdiff_t Succession::next_edge(const VertexContact& contact) {
  const auto before = take(outlines_.previous[at(contact.edge)], contact.vertex, contact.normal);
  return before >= 0 ? before : take(outlines_.next[at(contact.edge)], contact.vertex, contact.normal);
}

// Looks at that corner of the edge which the vertex is near: the other one is the other end of a common stretch.
std::ptrdiff_t Succession::exchanged(const VertexContact& contact) {
  const int corner = nearer_end(outlines_, contact);
  for (const int edge : {contact.vertex, outlines_.previous[at(contact.vertex)]})
    if (const auto known = take(edge, corner, -contact.normal); known >= 0) return known;
  return -1;
}

std::ptrdiff_t Succession::ended_beside(const VertexContact& contact) {
  return some_have_ended_ ? exchanged(contact) : -1;
}

template <typename Condition>
std::ptrdiff_t Succession::of_vertex(const VertexContact& contact, Condition condition) {
  std::ptrdiff_t index = -1;
  for_each_at(contact.vertex, [&](std::size_t i) {
    if (index < 0 && condition(known_[i]))
      index = take(known_.begin() + static_cast<std::ptrdiff_t>(i), contact.normal);
  });
  return index;
}

std::ptrdiff_t Succession::gone_over_a_joint(const VertexContact& contact) {
  return of_vertex(contact, [this](const VertexContact& known) { return has_left(known); });
}

std::ptrdiff_t Succession::over_a_joint(const VertexContact& contact) {
  return of_vertex(contact, [](const VertexContact& /*known*/) { return true; });
}

// The corner that is left behind was the vertex while both were above each other.
std::ptrdiff_t Succession::back_over_a_joint(const VertexContact& contact) {
  std::ptrdiff_t index = -1;
  for (const int edge : {contact.vertex, outlines_.previous[at(contact.vertex)]})
    for_each_on(edge, [&](std::size_t i) {
      const std::size_t behind = at(known_[i].vertex), ahead = at(contact.vertex);
      const double way = (outlines_.coming[behind] - outlines_.coming[ahead]).norm();
      const double length = outlines_.along(edge).norm();
      const double distance = (outlines_.current[behind] - outlines_.current[ahead]).norm();
      if (index < 0 && distance > least_way * length && distance <= 2 * in_line * length + 2 * way)
        index = take(known_.begin() + static_cast<std::ptrdiff_t>(i), -contact.normal);
    });
  return index;
}

void Succession::list_by_vertex() {
  for (std::size_t i = 0; i < known_.size(); ++i) by_vertex_.emplace_back(known_[i].vertex, i);
  std::sort(by_vertex_.begin(), by_vertex_.end());
}

std::ptrdiff_t Succession::take(int edge, int vertex, const Vec2& normal) {
  const VertexContact wanted = contact_named(edge, vertex);
  const auto place = std::lower_bound(known_.begin(), known_.end(), wanted);
  return place == known_.end() || wanted < *place ? -1 : take(place, normal);
}

std::ptrdiff_t Succession::take(std::vector<VertexContact>::const_iterator place, const Vec2& normal) {
  if (place->normal.dot(normal) < same_direction) return -1;
  const std::ptrdiff_t index = place - known_.begin();
  if (taken_[static_cast<std::size_t>(index)]) return -1;
  taken_[static_cast<std::size_t>(index)] = true;
  return index;
}

}  // namespace dda
