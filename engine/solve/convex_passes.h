// The sure passes of the open-close iteration.
//
// With friction capacities given, the step minimizes the convex, piecewise quadratic
//   1/2 d A0 d - d . rhs + stiffness factor * (potentials of all contacts and bolts)
// over the increments d, A0 being the matrix without dry contacts. Newton's method solves with the rows active at the
// point reached; a line search along its step (exact: the slope is continuous and increasing) makes every pass lower
// the minimum sought, so no set of statuses comes twice and the passes end. Capacities move to friction times normal
// force until forces stand still.
#pragma once

#include <Eigen/Core>

#include "engine/core/status.h"
#include "engine/solve/iterate.h"

namespace dda {

class ConvexPasses {
 public:
  // A step begins; `guess` of its increments is where an iterative linear solver starts.
  void start(const Eigen::VectorXd& guess);

  // Back to the start of the step, but for what broke since.
  void restart(Iterate& at);

  // Takes the iterate as it is, and its contacts at what they answer there.
  void go_on_from(Iterate& at);

  // Moves the iterate to where forces and capacities stand still, in this many passes at most. Anything but ok: see
  // `failure`.
  [[nodiscard]] Status settle(Iterate& at, int most_passes);
  [[nodiscard]] Failure failure() const { return failure_; }

 private:
  [[nodiscard]] Status solve_pass(Iterate& at);
  [[nodiscard]] bool take_newton_step(Iterate& at);
  [[nodiscard]] double length_of_step(const Iterate& at);

  Eigen::VectorXd target_;  // increments that a pass solves for
  Eigen::VectorXd step_;    // from the increments reached to them
  Eigen::VectorXd rhs_;     // of a pass
  Eigen::VectorXd image_;   // matrix * step
  Failure failure_ = Failure::none;
};

// Changes of forces below it count as none: far below what a stress or displacement is read to.
double negligible_force(const Iterate& at);

}  // namespace dda
