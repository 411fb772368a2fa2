#include "verification/fclib/every_status.h"

#include <Eigen/LU>
#include <cmath>

namespace verify {
namespace {

// The share of the largest force and of the largest gap that counts as round-off.
constexpr double round_off = 1e-9;

enum Status { open, sticks, slides_up, slides_down };

Status status_of(int code, Eigen::Index contact) { return static_cast<Status>((code >> (2 * contact)) & 3); }

Eigen::VectorXd forces_for(const Eigen::MatrixXd& w, const LocalFrictionProblem& problem, int code) {
  Eigen::MatrixXd equations = Eigen::MatrixXd::Identity(w.rows(), w.rows());
  Eigen::VectorXd right = Eigen::VectorXd::Zero(w.rows());
  for (Eigen::Index k = 0; k < problem.friction.size(); ++k) {
    const Status status = status_of(code, k);
    const Eigen::Index n = 2 * k, t = n + 1;
    if (status == open) continue;
    equations.row(n) = w.row(n);
    right(n) = -problem.free(n);
    if (status == sticks) {
      equations.row(t) = w.row(t);
      right(t) = -problem.free(t);
    } else {  // against the way it slides
      equations(t, n) = status == slides_up ? problem.friction(k) : -problem.friction(k);
    }
  }
  return equations.fullPivLu().solve(right);
}

bool holds(const Eigen::MatrixXd& w, const LocalFrictionProblem& problem, int code, const Eigen::VectorXd& r) {
  const Eigen::VectorXd u = w * r + problem.free;
  const double force = round_off * r.cwiseAbs().maxCoeff();
  const double gap = round_off * problem.free.cwiseAbs().maxCoeff();
  for (Eigen::Index k = 0; k < problem.friction.size(); ++k) {
    const Status status = status_of(code, k);
    const Eigen::Index n = 2 * k, t = n + 1;
    if (status == open && u(n) < -gap) return false;
    if (status != open && r(n) < -force) return false;
    if (status == sticks && std::abs(r(t)) > problem.friction(k) * r(n) + force) return false;
    if (status == slides_up && u(t) < -gap) return false;
    if (status == slides_down && u(t) > gap) return false;
  }
  return true;
}

}  // namespace

std::vector<Eigen::VectorXd> every_answer(const LocalFrictionProblem& problem) {
  const Eigen::MatrixXd w = problem.delassus;
  std::vector<Eigen::VectorXd> answers;
  for (int code = 0; code < 1 << (2 * problem.friction.size()); ++code) {
    const Eigen::VectorXd forces = forces_for(w, problem, code);
    if (holds(w, problem, code, forces)) answers.push_back(forces);
  }
  return answers;
}

}  // namespace verify
