#include "engine/solve/interior_friction.h"

#include <algorithm>
#include <cmath>

#include "engine/contact/contact_set.h"
#include "engine/contact/no_tension_bed.h"
#include "engine/contact/projected_law.h"
#include "engine/solve/bed_ends.h"

namespace dda {
namespace {

// What is left of a predicted step, and of a corrected one. (With 1e-4 of both 29.1 passes lead to 1e-7, with
// these 30.1 that take a tenth less time, with 0.1 of the first 39.)
constexpr double predicted_to = 1e-2, corrected_to = 1e-3;

// Square of the forces by which kinks are rounded off, of mu k. (In a slope of 481 blocks in motion 1e-7 is reached
// after 29 passes with 0.01 and 2 ways of 150 fail; after 30 and none with 0.1, 33 and none with 1, 39 and none with
// 10, 47 and 8 of 90 with 100.)
constexpr double rounded_off = 0.1;

// Slopes below this share of the springs' stiffness a step does not see.
constexpr double negligible_slope = 1e-7;

// The friction that one point of a stretch on its bed has of the pressures of both, and how it follows them.
struct Share {
  double pressure;
  double by_own, by_other;
};

Share share_of(double own, double other, double rounding) {
  const double root = std::sqrt(own * own + rounding), root_other = std::sqrt(other * other + rounding);
  const double sum = root + root_other;
  if (sum == 0) return {0, 0, 0};
  // r + P without loss of digits.
  const auto sum_of = [rounding](double r, double p) { return p > 0 ? r + p : rounding / (r - p); };
  const double pressure = (own + other) / 2 * (sum_of(root, own) + sum_of(root_other, -other)) / sum;
  return {pressure, root > 0 ? (1 + own / root) / 2 : 0, root_other > 0 ? (1 - other / root_other) / 2 : 0};
}

}  // namespace

bool InteriorFriction::serves(const Iterate& at) {
  if (at.problem->contacts.rule.capacity_is_given) return true;
  for (std::size_t k = 0; k < at.contacts.size(); ++k) {
    const InterfaceTrial& trial = at.contacts[k];
    for (const std::size_t end : {0U, 1U})
      if (trial.broken[end] && at.contacts.strength(k).cohesion_now(trial.residual[end]) > 0) return false;
  }
  return true;
}

void InteriorFriction::begin(const Iterate& at) {
  follows_ = !at.problem->contacts.rule.capacity_is_given;
  if (!follows_) return;
  by_forces_.assign(at.contacts.size(), Mat2::Zero());
  normals_.assign(at.contacts.size(), Mat2::Zero());
  changes_.assign(at.contacts.size(), Vec2::Zero());
  gmres_.resize(at.increment.size());
}

void InteriorFriction::take_capacities(const Iterate& at, std::span<const Vec4> forces, double product,
                                       std::span<InteriorRow> rows) {
  if (!follows_) return;
  for (InteriorRow& row : rows) {
    if (row.is_normal()) continue;
    const std::size_t k = row.contact;
    const int end = row.end(), other = 1 - end;
    const InterfaceSprings& springs = at.contacts.element(k);
    const InterfaceTrial& trial = at.contacts[k];
    const double friction = at.contacts.strength(k).friction_now(trial.residual[static_cast<std::size_t>(end)]);
    Share share{-forces[k](2 * end), 1, 0};
    if (press_together(springs, trial.broken))
      share = share_of(-forces[k](2 * end), -forces[k](2 * other), rounded_off * product * springs.stiffness(0));
    row.capacity = friction * share.pressure;
    by_forces_[k](end, end) = -friction * share.by_own;
    by_forces_[k](end, other) = -friction * share.by_other;
  }
}

// Pressures are the negative of forces.
template <double InteriorRow::*change>
void InteriorFriction::note_changes(const Iterate& at, std::span<const InteriorBed> beds,
                                    std::span<const InteriorRow> rows) {
  for (const InteriorRow& row : rows)
    if (row.is_normal() && !row.on_bed) changes_[row.contact](row.end()) = -(row.*change);
  for (const InteriorBed& bed : beds) {
    const std::size_t k = rows[bed.first].contact;
    const Vec2 pressures(rows[bed.first].*change, rows[bed.first + 1].*change);
    changes_[k] = forces_of_points(at.contacts.element(k).lever, pressures);
  }
}

template <double InteriorRow::*change>
void InteriorFriction::follow_changes(const Iterate& at, std::span<const InteriorBed> beds,
                                      std::span<InteriorRow> rows) {
  note_changes<change>(at, beds, rows);
  for (InteriorRow& row : rows) {
    if (row.is_normal()) continue;
    const double whole = by_forces_[row.contact].row(row.end()).dot(changes_[row.contact]);
    row.constant += row.force_by_capacity() * (whole - row.capacity_step);
    row.capacity_step = whole;
  }
}

void InteriorFriction::eliminate(const Iterate& at, std::span<const InteriorBed> beds, std::span<InteriorRow> rows) {
  if (!follows_) return;
  for (InteriorRow& row : rows) row.capacity_step = 0;
  follow_changes<&InteriorRow::constant>(at, beds, rows);
}

void InteriorFriction::follow(const Iterate& at, std::span<const InteriorBed> beds, std::span<InteriorRow> rows) {
  if (follows_) follow_changes<&InteriorRow::force_step>(at, beds, rows);
}

void InteriorFriction::couple(const Iterate& at, std::span<const InteriorBed> beds, std::span<const InteriorRow> rows) {
  if (!follows_) return;
  for (const InteriorRow& row : rows)
    if (row.is_normal() && !row.on_bed) normals_[row.contact](row.end(), row.end()) = row.share * row.stiffness;
  for (const InteriorBed& bed : beds) normals_[rows[bed.first].contact] = bed.points;
  couplings_.clear();
  const InteriorRow* last = nullptr;
  for (const InteriorRow& row : rows) {
    if (row.is_normal()) continue;
    const std::size_t k = row.contact;
    const InterfaceElement& element = at.contacts.element(k);
    const Eigen::RowVector2d slopes = row.force_by_capacity() * by_forces_[k].row(row.end()) * normals_[k];
    if (!(slopes.cwiseAbs().maxCoeff() > negligible_slope * element.stiffness(0))) continue;
    if (last == nullptr || last->contact != k)
      couplings_.push_back({element.block_a, element.block_b, PointKinematics(element), Mat2::Zero()});
    couplings_.back().shear_by_gap.row(row.end()) = slopes;
    last = &row;
  }
}

void InteriorFriction::multiply(const Iterate& at, const Eigen::VectorXd& v, Eigen::VectorXd& w) const {
  at.matrix.values().multiply(v, w);
  for (const auto& [a, b, points, shear_by_gap] : couplings_) {
    const Vec4 opening = points.gap(v.segment<6>(6 * a), v.segment<6>(6 * b));
    const Vec2 shear = at.problem->factor * shear_by_gap * Vec2(opening(0), opening(2));
    points.add_force(Vec4(0, shear(0), 0, shear(1)), w.segment<6>(6 * a), w.segment<6>(6 * b));
  }
  at.problem->held.clear(w);
}

// What the basis does not reach the next pass may.
Status InteriorFriction::solve(Iterate& at, const Eigen::VectorXd& rhs, bool corrects, Eigen::VectorXd& step) {
  if (!follows_) {
    at.matrix.solver().precondition(rhs, step);
    return Status::ok;
  }
  const auto product = [&](const Eigen::VectorXd& v, Eigen::VectorXd& w) { multiply(at, v, w); };
  const auto precondition = [&at](const Eigen::VectorXd& r, Eigen::VectorXd& z) {
    return at.matrix.solver().precondition(r, z);
  };
  const KrylovResult result =
      gmres_.solve(product, precondition, rhs, corrects ? corrected_to : predicted_to, basis, step);
  at.costs.counters.solver_iterations += result.iterations;
  return result.status == Status::not_converged ? Status::ok : result.status;
}

}  // namespace dda
