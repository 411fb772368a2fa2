#include "engine/simulation/settling_drag.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/simulation/held_blocks.h"
#include "engine/simulation/relative_size.h"
#include "engine/terms/inertia.h"

namespace dda {
namespace {

// Blocks may move by this share of their size in a static step: contacts still turn little in such a step.
constexpr double most_motion = 0.02;

// And blocks below this share of the area of most by so much: until a splinter that is squeezed out counts as loose it
// presses with up to a hundred times the weight of the largest block, and all others are solved for in every step.
constexpr double small_share = 1e-2;
constexpr double most_motion_of_small = 0.2;

// How far, in its own size, a block goes under drag before it is loose.
constexpr double most_travel = 0.5;

// A block whose motion fell by less than this with its drag raised is carried by others.
constexpr double carried = 0.7;

// What moves too far gets so much drag that it moves by this share of the most it may. Each step then eases the drag.
// Were the one the inverse of the other a block that falls would go by exactly the most every second step, and
// round-off would say whether that is too far.
constexpr double share_after_raise = 0.5;
constexpr double easing = 1.8;

Vec6 own(const Eigen::VectorXd& d, std::size_t block) { return d.segment<6>(static_cast<Eigen::Index>(6 * block)); }

}  // namespace

double turn_or_strain(const Vec6& increments) {
  const double shear = increments(5) / 2;  // of the tensor
  const double strain = increments(3) * increments(3) + increments(4) * increments(4) + 2 * shear * shear;
  return std::max(std::abs(increments(2)), std::sqrt(strain));
}

double motion_share(const Vec6& increments, double area) {
  return increments.head<2>().norm() / std::sqrt(area) + turn_or_strain(increments);
}

bool SettlingDrag::ease() {
  std::fill(moved_.begin(), moved_.end(), 0.0);
  std::fill(is_carried_.begin(), is_carried_.end(), char{0});
  bool changed = false;
  for (double& factor : factors_) {
    if (factor == 1) continue;
    factor = std::max(1.0, factor / easing);
    changed = true;
  }
  return changed;
}

bool SettlingDrag::raise(const BlockTerms& terms, const HeldUnknowns& held, const Eigen::VectorXd& d) {
  factors_.resize(terms.area.size(), 1.0);
  moved_.resize(terms.area.size(), 0.0);
  is_carried_.resize(terms.area.size(), 0);
  const double small = small_share * area_of_most(terms, held, areas_);
  bool raised = false;
  for (std::size_t i = 0; i < factors_.size(); ++i) {
    if (held.holds(static_cast<int>(i))) continue;
    const double before = moved_[i];
    moved_[i] = motion_share(own(d, i), terms.area[i]);
    const double most = terms.area[i] < small ? most_motion_of_small : most_motion;
    const bool goes_on = moved_[i] > carried * before;
    if (before > most && goes_on) is_carried_[i] = 1;
    if (moved_[i] <= most || (before > 0 && goes_on)) continue;
    factors_[i] *= moved_[i] / (share_after_raise * most);
    raised = true;
  }
  return raised;
}

bool SettlingDrag::follow(const BlockTerms& terms, const Eigen::VectorXd& d) {
  travelled_.resize(factors_.size(), 0.0);
  is_carried_.resize(factors_.size(), 0);
  const std::size_t before = loose_.size();
  for (std::size_t i = 0; i < factors_.size(); ++i) {
    if (factors_[i] <= 1 || is_carried_[i] != 0 || travelled_[i] > most_travel) continue;
    travelled_[i] += motion_share(own(d, i), terms.area[i]);
    if (travelled_[i] > most_travel) loose_.push_back(static_cast<int>(i));
  }
  return loose_.size() > before;
}

void SettlingDrag::hold_loose(std::size_t blocks, HeldUnknowns& held) const {
  for (const int block : loose_) hold_still(block, blocks, held);
}

void SettlingDrag::add_to(const BlockTerms& terms, const StepCoefficients& step, BlockMatrix& matrix) const {
  for (std::size_t i = 0; i < factors_.size(); ++i)
    if (factors_[i] > 1)
      matrix.diagonal(static_cast<int>(i)) += (factors_[i] - 1) * step.mass * mass_matrix(terms.inertia[i]);
}

double SettlingDrag::work(const BlockTerms& terms, const StepCoefficients& step, const Eigen::VectorXd& d) const {
  double work = 0;
  for (std::size_t i = 0; i < factors_.size(); ++i)
    if (factors_[i] > 1)
      work += (factors_[i] - 1) * step.mass * own(d, i).dot(mass_matrix(terms.inertia[i]) * own(d, i));
  return work;
}

}  // namespace dda
