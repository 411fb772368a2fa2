#include <stdexcept>
#include <string>
#include <utility>

#include "engine/contact/projected_law.h"
#include "verification/fclib/step_conversion.h"

namespace verify {
namespace {

using dda::EndStrength;
using dda::InterfaceElement;
using dda::InterfaceState;
using dda::StepProblem;
using Triplets = std::vector<Eigen::Triplet<double>>;

std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }

void refuse(bool has, const std::string& what) {
  if (has) throw std::invalid_argument("the step has " + what + ", which frictional contact problems have not");
}

void expect_coulomb(const InterfaceElement& element, const EndStrength& strength, const InterfaceState& state) {
  refuse(!element.dashpot.isZero(0), "contacts with dashpots");
  refuse(strength.dilation > 0, "joints that dilate");
  refuse(dda::press_together(element, {true, true}), "projected stretches");
  for (int end = 0; end < ends_of(element); ++end) {
    const auto e = static_cast<std::size_t>(end);
    refuse(!state.broken[e], "ends that are still bonded");
    refuse(state.residual[e] && strength.residual_cohesion != 0, "cohesion");
  }
}

void expect_coulomb(const StepProblem& step) {
  refuse(!step.bolts.empty(), "bolts");
  refuse(step.contacts.rule.conserves_energy, "energy-conserving contacts");
  refuse(step.contacts.rule.sticks, "contacts of unlimited strength");
  refuse(step.contacts.rule.capacity_is_given, "friction that is given");
  for (const int place : step.contacts.places)
    expect_coulomb(step.contacts.elements[at(place)], step.contacts.strengths[at(place)],
                   step.contacts.states[at(place)]);
}

// Where the unknowns of each block are among those that are sought; -1 of held blocks.
std::vector<Eigen::Index> places_of_blocks(const StepProblem& step) {
  std::vector<Eigen::Index> places(step.areas.size());
  Eigen::Index next = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
    places[i] = step.held.holds(static_cast<int>(i)) ? -1 : std::exchange(next, next + 6);
  return places;
}

class Writer {
 public:
  explicit Writer(const StepProblem& step) : step_(step), places_(places_of_blocks(step)) {
    known_.setZero(step.rhs.size());
    if (!step.held.empty()) step.held.put(known_);
    load_ = step.rhs;
  }

  FrictionProblem write() {
    Eigen::Index unknowns = 0;
    for (const Eigen::Index place : places_) unknowns = std::max(unknowns, place + 6);
    add_base();
    for (const int place : step_.contacts.places) add_contact(at(place));
    FrictionProblem problem;
    problem.mass.resize(unknowns, unknowns);
    problem.mass.setFromTriplets(mass_.begin(), mass_.end());
    problem.directions.resize(unknowns, static_cast<Eigen::Index>(gaps_.size()));
    problem.directions.setFromTriplets(directions_.begin(), directions_.end());
    problem.force = sought(load_, unknowns);
    problem.gaps = vector(gaps_);
    problem.compliance = vector(compliance_);
    problem.friction = vector(friction_);
    return problem;
  }

 private:
  static Eigen::VectorXd vector(const std::vector<double>& numbers) {
    return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
  }

  [[nodiscard]] Eigen::VectorXd sought(const Eigen::VectorXd& all, Eigen::Index unknowns) const {
    Eigen::VectorXd some(unknowns);
    for (std::size_t i = 0; i < places_.size(); ++i)
      if (places_[i] >= 0) some.segment<6>(places_[i]) = all.segment<6>(static_cast<Eigen::Index>(6 * i));
    return some;
  }

  // A_ii stays, A_ip d_p goes to the right.
  void add_base() {
    Eigen::VectorXd moved = Eigen::VectorXd::Zero(known_.size());
    step_.base.multiply(known_, moved);
    load_ -= moved;
    for (int column = 0; column < step_.base.size(); ++column) {
      const int first = step_.base.column_starts()[at(column)];
      add_block(column, column, step_.base.diagonal(column));
      for (int k = first + 1; k < step_.base.column_starts()[at(column) + 1]; ++k) {
        const int row = step_.base.block_rows()[at(k)];
        add_block(row, column, step_.base.offdiagonal(k));
        add_block(column, row, step_.base.offdiagonal(k).transpose());
      }
    }
  }

  void add_block(int row, int column, const dda::Mat6& block) {
    const Eigen::Index r = places_[at(row)], c = places_[at(column)];
    if (r < 0 || c < 0) return;
    for (Eigen::Index i = 0; i < 6; ++i)
      for (Eigen::Index j = 0; j < 6; ++j)
        if (block(i, j) != 0) mass_.emplace_back(r + i, c + j, block(i, j));
  }

  void add_contact(std::size_t i) {
    const InterfaceElement& element = step_.contacts.elements[i];
    const InterfaceState& state = step_.contacts.states[i];
    const EndStrength& strength = step_.contacts.strengths[i];
    for (int end = 0; end < ends_of(element); ++end) {
      add_row(element, state, 2 * end);
      add_row(element, state, 2 * end + 1);
      friction_.push_back(strength.friction_now(state.residual[static_cast<std::size_t>(end)]));
    }
  }

  void add_row(const InterfaceElement& element, const InterfaceState& state, int row) {
    double gap = state.gap(row);
    gap += add_part(element.block_a, element.rows_a.row(row), state.force(row));
    gap += add_part(element.block_b, element.rows_b.row(row), state.force(row));
    gaps_.push_back(gap);
    compliance_.push_back(1 / (step_.factor * element.stiffness(row)));
  }

  // The column of H that the next gap gets, in one block; the force of the start goes out of f. Returns what the block
  // opens the gap by where it is held.
  double add_part(int block, const Eigen::Matrix<double, 1, 6>& row, double force_at_start) {
    load_.segment<6>(6 * block) += step_.factor * force_at_start * row.transpose();
    const Eigen::Index place = places_[at(block)];
    if (place < 0) return row * known_.segment<6>(6 * block);
    const auto column = static_cast<Eigen::Index>(gaps_.size());
    for (Eigen::Index j = 0; j < 6; ++j)
      if (row(j) != 0) directions_.emplace_back(place + j, column, row(j));
    return 0;
  }

  const StepProblem& step_;
  std::vector<Eigen::Index> places_;
  Eigen::VectorXd known_, load_;
  Triplets mass_, directions_;
  std::vector<double> gaps_, compliance_, friction_;
};

}  // namespace

FrictionProblem friction_problem(const StepProblem& step) {
  expect_coulomb(step);
  return Writer(step).write();
}

Eigen::VectorXd forces_of(const StepProblem& step, const dda::InterfaceTrials& answer) {
  std::vector<double> forces;
  for (std::size_t k = 0; k < answer.size(); ++k)
    for (int row = 0; row < 2 * ends_of(answer.element(k)); ++row)
      forces.push_back(-step.factor * answer[k].force(row));
  return Eigen::Map<const Eigen::VectorXd>(forces.data(), static_cast<Eigen::Index>(forces.size()));
}

}  // namespace verify
