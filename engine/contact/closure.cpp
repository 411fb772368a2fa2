#include "engine/contact/closure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/contact/interface_frame.h"
#include "engine/contact/projected_law.h"

namespace dda {
namespace {

// By the outlines, m: at the points of a projected stretch, as its gaps are, and at the ends of another.
double depth_of_outlines(const Model& model, const State& state, const Interface& interface,
                         const InterfaceElement& element, const InterfaceState& own) {
  if (is_lone_vertex(element)) return -(own.gap(0) + own.held_open(0));
  const EndsApart ends = ends_apart(model, state, interface);
  const double lever = element.law == InterfaceLaw::projected ? element.lever : 1;
  return (lever * std::abs(ends.to.x() - ends.from.x()) - (ends.to.x() + ends.from.x())) / 2;
}

}  // namespace

bool is_open(const InterfaceElement& element, const InterfaceState& state) {
  if (has_stress_rows(element)) return false;
  const bool second_open = is_lone_vertex(element) || state.status[1] == ContactStatus::open;
  return state.status[0] == ContactStatus::open && second_open;
}

double penetration_depth(const InterfaceElement& element, const Vec4& gap, const std::vector<Vec3>& stress) {
  if (element.law == InterfaceLaw::projected)
    return projected_depth(element, gap, stress[static_cast<std::size_t>(element.block_a)],
                           stress[static_cast<std::size_t>(element.block_b)]);
  if (has_stress_rows(element)) return std::abs(gap(2)) - gap(0);
  return is_lone_vertex(element) ? -gap(0) : -std::min(gap(0), gap(2));
}

double depth_in_each_other(const Model& model, const State& state, const Interface& interface,
                           const InterfaceElement& element, const InterfaceState& own) {
  const double closed = penetration_depth(element, own.gap, state.stress);
  if (closed <= 0 || has_stress_rows(element)) return closed;
  return std::min(closed, depth_of_outlines(model, state, interface, element, own));
}

}  // namespace dda
