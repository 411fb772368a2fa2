#include "engine/contact/strain_jumps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/contact/interface_frame.h"
#include "engine/contact/pair_motion.h"
#include "engine/contact/projected_stretch.h"
#include "engine/geometry/segment.h"

namespace dda {

double strain_jump(const InterfaceFrame& frame, bool gapes) {
  const Vec2 apart_from = frame.from_b - frame.from_a, apart_to = frame.to_b - frame.to_a;
  const Vec2 jump = (apart_to - apart_from) / 2;
  return gapes ? std::abs(cross(frame.normal, jump)) : jump.norm();
}

std::vector<double> strain_jumps_after(const Model& model, const State& state, const ContactSet& contacts,
                                       const Eigen::VectorXd& d) {
  std::vector<double> largest(model.blocks.size(), 0);
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    const Interface& stretch = contacts.interfaces[i];
    if (stretch.length == 0) continue;  // one of vertices
    InterfaceFrame frame = current_frame(model, state, stretch);
    const auto move = [&](int block, const Vec2& centroid, Vec2& place) {
      place += displacement_of(d.segment<6>(6 * block), place - centroid);
    };
    for (Vec2* end : {&frame.from_a, &frame.to_a}) move(stretch.block_a, frame.centroid_a, *end);
    for (Vec2* end : {&frame.from_b, &frame.to_b}) move(stretch.block_b, frame.centroid_b, *end);
    const double jump = strain_jump(frame, gapes(contacts.elements.own()[i], contacts.states[i]));
    for (const int block : {stretch.block_a, stretch.block_b}) {
      double& own = largest[static_cast<std::size_t>(block)];
      own = std::max(own, jump);
    }
  }
  return largest;
}

}  // namespace dda
