#include "engine/simulation/shared_edge.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/contact/contact_search.h"
#include "engine/contact/interface_frame.h"

namespace dda {
namespace {

constexpr double aligned = 0.99;  // cosine between surfaces that lie on each other, or nearly so

const Block& block_of(const Model& model, int index) { return model.blocks[static_cast<std::size_t>(index)]; }

template <typename Visit>
void visit_edges(const Polygon& shape, Visit visit) {
  const auto visit_ring = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) visit(Segment{ring[i], ring[(i + 1) % ring.size()]});
  };
  visit_ring(shape.outer);
  for (const Ring& hole : shape.holes) visit_ring(hole);
}

// An edge where it is now, with its outward normal.
struct Line {
  Line(const Model& model, const State& state, int block, const Segment& drawn)
      : start(local_position(model, state, block, drawn.start)),
        length((local_position(model, state, block, drawn.end) - start).norm()),
        along((local_position(model, state, block, drawn.end) - start) / length),
        normal(along.y(), -along.x()) {}

  Vec2 start;
  double length;
  Vec2 along, normal;
};

bool joins(const Interface& interface, const SharedEdge& shared) {
  return std::minmax(interface.block_a, interface.block_b) == std::minmax(shared.block, shared.other);
}

// Length of `line` along which `other` is no further away than where contacts are looked for.
double common_length(const Line& line, const Line& other, double reach) {
  if (line.along.dot(other.along) > -aligned) return 0;
  const double first = line.along.dot(other.start - line.start);
  const double last = first + other.length * line.along.dot(other.along);
  const double low = std::max(0.0, last);
  const double high = std::min(line.length, first);
  if (high <= low) return 0;
  const double share = (first - (low + high) / 2) / (first - last);
  const Vec2 middle = other.start + share * other.length * other.along;
  return std::abs(line.normal.dot(middle - line.start)) <= reach ? high - low : 0;
}

double common_length(const Model& model, const State& state, const Line& line, int other, double reach) {
  double length = 0;
  visit_edges(block_of(model, other).shape,
              [&](const Segment& drawn) { length += common_length(line, Line(model, state, other, drawn), reach); });
  return length;
}

bool is_on(const Line& line, const Vec2& point, double reach) {
  const Vec2 offset = point - line.start;
  const double place = line.along.dot(offset);
  return std::abs(line.normal.dot(offset)) <= reach && place >= -reach && place <= line.length + reach;
}

struct Placed {
  Vec2 point;   // m, of a stretch its middle
  Vec2 normal;  // unit, from a into b
};

Placed placed_now(const Model& model, const State& state, const Interface& interface) {
  if (interface.length == 0) return {local_position(model, state, interface.block_b, interface.from), interface.normal};
  const InterfaceFrame frame = current_frame(model, state, interface);
  return {(frame.from_a + frame.to_a) / 2, frame.normal};
}

// Normal and tangential force of a contact in its own axes, N per m of thickness.
Vec2 force_of(const Model& model, const ContactSet& contacts, std::size_t i) {
  const Interface& interface = contacts.interfaces[i];
  if (interface.length == 0) return contacts.states[i].force.head<2>();
  return interface.length * mean_traction(model, interface, contacts.elements.but_for_blocks(i), contacts.states[i]);
}

// Components along the line's axes. Normal and tangent turn round together when the blocks are exchanged, so that the
// components stay: only the angle between the two surfaces counts.
Vec2 in_axes_of(const Line& line, const Vec2& normal, const Vec2& own) {
  const double side = std::copysign(1, normal.dot(line.normal));
  const double sine = side * cross(line.normal, normal);
  const double cosine = side * line.normal.dot(normal);
  return {cosine * own(0) - sine * own(1), sine * own(0) + cosine * own(1)};
}

}  // namespace

std::optional<SharedEdge> shared_edge(const Model& model, int block, int other, const Vec2& point) {
  const double tolerance = model.length_tolerance;
  std::optional<SharedEdge> found;
  visit_edges(block_of(model, block).shape, [&](const Segment& own) {
    if (distance(own, point) > tolerance) return;
    visit_edges(block_of(model, other).shape, [&](const Segment& facing) {
      const bool opposed = (own.end - own.start).dot(facing.end - facing.start) < 0;
      if (opposed && distance(facing, point) <= tolerance && collinear_overlap(own, facing, tolerance))
        found = SharedEdge{block, other, own};
    });
  });
  return found;
}

Vec2 traction_along(const Model& model, const State& state, const ContactSet& contacts, const SharedEdge& shared) {
  const Line line(model, state, shared.block, shared.edge);
  const double smaller =
      std::min(block_of(model, shared.block).moments.area, block_of(model, shared.other).moments.area);
  double reach = ContactSearch::reach * std::sqrt(smaller);
  Vec2 force = Vec2::Zero();
  double length = 0;  // of stretches that hold together
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    if (!joins(contacts.interfaces[i], shared)) continue;
    reach = std::max(reach, ContactSearch::reach * std::sqrt(smaller) + contacts.states[i].held_open(0));
    const Placed placed = placed_now(model, state, contacts.interfaces[i]);
    if (std::abs(placed.normal.dot(line.normal)) < aligned || !is_on(line, placed.point, reach)) continue;
    force += in_axes_of(line, placed.normal, force_of(model, contacts, i));
    length += contacts.interfaces[i].length;
  }
  if (length == 0) length = common_length(model, state, line, shared.other, reach);
  return length > 0 ? Vec2(force / length) : Vec2::Zero();
}

}  // namespace dda
