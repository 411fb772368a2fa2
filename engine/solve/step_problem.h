// One time step as a problem of its own, with no model behind it.
//
// Sought are the increments d of all blocks' six unknowns with
//
//   base d + factor * (sum over contacts and bolts of rows^T (force at the end - force at the start)) = rhs
//
// Everything that is linear is in `base`: inertia, dashpots, the blocks' elasticity, supports, and interfaces that are
// bonded. Forces of the start of the step, contacts' and bolts' included, are in `rhs`. The gaps of contacts and bolts
// at the end of the step are those of its start + rows * d, and their laws (engine/contact/open_close.h,
// engine/terms/bolt.h) say what force they answer with. Blocks that are held have their increments given.
//
// A problem refers to what it is made of: all of that must live, in place, until it is solved.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "engine/linear/block_matrix.h"
#include "engine/solve/bolt_trials.h"
#include "engine/solve/held_unknowns.h"
#include "engine/solve/interface_trials.h"

namespace dda {

struct StepProblem {
  const BlockMatrix& base;
  std::uint64_t base_version;  // another one than in the problem before: the values of `base` have changed
  const Eigen::VectorXd& rhs;
  const Eigen::VectorXd& guess;   // of the increments, for iterative linear solvers and where capacities are given
  bool begins_at_guess = false;   // where held blocks move: the others go along, and passes begin there
  double factor;                  // of the integrator, on forces at the end of the step
  std::span<const double> areas;  // of the blocks, m2: moments count as forces at the arm of a block's size
  // N per m of thickness, of each block: a step that begins with more out of balance takes a pass, however little it is
  // beside the forces of contacts. Empty: what is little beside these is enough.
  std::span<const double> asked_balance = {};
  ChangingContacts contacts;
  std::span<const LinkElement> bolts;
  const HeldUnknowns& held;
  bool dilates;            // some contact opens as it slides
  int max_passes;          // of the open-close iteration
  bool to_the_end = true;  // where quick passes do not settle take the sure ones; else the step is to be shortened
  bool goes_from_inside = true;  // where quick passes do not settle take interior ones, if friction follows the forces
  bool goes_one_way = false;     // where friction leaves several answers the linear solver does not choose among them
};

}  // namespace dda
