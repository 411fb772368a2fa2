// The problem of a step (engine/solve/step_problem.h) as a frictional contact problem, and back.
//
// A contact that presses with k_N and shears with k_T answers the gaps g = g0 + rows d of the end of the step with
//   f_N = k_N min(0, g_N),   f_T = k_T g_T, but no more than mu |f_N|.
// With r = -factor f and u = g + D r, D = 1/(factor k), that is u_N = 0 where it presses and u_N = g_N where it is
// open, and u_T is the slip of the step: Signorini's and Coulomb's laws, with nothing left out. The base matrix is M,
// the rows are the columns of H, and f = rhs + factor * sum of rows^T (forces of the start). Held blocks leave M; their
// way goes into f and w.
#pragma once

#include <vector>

#include "engine/solve/step_problem.h"
#include "verification/fclib/friction_problem.h"

namespace verify {

// Throws std::invalid_argument, in a sentence, where the step has what the form does not: bolts, dashpots, dilation,
// bonds, cohesion, projected stretches, energy-conserving contacts, or contacts that stick whatever they carry.
[[nodiscard]] FrictionProblem friction_problem(const dda::StepProblem& step);

// r of what the engine answers with, in the order of friction_problem().
[[nodiscard]] Eigen::VectorXd forces_of(const dda::StepProblem& step, const dda::InterfaceTrials& answer);

// A step with everything that it refers to.
struct OwnedStep {
  explicit OwnedStep(dda::BlockMatrix matrix) : base(std::move(matrix)) {}
  explicit OwnedStep(const dda::StepProblem& copied);

  [[nodiscard]] dda::StepProblem problem() const;

  dda::BlockMatrix base;
  Eigen::VectorXd rhs, guess;
  std::vector<double> areas;
  std::vector<int> places;
  std::vector<dda::InterfaceElement> elements;
  std::vector<dda::EndStrength> strengths;
  std::vector<dda::InterfaceState> states;
  dda::HeldUnknowns held;
  dda::ContactRule rule;
  double factor = 1;
  int max_passes = 200;
};

// Every `unknowns` (at most 6) unknowns of M are a block, and one block more is held: what contacts touch alone rests
// on it. Each contact becomes a lone vertex; where D is zero its spring is as stiff as `rigid` times the diagonal of
// W^-1, and so are strains that M has not. Throws std::invalid_argument where a contact is not at a point of one or two
// blocks, which is all that the engine has.
[[nodiscard]] OwnedStep step_of(const FrictionProblem& problem, int unknowns = 6, double rigid = 1e6);

}  // namespace verify
