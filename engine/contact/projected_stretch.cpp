#include "engine/contact/projected_stretch.h"

#include <algorithm>
#include <cstddef>

#include "engine/contact/block_across.h"
#include "engine/contact/no_tension_bed.h"
#include "engine/contact/projected_law.h"

namespace dda {
namespace {

const Vec3& stress_of(const State& state, int block) { return state.stress[static_cast<std::size_t>(block)]; }

const Vec3& drawn_stress(const Model& model, int block) { return block_of(model, block).initial_stress; }

// What the gaps are where blocks lie as drawn, less what their stresses make of them: the compliance of the joint under
// the in-situ stress, and shear beyond its friction.
Vec4 drawn_gap(const Model& model, const Interface& interface, const InterfaceElement& element) {
  const Vec3& stress_a = drawn_stress(model, interface.block_a);
  const Vec3& stress_b = drawn_stress(model, interface.block_b);
  if (stress_a.isZero(0) && stress_b.isZero(0)) return Vec4::Zero();
  const Vec4 force = in_situ_force(model, interface);
  const Vec2 shift = gap_by_stress(element.softness, interface.normal, stress_a, stress_b);
  Vec4 gap;
  for (Eigen::Index row = 0; row < 4; ++row) gap(row) = force(row) / element.stiffness(row) - shift(row % 2);
  return gap;
}

bool gapes_throughout(const InterfaceState& own) {
  return own.status[0] == ContactStatus::open && own.status[1] == ContactStatus::open;
}

void open_whole(InterfaceState& own) {
  for (const std::size_t end : {0U, 1U}) {
    const auto n = static_cast<Eigen::Index>(2 * end);
    own.slip[end] += own.gap(n + 1);
    own.gap(n + 1) = 0;
    own.force.segment<2>(n).setZero();
    own.status[end] = ContactStatus::open;
  }
}

void press_in_part(const InterfaceElement& element, InterfaceState& own) {
  const OpenEnds open = open_ends(element.lever, {own.gap(0), own.gap(2)});
  for (const std::size_t end : {0U, 1U}) {
    const auto n = static_cast<Eigen::Index>(2 * end);
    ContactStatus& status = own.status[end];
    if (end == 0 ? open.first : open.second)
      status = ContactStatus::open;
    else if (status == ContactStatus::open)
      status = ContactStatus::locked;
    own.force(n + 1) = element.stiffness(n + 1) * own.gap(n + 1);
  }
}

}  // namespace

bool has_parted(const Model& model, const State& state, const Interface& interface) {
  const EndsApart ends = ends_apart(model, state, interface);
  return std::max(ends.from.norm(), ends.to.norm()) > parting_share * interface.length;
}

void measure_projected(const Model& model, const State& state, const Interface& interface,
                       const InterfaceElement& element, const EndsApart& ends, InterfaceState& own) {
  const Vec2 middle = (ends.from + ends.to) / 2;
  const Vec2 turn = element.lever * (ends.to - ends.from) / 2;
  const Vec2 shift = gap_by_stress(element.softness, normal_of(element), stress_of(state, interface.block_a),
                                   stress_of(state, interface.block_b));
  own.gap << middle - turn + shift, middle + turn + shift;
  own.gap += drawn_gap(model, interface, element);
  for (const std::size_t end : {0U, 1U}) own.gap(static_cast<Eigen::Index>(2 * end) + 1) -= own.slip[end];
  if (!press_together(element, own.broken)) {
    own.force = element.stiffness.cwiseProduct(own.gap);
    return;
  }
  const BedAnswer bed = press_bed(element.stiffness(0), element.lever, {own.gap(0), own.gap(2)});
  own.force(0) = bed.force(0);
  own.force(2) = bed.force(1);
  if (bed.force.isZero(0)) return open_whole(own);
  press_in_part(element, own);
}

void count_free_slip(const InterfaceElement& element, const Vec4& gap, InterfaceState& own) {
  if (element.law != InterfaceLaw::projected || !gapes_throughout(own)) return;
  own.slip[0] += gap(1);
  own.slip[1] += gap(3);
}

StressLetGo stress_let_go(const Model& model, const State& state, const InterfaceElement& element, const Vec4& force) {
  const Vec2 normal = normal_of(element);
  const Vec2 carried = local_axes(normal).transpose() * (force.head<2>() + force.tail<2>()) / element.length;
  const auto of = [&](int block, double softness) -> Vec3 {
    const Vec2 beyond = traction_rows(normal) * stress_of(state, block) - carried;
    return -element.length * softness / block_of(model, block).moments.area *
           (elasticity_matrix(model.material_of(block)) * (traction_rows(normal).transpose() * beyond));
  };
  return {of(element.block_a, element.softness(0)), of(element.block_b, element.softness(1))};
}

std::array<Vec2, 2> pressing_ends(const InterfaceElement& element, const Vec4& force) {
  std::array<Vec2, 2> ends = forces_at_ends(element, force);
  for (const std::size_t end : {0U, 1U}) {
    if (ends[end](0) <= 0) continue;  // the force acts beyond the other end
    ends[1 - end] += ends[end];
    ends[end].setZero();
  }
  return ends;
}

}  // namespace dda
