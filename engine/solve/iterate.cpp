#include "engine/solve/iterate.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/contact/contact_sharing.h"
#include "engine/core/parallel.h"
#include "engine/solve/largest_entry.h"

namespace dda {
namespace {

template <typename Value>
double largest_of_contacts(const StepProblem& problem, const Value& value) {
  const std::span<const int> places = problem.contacts.places;
  const auto largest = [&](std::size_t first, std::size_t last) {
    double so_far = 0;
    for (std::size_t i = first; i < last; ++i)
      so_far = larger(so_far, value(problem.contacts.elements[static_cast<std::size_t>(places[i])]));
    return so_far;
  };
  return parallel_reduce(places.size(), contacts_worth_sharing, larger, largest);
}

}  // namespace

void Iterate::pose(const StepProblem& posed) {
  problem = &posed;
  constexpr double share =
      1e-13;  // of the largest on the right-hand side, moments as forces at the arm of a block's size
  round_off_of_forces = is_linear() ? 0 : share * largest_of_blocks(problem->rhs, problem->areas);
  largest_stiffness_ = largest_of_contacts(
      posed, [](const InterfaceElement& element) -> double { return element.stiffness.maxCoeff(); });
}

// What carrying leaves is mostly far below the rest, which a bound tells without a look at every contact.
double Iterate::negligible_force(double largest_force) const {
  const double without = std::max(share_of_forces * largest_force, round_off_of_forces);
  if (share_of_carrying * largest_stiffness_ * longest_way() <= without) return without;
  return std::max(without, round_off_of_carrying());
}

double Iterate::longest_way() const {
  double squared = 0;
  for (Eigen::Index first = 0; first < increment.size(); first += 6)
    squared = std::max(squared, increment.segment<2>(first).squaredNorm());
  return std::sqrt(squared);
}

double Iterate::round_off_of_carrying() const {
  const auto way = [this](int block) { return increment.segment<2>(6 * block).norm(); };
  const auto carried = [&](const InterfaceElement& element) {
    return element.stiffness.maxCoeff() * std::max(way(element.block_a), way(element.block_b));
  };
  return share_of_carrying * largest_of_contacts(*problem, carried);
}

Status Iterate::bring_matrix_up_to_date(bool& changed) {
  const bool bolts_changed = bolts.take_up_rows();
  const std::int64_t changes = contacts.take_up_rows();
  costs.counters.contact_state_changes += changes;
  changed = bolts_changed || changes > 0;
  const bool serves = matrix.is_current() && !changed && !matrix.factor_is_of_part();
  return serves ? Status::ok : refactor();
}

Status Iterate::refactor() {
  matrix.assemble(problem->held, [this](BlockMatrix& values) {
    values.set_values(problem->base);
    contacts.add_stiffness(problem->factor, values);
    bolts.add_stiffness(problem->factor, values);
  });
  return matrix.factorize();
}

void Iterate::add_constant_forces(Eigen::VectorXd& rhs) const {
  contacts.add_rhs(problem->factor, rhs);
  bolts.add_rhs(problem->factor, rhs);
}

}  // namespace dda
