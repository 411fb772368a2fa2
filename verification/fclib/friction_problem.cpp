#include "verification/fclib/friction_problem.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace verify {

LocalFrictionProblem local_problem(const FrictionProblem& problem) {
  const Eigen::SimplicialLDLT<SparseMatrix> factor(problem.mass);
  const SparseMatrix transposed = problem.directions.transpose();
  const SparseMatrix moved = factor.solve(problem.directions);
  SparseMatrix delassus = transposed * moved;
  SparseMatrix springs(delassus.rows(), delassus.cols());
  springs.setIdentity();
  springs.diagonal() = problem.compliance;
  delassus += springs;
  const Eigen::VectorXd free = transposed * factor.solve(problem.force);
  return {delassus, free + problem.gaps, problem.friction};
}

double residual(const LocalFrictionProblem& problem, const Eigen::VectorXd& forces) {
  const Eigen::VectorXd moved = problem.delassus * forces + problem.free;
  const Eigen::VectorXd softness = problem.delassus.diagonal();
  double largest = 0;
  for (Eigen::Index k = 0; k < problem.friction.size(); ++k) {
    const Eigen::Index n = 2 * k;
    const double pressed = std::max(0.0, forces(n) - moved(n) / softness(n));
    const double bound = problem.friction(k) * std::max(0.0, forces(n));
    const double held = std::clamp(forces(n + 1) - moved(n + 1) / softness(n + 1), -bound, bound);
    largest = std::max({largest, std::abs(forces(n) - pressed), std::abs(forces(n + 1) - held)});
  }
  const double scale = forces.size() == 0 ? 0 : forces.cwiseAbs().maxCoeff();
  return scale > 0 ? largest / scale : largest;
}

}  // namespace verify
