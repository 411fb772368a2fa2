#include "engine/contact/interface_frame.h"

#include <cstddef>

namespace dda {
namespace {

Vec2 moved(const Model& model, const State& state, int block, const Vec2& reference) {
  return local_position(model, state, block, reference);
}

Vec2 current_normal(const State& state, const Interface& interface) {
  const auto a = static_cast<std::size_t>(interface.block_a);
  const auto b = static_cast<std::size_t>(interface.block_b);
  // Cofactors of the deformation turn and stretch normals; their sum gives the mean of the two edges.
  const auto turned = [&](std::size_t i) {
    const Mat2& f = state.deformation[i];
    return Vec2(f(1, 1) * interface.normal.x() - f(1, 0) * interface.normal.y(),
                f(0, 0) * interface.normal.y() - f(0, 1) * interface.normal.x());
  };
  // A lone vertex presses on block a's edge: that edge alone has a direction.
  const Vec2 normal = interface.length > 0 ? turned(a) + turned(b) : turned(a);
  return normal.normalized();
}

}  // namespace

InterfaceFrame current_frame(const Model& model, const State& state, const Interface& interface) {
  return {moved(model, state, interface.block_a, interface.from),
          moved(model, state, interface.block_a, interface.to),
          moved(model, state, interface.block_b, interface.from),
          moved(model, state, interface.block_b, interface.to),
          current_normal(state, interface),
          local_centroid(model, state, interface.block_a),
          local_centroid(model, state, interface.block_b)};
}

InterfaceFrame acting_frame(const Model& model, const State& state, const Interface& interface, InterfaceLaw law) {
  InterfaceFrame frame = current_frame(model, state, interface);
  if (law != InterfaceLaw::consistent && law != InterfaceLaw::projected) return frame;
  frame.from_a = frame.from_b = (frame.from_a + frame.from_b) / 2;
  frame.to_a = frame.to_b = (frame.to_a + frame.to_b) / 2;
  return frame;
}

EndsApart ends_apart(const Model& model, const State& state, const Interface& interface) {
  const auto apart = [&](const Vec2& end) -> Vec2 {  // places would lose digits that displacements have
    return point_displacement(model, state, interface.block_b, end) -
           point_displacement(model, state, interface.block_a, end);
  };
  const Mat2 axes = local_axes(current_normal(state, interface));
  return {axes * apart(interface.from), axes * apart(interface.to)};
}

}  // namespace dda
