#include "engine/contact/renew_springs.h"

#include <cstddef>

#include "engine/contact/make_element.h"
#include "engine/contact/no_tension_bed.h"
#include "engine/contact/projected_law.h"
#include "engine/contact/projected_stretch.h"

namespace dda {

namespace {

void renew_classical(const Model& model, const Interface& interface, bool gaps_are_measured, InterfaceElement& element,
                     InterfaceState& own) {
  const InterfaceElement renewed = make_element(model, interface, InterfaceLaw::classical);
  for (Eigen::Index row = 0; row < 2 * ends_of(element); ++row) {
    if (renewed.stiffness(row) == element.stiffness(row) || own.force(row) == 0) continue;
    const double before = own.gap(row);
    own.gap(row) = own.force(row) / renewed.stiffness(row);
    const bool is_normal = row % 2 == 0;
    if (is_normal && gaps_are_measured && is_lone_vertex(element))
      own.seat[static_cast<std::size_t>(row / 2)] += before - own.gap(row);
  }
  element.stiffness = renewed.stiffness;
  element.dashpot = renewed.dashpot;
}

// What is told of two points at +-1 from the middle, told of two at +-1/ratio: the mean is the same, and half of the
// difference is `ratio` times what it was. `first` is the row of one point; that of the other is two below.
template <typename Rows>
void move_points(double ratio, Eigen::Index first, Rows& rows) {
  const auto mean = ((rows.row(first) + rows.row(first + 2)) / 2).eval();
  const auto half = (ratio * (rows.row(first + 2) - rows.row(first)) / 2).eval();
  rows.row(first) = mean - half;
  rows.row(first + 2) = mean + half;
}

void find_gaps(const InterfaceElement& element, InterfaceState& own) {
  for (Eigen::Index row = 0; row < 4; ++row)
    if (own.force(row) != 0) own.gap(row) = own.force(row) / element.stiffness(row);
  if (!presses_together(element, own.broken, own.force)) return;
  const Vec2 gaps = gaps_of_bed(bed_of(element), {own.force(0), own.force(2)});
  own.gap(0) = gaps(0);
  own.gap(2) = gaps(1);
}

void renew_projected(const Model& model, const State& state, const Interface& interface, bool gaps_are_measured,
                     InterfaceElement& element, InterfaceState& own) {
  const InterfaceElement renewed = make_element(model, interface, InterfaceLaw::projected);
  if (renewed.stiffness == element.stiffness) return;
  const double lever = element.lever;
  element.stiffness = renewed.stiffness;
  element.lever = renewed.lever;
  element.spread = renewed.spread;
  for (const Eigen::Index row : {0, 1}) {
    move_points(lever / element.lever, row, own.force);
    move_points(element.lever / lever, row, element.rows_a);
    move_points(element.lever / lever, row, element.rows_b);
  }
  move_points(element.lever / lever, 0, own.gap);  // counts where nothing presses
  find_gaps(element, own);
  // Gaps that are measured where blocks lie count from where they give those of `own`.
  if (gaps_are_measured) element.gap_at_start += gap_as_it_lies(model, state, interface, element, own) - own.gap;
}

}  // namespace

void renew_springs(const Model& model, const State& state, const Interface& interface, bool gaps_are_measured,
                   InterfaceElement& element, InterfaceState& own) {
  if (element.law == InterfaceLaw::classical) renew_classical(model, interface, gaps_are_measured, element, own);
  if (element.law == InterfaceLaw::projected) renew_projected(model, state, interface, gaps_are_measured, element, own);
}

void renew_strain_rows(const Mat3& elasticity_a, const Mat3& elasticity_b, InterfaceElement& element) {
  if (!has_stress_rows(element)) return;
  element.strain_rows_a = element.stress_rows_a * elasticity_a;
  element.strain_rows_b = element.stress_rows_b * elasticity_b;
}

}  // namespace dda
