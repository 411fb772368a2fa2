#include "engine/simulation/depth_in_thickness.h"

#include <algorithm>
#include <cstddef>

#include "engine/geometry/segment.h"

namespace dda {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

// Depths below this share of a block's least thickness are not looked at: what rests never gets there.
constexpr double noted_share = ruinous_share / 2;

// Nor those below this share of the smaller block's side. The tip of a needle is as thin as one likes, and what presses
// there closes a joint by more than that without going anywhere. Plates thinner than 4e-6 of their length are beyond
// it.
constexpr double noted_of_side = 1e-3;

// Where the ray from `face` against `normal` leaves the block through an edge of the ring, m from the face. Rings have
// the block on their left: edges through which a ray leaves run to its left, and that of the face it starts from does
// not.
double leaves_at(const Ring& ring, const auto& place_of, const Vec2& face, const Vec2& normal) {
  double nearest = never;
  Vec2 from = place_of(ring.back()) - face;
  for (const Vec2& vertex : ring) {
    const Vec2 to = place_of(vertex) - face;
    const double side_from = cross(normal, from), side_to = cross(normal, to);
    if (side_from >= 0 && side_to < 0) {
      const double along = -(from + side_from / (side_from - side_to) * (to - from)).dot(normal);
      if (along > 0) nearest = std::min(nearest, along);
    }
    from = to;
  }
  return nearest;
}

}  // namespace

double thickness_behind(const Model& model, const State& state, int block, const Vec2& face, const Vec2& normal) {
  const Polygon& shape = model.blocks[static_cast<std::size_t>(block)].shape;
  const auto place_of = [&](const Vec2& vertex) -> Vec2 { return current_position(model, state, block, vertex); };
  double nearest = leaves_at(shape.outer, place_of, face, normal);
  for (const Ring& hole : shape.holes) nearest = std::min(nearest, leaves_at(hole, place_of, face, normal));
  return nearest;
}

namespace {

double smaller_area(const Model& model, const Interface& interface) {
  return std::min(model.blocks[static_cast<std::size_t>(interface.block_a)].moments.area,
                  model.blocks[static_cast<std::size_t>(interface.block_b)].moments.area);
}

// m: a tenth of what the block measures along its face.
double short_way(const Model& model, const State& state, int block, const Vec2& along) {
  double least = never, most = -never;
  for (const Vec2& vertex : model.blocks[static_cast<std::size_t>(block)].shape.outer) {
    const double place = along.dot(current_position(model, state, block, vertex));
    least = std::min(least, place);
    most = std::max(most, place);
  }
  return (most - least) / 10;
}

// The tip of a needle is as thin as one likes, and a corner beside it goes past it sooner than through it. So a block
// is taken to be as thick as it is a short way further along the face, on the thicker side.
double fair_thickness(const Model& model, const State& state, int block, const Vec2& face, const Vec2& normal) {
  const Vec2 along(-normal.y(), normal.x());
  const double way = short_way(model, state, block, along);
  double thickness = thickness_behind(model, state, block, face, normal);
  for (const double side : {-way, way})
    if (const double there = thickness_behind(model, state, block, face + side * along, normal); there < never)
      thickness = std::max(thickness, there);
  return thickness;
}

void compare(const Model& model, const State& state, int inner, int thinner, const Vec2& corner, const Vec2& normal,
             double depth, DepthInThickness& deepest) {
  const double share = depth / fair_thickness(model, state, thinner, corner + depth * normal, normal);
  if (share > deepest.share) deepest = {depth, share, inner, thinner, corner, state.time};
}

// A lone vertex is block b's, on a face of a; of a stretch both blocks have a face, and are as thick as in its middle:
// its end may lie on the edge of the far face, or in the tip of a needle, which is as thin as one likes.
void look_at(const Model& model, const State& state, const Interface& interface, const InterfaceElement& element,
             const Vec2& drawn, double depth, DepthInThickness& deepest) {
  const Vec2 normal = element.rows_b.block<1, 2>(0, 0).transpose();
  const Vec2 middle = is_lone_vertex(element) ? drawn : Vec2((interface.from + interface.to) / 2);
  const Vec2 corner = current_position(model, state, interface.block_b, middle);
  compare(model, state, interface.block_b, interface.block_a, corner, normal, depth, deepest);
  if (is_lone_vertex(element)) return;
  compare(model, state, interface.block_a, interface.block_b, current_position(model, state, interface.block_a, middle),
          -normal, depth, deepest);
}

bool are_among(std::span<const CameInOver> pairs, const InterfaceElement& element) {
  const int a = std::min(element.block_a, element.block_b), b = std::max(element.block_a, element.block_b);
  return std::ranges::any_of(pairs, [&](const CameInOver& each) { return each.block_a == a && each.block_b == b; });
}

}  // namespace

void note_depths_in_thickness(const Model& model, const State& state, const ContactSet& contacts,
                              const LeastWidths& widths, std::span<const CameInOver> came_in_over,
                              DepthInThickness& deepest) {
  const double least_asked = std::max(noted_share, deepest.share) * widths.of_all;
  for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
    const InterfaceElement& element = contacts.elements.own()[i];
    if (element.law != InterfaceLaw::classical) continue;  // the gaps of the others are no distances
    const InterfaceState& own = contacts.states[i];
    for (int end = 0; end < ends_of(element); ++end) {
      const auto e = static_cast<std::size_t>(end);
      const bool came_in_so = own.seat[e] < 0 && are_among(came_in_over, element);
      const double depth = -(own.gap(2 * end) + (came_in_so ? own.dilation[e] : own.held_open(e)));
      if (depth <= least_asked) continue;  // nearly all that there is
      const double width = std::min(widths.of_blocks[static_cast<std::size_t>(element.block_a)],
                                    widths.of_blocks[static_cast<std::size_t>(element.block_b)]);
      const Interface& interface = contacts.interfaces[i];
      if (depth * depth <= noted_of_side * noted_of_side * smaller_area(model, interface)) continue;
      if (depth > std::max(noted_share, deepest.share) * width)
        look_at(model, state, interface, element, end == 0 ? interface.from : interface.to, depth, deepest);
    }
  }
}

}  // namespace dda
