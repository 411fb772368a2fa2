// The point that the iteration of a step has reached: increments, trials, and the matrix that belongs to them. Both
// kinds of passes move it.
#pragma once

#include <Eigen/Core>

#include "engine/core/status.h"
#include "engine/solve/bolt_trials.h"
#include "engine/solve/costs.h"
#include "engine/solve/interface_trials.h"
#include "engine/solve/step_matrix.h"
#include "engine/solve/step_problem.h"

namespace dda {

struct Iterate {
  explicit Iterate(Costs& shared) : costs(shared), matrix(shared) {}

  Costs& costs;
  const StepProblem* problem = nullptr;
  double round_off_of_forces = 0;  // what a solve leaves on blocks that only just touch, N per m of thickness
  InterfaceTrials contacts;
  BoltTrials bolts;
  StepMatrix matrix;
  Eigen::VectorXd increment;

  // No contact and no bolt: one linear solve is all there is to do.
  [[nodiscard]] bool is_linear() const { return contacts.empty() && bolts.empty(); }

  // Forces stand still, and blocks are in balance, to this much where this is the largest force of contacts and bolts
  // (N per m of thickness): a share of it far below what a stress or displacement is read to, or what round-off leaves.
  [[nodiscard]] double negligible_force(double largest_force) const;

  // The problem from now on.
  void pose(const StepProblem& posed);

  // The matrix is to hold the stiffness of the rows active now: assembled and factored anew where it does not.
  // `changed` tells whether some row did.
  [[nodiscard]] Status bring_matrix_up_to_date(bool& changed);

  // Adds what of the contacts' and bolts' forces does not depend on the unknowns.
  void add_constant_forces(Eigen::VectorXd& rhs) const;

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [costs, problem, round_off_of_forces, contacts, bolts, matrix, increment, largest_stiffness] = self;
    archive(contacts, bolts);  // the matrix is made anew, increments begin at zero
  }

 private:
  static constexpr double share_of_forces = 1e-10;
  static constexpr double share_of_carrying = 1e-15;

  [[nodiscard]] Status refactor();
  [[nodiscard]] double longest_way() const;
  // Springs make forces of the increments that carry blocks along, and these cancel but for their last digits.
  [[nodiscard]] double round_off_of_carrying() const;

  double largest_stiffness_ = 0;  // of the contacts of the problem, N/m per m of thickness
};

}  // namespace dda
