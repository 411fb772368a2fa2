#include "verification/exact/dense_newmark.h"

#include <Eigen/SparseLU>
#include <stdexcept>

namespace exact {
namespace {

// Chains couple neighbours only: without zeros a step costs as much as there are blocks. The order stays as given, so
// that a band stays a band.
using Matrix = Eigen::SparseMatrix<double>;
using Solver = Eigen::SparseLU<Matrix, Eigen::NaturalOrdering<int>>;

void check_sizes(const DenseSystem& system, const Eigen::MatrixXd& observe) {
  const Eigen::Index n = system.mass.rows();
  const auto is_square = [n](const Eigen::MatrixXd& matrix) { return matrix.rows() == n && matrix.cols() == n; };
  if (!is_square(system.mass) || !is_square(system.damping) || !is_square(system.stiffness) || observe.cols() != n) {
    throw std::invalid_argument("the matrices of the dense system disagree in size");
  }
}

}  // namespace

Eigen::MatrixXd dense_newmark(const DenseSystem& system, const TimeScheme& scheme, double dt, int steps,
                              const std::function<Eigen::VectorXd(int)>& load, const Eigen::MatrixXd& observe) {
  check_sizes(system, observe);
  const double am = scheme.alpha_m, af = scheme.alpha_f;
  const Matrix mass = system.mass.sparseView(), damping = system.damping.sparseView(),
               stiffness = system.stiffness.sparseView();
  const Solver effective_mass(
      Matrix((1 - am) * mass + (1 - af) * (scheme.gamma * dt * damping + scheme.beta * dt * dt * stiffness)));
  Eigen::VectorXd force = load(0);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(mass.rows()), v = u, a = u;
  if (!force.isZero(0)) a = Solver(mass).solve(force);
  Eigen::MatrixXd history(observe.rows(), steps + 1);
  history.col(0) = observe * u;
  for (int i = 1; i <= steps; ++i) {
    const Eigen::VectorXd next_force = load(i);
    const Eigen::VectorXd u_free = u + dt * scheme.carried_velocity * v + dt * dt * (0.5 - scheme.beta) * a;
    const Eigen::VectorXd v_free = scheme.carried_velocity * v + dt * (1 - scheme.gamma) * a;
    const Eigen::VectorXd residual = (1 - af) * next_force + af * force - am * (mass * a) -
                                     damping * ((1 - af) * v_free + af * v) - stiffness * ((1 - af) * u_free + af * u);
    a = effective_mass.solve(residual);
    u = u_free + scheme.beta * dt * dt * a;
    v = v_free + scheme.gamma * dt * a;
    force = next_force;
    history.col(i) = observe * u;
  }
  return history;
}

}  // namespace exact
