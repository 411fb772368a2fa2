#include "engine/contact/projected_stretch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/contact/block_across.h"
#include "engine/contact/in_situ_force.h"
#include "engine/contact/interface_frame.h"
#include "engine/contact/no_tension_bed.h"
#include "engine/contact/projected_law.h"
#include "engine/geometry/segment.h"

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

// Sine of the angle by which a corner may point inwards, or an outline be off a line, and count as straight.
constexpr double straight = 0.01;

// Where the outline of a block is, seen from the line of a stretch that `outwards` points away from the block.
struct SeenFromStretch {
  bool is_beyond = false;                              // somewhere it is on the other side of the line
  std::array<bool, 2> goes_on_along = {false, false};  // or comes back to it, past either end
};

// It is still at the line when it leaves it at no more than an angle of the sine `aside`.
SeenFromStretch see(const Polygon& shape, const Interface& stretch, const Vec2& outwards, double aside) {
  SeenFromStretch seen;
  const Vec2 along = (stretch.to - stretch.from) / stretch.length;
  for (const Vec2& corner : shape.outer) {
    const Vec2 before = stretch.from - corner, after = corner - stretch.to;
    const double off = outwards.dot(after);
    const double far = std::max(std::min(before.norm(), after.norm()), straight * stretch.length);
    if (off > straight * far) seen.is_beyond = true;
    if (off < -aside * far) continue;
    if (along.dot(before) > straight * stretch.length) seen.goes_on_along[0] = true;
    if (along.dot(after) > straight * stretch.length) seen.goes_on_along[1] = true;
  }
  return seen;
}

struct SeenBlocks {
  SeenFromStretch a, b;

  [[nodiscard]] bool both_go_on(std::size_t end) const { return a.goes_on_along[end] && b.goes_on_along[end]; }
};

SeenBlocks see_both(const Interface& stretch, const Polygon& a, const Polygon& b, double aside) {
  return {see(a, stretch, stretch.normal, aside), see(b, stretch, -stretch.normal, aside)};
}

// The line of a stretch parts its blocks, and past its ends no more than one of them is at the line.
bool is_parted_by(const Interface& stretch, const Polygon& a, const Polygon& b) {
  const SeenBlocks seen = see_both(stretch, a, b, straight);
  return !seen.a.is_beyond && !seen.b.is_beyond && !seen.both_go_on(0) && !seen.both_go_on(1);
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

bool points_outwards(const Polygon& shape) {
  const Ring& ring = shape.outer;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 before = ring[(i + 1) % ring.size()] - ring[i];
    const Vec2 after = ring[(i + 2) % ring.size()] - ring[(i + 1) % ring.size()];
    if (cross(before, after) < -straight * before.norm() * after.norm()) return false;
  }
  return shape.holes.empty();
}

bool has_parted(const Model& model, const State& state, const Interface& interface) {
  const EndsApart ends = ends_apart(model, state, interface);
  const double slid = std::max(std::abs(ends.from.y()), std::abs(ends.to.y()));
  const auto [nearer, further] = std::minmax(ends.from.x(), ends.to.x());
  if (std::max(slid, nearer) > parting_share * interface.length) return true;
  if (further <= parting_share * interface.length) return false;
  const std::size_t stays = ends.from.x() < ends.to.x() ? 0 : 1;
  return further > turning_share * interface.length || see_both(interface, block_of(model, interface.block_a).shape,
                                                                block_of(model, interface.block_b).shape, turning_share)
                                                           .both_go_on(stays);
}

bool touch_there_alone(const Model& model, const Interface& interface) {
  const Polygon& a = block_of(model, interface.block_a).shape;
  const Polygon& b = block_of(model, interface.block_b).shape;
  return (points_outwards(a) && points_outwards(b)) || is_parted_by(interface, a, b);
}

void measure_projected(const Model& model, const State& state, const Interface& interface,
                       const InterfaceElement& element, const EndsApart& ends, InterfaceState& own) {
  const Vec2 middle = (ends.from + ends.to) / 2;
  const Vec2 turn = element.lever * (ends.to - ends.from) / 2;
  const Vec2 shift = gap_by_stress(element.softness, normal_of(element), stress_of(state, interface.block_a),
                                   stress_of(state, interface.block_b));
  own.gap << middle - turn + shift, middle + turn + shift;
  own.gap += drawn_gap(model, interface, element) + element.by_loads;
  own.gap -= element.gap_at_start + Vec4(own.seat[0], own.slip[0], own.seat[1], own.slip[1]);
  answer_gaps(element, own);
}

void answer_gaps(const InterfaceElement& element, InterfaceState& own) {
  if (!press_together(element, own.broken)) {
    own.force = element.stiffness.cwiseProduct(own.gap);
    return;
  }
  const BedAnswer bed = press_bed(bed_of(element), {own.gap(0), own.gap(2)});
  own.force(0) = bed.force(0);
  own.force(2) = bed.force(1);
  if (bed.force.isZero(0)) return open_whole(own);
  press_in_part(element, own);
}

Vec4 gap_as_it_lies(const Model& model, const State& state, const Interface& interface, const InterfaceElement& element,
                    InterfaceState own) {
  own.broken = {false, false};  // one that has not broken answers in any gap
  measure_projected(model, state, interface, element, ends_apart(model, state, interface), own);
  return own.gap;
}

void count_free_slip(const InterfaceElement& element, const Vec4& gap, InterfaceState& own) {
  if (element.law != InterfaceLaw::projected || !gapes_throughout(own)) return;
  own.slip[0] += gap(1);
  own.slip[1] += gap(3);
}

StressLetGo stress_let_go(const Model& model, const State& state, const InterfaceElement& element, const Vec4& force) {
  const Vec2 normal = normal_of(element);
  const Vec2 carried = local_axes(normal).transpose() * (force.head<2>() + force.tail<2>()) / element.length;
  const auto of = [&](int block, double softness, const Vec2& beside_stress) -> Vec3 {
    const Vec2 own = traction_rows(normal) * stress_of(state, block) + local_axes(normal).transpose() * beside_stress;
    const Vec2 beyond = own - carried;
    return -element.length * softness / block_of(model, block).moments.area *
           (elasticity_matrix(model.material_of(block)) * (traction_rows(normal).transpose() * beyond));
  };
  return {of(element.block_a, element.softness(0), element.beside_stress_a),
          of(element.block_b, element.softness(1), element.beside_stress_b)};
}

double gaping_share(const InterfaceElement& element, const InterfaceState& state) {
  if (!presses_together(element, state.broken, state.force)) return 0;
  return 1 - closed_share(element.lever, {state.force(0), state.force(2)});
}

std::array<Vec2, 2> pressing_ends(const InterfaceElement& element, const InterfaceState& state) {
  std::array<Vec2, 2> ends = forces_at_ends(element, state.force);
  for (const std::size_t end : {0U, 1U}) {
    const bool gapes = state.status[end] == ContactStatus::open && state.status[1 - end] != ContactStatus::open;
    if (ends[end](0) <= 0 && !gapes) continue;  // else the force acts at or beyond the other end
    ends[1 - end] += ends[end];
    ends[end].setZero();
  }
  return ends;
}

}  // namespace dda
