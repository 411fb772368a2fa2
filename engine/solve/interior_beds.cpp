// The part of interior passes that stretches on a bed have, whose ends know of each other (bed_ends.h).
#include <Eigen/LU>
#include <algorithm>

#include "engine/contact/contact_set.h"
#include "engine/contact/projected_law.h"
#include "engine/solve/bed_ends.h"
#include "engine/solve/interior_passes.h"

namespace dda {
namespace {

// The pressure that an end has at first, of the other end's at least: what a bed with less gives way leads nowhere.
constexpr double least_share_at_first = 0.01;

Vec2 points_of(const Vec4& rows) { return {rows(0), rows(2)}; }

}  // namespace

void InteriorPasses::list_beds() {
  beds_.clear();
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (rows_[i].on_bed) beds_.push_back({.first = i++});
}

double InteriorPasses::take_answer_of_bed(const InterfaceSprings& springs, InteriorBed& ends) {
  const Vec2 gaps = points_of(gaps_[rows_[ends.first].contact]);
  const BedAnswer answer = press_bed(bed_of(springs), gaps);
  const Vec2 pressures = pressures_of_ends(springs.lever, answer.force);
  for (const std::size_t end : {0U, 1U}) rows_[ends.first + end].force = pressures(static_cast<Eigen::Index>(end));
  ends.points << answer.slope(0), answer.coupling, answer.coupling, answer.slope(1);
  return answer.force.dot(gaps);
}

// As if each end were a spring for itself, but for the least share.
void InteriorPasses::move_beds_inside(const Iterate& at, double product) {
  for (const InteriorBed& ends : beds_) {
    InteriorRow& first = rows_[ends.first];
    InteriorRow& second = rows_[ends.first + 1];
    const Vec2 openings = openings_of(at, ends);
    move_inside(product, openings(0), first);
    move_inside(product, openings(1), second);
    const double least = least_share_at_first * std::max(first.force, second.force);
    for (InteriorRow* row : {&first, &second}) {
      row->force = row->partner[0] = std::max(row->force, least);
      row->length[0] = product / row->force;
    }
  }
}

Vec2 InteriorPasses::openings_of(const Iterate& at, const InteriorBed& ends) const {
  const std::size_t k = rows_[ends.first].contact;
  return openings_of_ends(at.contacts.element(k).lever, points_of(gaps_[k]));
}

void InteriorPasses::take_forces_of_beds(const Iterate& at) {
  for (const InteriorBed& ends : beds_) {
    const std::size_t k = rows_[ends.first].contact;
    const Vec2 pressures(rows_[ends.first].force, rows_[ends.first + 1].force);
    const Vec2 at_points = forces_of_points(at.contacts.element(k).lever, pressures);
    forces_[k](0) = at_points(0);
    forces_[k](2) = at_points(1);
  }
}

// By how much forces of the points are off what the beds answer at most, N per m of thickness. Not of beds that are
// taken for a spring: theirs stay off by the square root of the share of pressure from which they are, 5e-5.
double InteriorPasses::beds_off_answers(const Iterate& at) const {
  double off = 0;
  for (const InteriorBed& ends : beds_) {
    const std::size_t k = rows_[ends.first].contact;
    if (is_taken_for_a_spring({rows_[ends.first].force, rows_[ends.first + 1].force})) continue;
    const Vec2 answer = press_bed(bed_of(at.contacts.element(k)), points_of(gaps_[k])).force;
    off = std::max(off, (answer - points_of(forces_[k])).cwiseAbs().maxCoeff());
  }
  return off;
}

void InteriorPasses::take_rows_of_beds() {
  for (const InteriorBed& ends : beds_) {
    const InteriorRow& first = rows_[ends.first];
    ContactRows& rows = active_[first.contact];
    rows.active(0) = ends.points(0, 0) / first.stiffness;
    rows.active(2) = ends.points(1, 1) / first.stiffness;
    rows.coupling = ends.points(0, 1);
  }
}

void InteriorPasses::take_stiffness_of_beds(const Iterate& at) {
  for (InteriorBed& ends : beds_) {
    InteriorRow& first = rows_[ends.first];
    InteriorRow& second = rows_[ends.first + 1];
    if (first.length[0] == 0) continue;
    const InterfaceSprings& springs = at.contacts.element(first.contact);
    const Compression under = compress(bed_of(springs), {first.force, second.force});
    first.depth = under.depth(0);
    second.depth = under.depth(1);
    Mat2 softness = under.softness;
    softness(0, 0) += first.length[0] / first.force;
    softness(1, 1) += second.length[0] / second.force;
    ends.stiffness = softness.inverse();
    ends.points = slopes_of_points(springs.lever, ends.stiffness);
  }
}

// Both ends give way under both forces, so what changes of these is off by what both openings are.
void InteriorPasses::eliminate_beds(const Iterate& at, double product, bool corrects) {
  for (const InteriorBed& ends : beds_) {
    InteriorRow& first = rows_[ends.first];
    InteriorRow& second = rows_[ends.first + 1];
    const Vec2 openings = openings_of(at, ends);
    eliminate_lengths(openings(0), product, corrects, first);
    eliminate_lengths(openings(1), product, corrects, second);
    const Vec2 constants = ends.stiffness * Vec2(first.constant, second.constant);
    first.constant = constants(0);
    second.constant = constants(1);
    const InterfaceElement& element = at.contacts.element(first.contact);
    const Vec2 outwards = forces_of_points(element.lever, constants);
    add_interface_force(element, -at.problem->factor * Vec4(outwards(0), 0, outwards(1), 0), Vec4::Zero(), image_);
  }
}

void InteriorPasses::follow_beds(const Iterate& at) {
  for (const InteriorBed& ends : beds_) {
    const InterfaceElement& element = at.contacts.element(rows_[ends.first].contact);
    const Vec2 opened = openings_of_ends(element.lever, points_of(gap_increment(element, step_)));
    const Vec2 along = ends.stiffness * opened;
    follow(along(0), rows_[ends.first]);
    follow(along(1), rows_[ends.first + 1]);
  }
}

}  // namespace dda
