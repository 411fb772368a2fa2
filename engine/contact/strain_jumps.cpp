#include "engine/contact/strain_jumps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/contact/interface_frame.h"
#include "engine/contact/pair_motion.h"
#include "engine/contact/projected_stretch.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

InterfaceFrame moved_frame(const Model& model, const State& state, const Interface& stretch, const Eigen::VectorXd& d) {
  InterfaceFrame frame = current_frame(model, state, stretch);
  const auto move = [&](int block, const Vec2& centroid, Vec2& place) {
    place += displacement_of(d.segment<6>(6 * block), place - centroid);
  };
  for (Vec2* end : {&frame.from_a, &frame.to_a}) move(stretch.block_a, frame.centroid_a, *end);
  for (Vec2* end : {&frame.from_b, &frame.to_b}) move(stretch.block_b, frame.centroid_b, *end);
  return frame;
}

}  // namespace

double strain_jump(const InterfaceFrame& frame, bool gapes) {
  const Vec2 apart_from = frame.from_b - frame.from_a, apart_to = frame.to_b - frame.to_a;
  const Vec2 jump = (apart_to - apart_from) / 2;
  return gapes ? std::abs(cross(frame.normal, jump)) : jump.norm();
}

double strain_jump_at(int block, const Vec2& place, double near, const Model& model, const State& state,
                      const ContactSet& contacts, const Eigen::VectorXd& d) {
  double largest = 0;
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    const Interface& stretch = contacts.interfaces[i];
    const bool is_a = stretch.block_a == block;
    if (stretch.length == 0 || (!is_a && stretch.block_b != block)) continue;
    const InterfaceFrame frame = moved_frame(model, state, stretch, d);
    const double jump = strain_jump(frame, gapes(contacts.elements.own()[i], contacts.states[i]));
    const double from = (place - (is_a ? frame.from_a : frame.from_b)).norm();
    const double to = (place - (is_a ? frame.to_a : frame.to_b)).norm();
    if (std::min(from, to) <= near + jump) largest = std::max(largest, jump);
  }
  return largest;
}

}  // namespace dda
