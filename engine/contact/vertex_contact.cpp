#include "engine/contact/vertex_contact.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

void take_out(const std::vector<char>& out, std::vector<VertexContact>& contacts) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (out[i] == 0) contacts[kept++] = contacts[i];
  contacts.resize(kept);
}

int facing_edge(const Outlines& outlines, const VertexContact& contact) {
  const Vec2 along = outlines.along(contact.edge);
  const auto runs_along = [&](int edge) { return std::abs(along.dot(outlines.along(edge).normalized())); };
  const int before = outlines.previous[at(contact.vertex)];
  return runs_along(contact.vertex) >= runs_along(before) ? contact.vertex : before;
}

int nearer_end(const Outlines& outlines, const VertexContact& contact) {
  const Vec2& vertex = outlines.current[at(contact.vertex)];
  const int end = outlines.next[at(contact.edge)];
  const bool at_end =
      (outlines.current[at(end)] - vertex).norm() < (outlines.current[at(contact.edge)] - vertex).norm();
  return at_end ? end : contact.edge;
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

}  // namespace dda
