// Siconos' solvers of frictional contact problems, asked by their C interface.
#pragma once

#include <string>
#include <vector>

#include "verification/fclib/friction_problem.h"

namespace verify {

struct PeerAnswer {
  bool is_there = false;  // it says that it converged
  Eigen::VectorXd forces;
  int iterations = 0;
  double cpu_s = 0;  // of the solver alone, W given
};

struct PeerSolver {
  std::string name;
  int number;       // Siconos' own
  bool is_spatial;  // takes problems of three dimensions alone
  int most_iterations;
  Eigen::Index contacts;  // more of them are not worth waiting for
};

[[nodiscard]] const std::vector<PeerSolver>& siconos_solvers();

// With W of about 1 on its diagonal, and q of at most 1, which its tolerances are made for. A plane problem is solved
// as a spatial one whose second tangent nothing pushes along and nothing else is tied to.
[[nodiscard]] PeerAnswer ask_siconos(const PeerSolver& solver, const LocalFrictionProblem& problem, double tolerance);

}  // namespace verify
