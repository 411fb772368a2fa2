#include "engine/solve/bolt_trials.h"

#include <algorithm>

namespace dda {

BoltAnswer answer_of(const BoltLaw& law, const Vec2& gap, bool ruptured) {
  return ruptured ? BoltAnswer{Vec2::Zero(), Vec2::Zero()} : bolt_answer(law, gap);
}

void add_link(const LinkElement& link, const Vec2& stiffness, BlockMatrix& matrix) {
  const Eigen::Matrix<double, 6, 2> weighted_a = link.rows.a.transpose() * stiffness.asDiagonal();
  const Eigen::Matrix<double, 6, 2> weighted_b = link.rows.b.transpose() * stiffness.asDiagonal();
  matrix.diagonal(link.block_a) += weighted_a * link.rows.a;
  matrix.diagonal(link.block_b) += weighted_b * link.rows.b;
  matrix.add_coupling(link.block_b, link.block_a, weighted_b * link.rows.a);
}

void BoltTrials::respond(std::size_t k) {
  LinkTrial& trial = trials_[k];
  const BoltAnswer answer = answer_of(links_[k].law, trial.gap, trial.ruptures);
  trial.force = answer.force;
  trial.active = answer.active;
}

void BoltTrials::start(std::span<const LinkElement> links) {
  links_ = links;
  trials_.resize(links.size());
  if (matrix_rows_.size() != links.size()) matrix_rows_.assign(links.size(), Vec2::Constant(-1));
  for (std::size_t k = 0; k < trials_.size(); ++k) trials_[k].ruptures = links_[k].carries_nothing();
  restart();
}

void BoltTrials::restart() {
  for (std::size_t k = 0; k < trials_.size(); ++k) {
    trials_[k].gap = links_[k].state.gap;
    respond(k);
  }
}

bool BoltTrials::rows_are_stale() const {
  for (std::size_t k = 0; k < trials_.size(); ++k)
    if (matrix_rows_[k] != trials_[k].active) return true;
  return false;
}

bool BoltTrials::take_up_rows() {
  bool changed = false;
  for (std::size_t k = 0; k < trials_.size(); ++k) {
    if (matrix_rows_[k] == trials_[k].active) continue;
    matrix_rows_[k] = trials_[k].active;
    changed = true;
  }
  return changed;
}

void BoltTrials::add_stiffness(double factor, BlockMatrix& matrix) const {
  for (std::size_t k = 0; k < trials_.size(); ++k) {
    if (matrix_rows_[k].isZero(0)) continue;  // the matrix may have no room for a bolt that waits
    add_link(links_[k], factor * matrix_rows_[k].cwiseProduct(links_[k].law.stiffness), matrix);
  }
}

void BoltTrials::add_rhs(double factor, Eigen::VectorXd& rhs) const {
  for (std::size_t k = 0; k < trials_.size(); ++k) {
    const LinkElement& link = links_[k];
    const Vec2 reached = trials_[k].gap - link.state.gap;
    const Vec2 constant =
        trials_[k].force - matrix_rows_[k].cwiseProduct(link.law.stiffness).cwiseProduct(reached) - link.state.force;
    rhs.segment<6>(6 * link.block_a).noalias() -= factor * link.rows.a.transpose() * constant;
    rhs.segment<6>(6 * link.block_b).noalias() -= factor * link.rows.b.transpose() * constant;
  }
}

void BoltTrials::aim(const Eigen::VectorXd& newton_step) {
  for (std::size_t k = 0; k < trials_.size(); ++k) {
    const LinkElement& link = links_[k];
    trials_[k].direction =
        link.rows.a * newton_step.segment<6>(6 * link.block_a) + link.rows.b * newton_step.segment<6>(6 * link.block_b);
  }
}

double BoltTrials::mismatch() const {
  double mismatch = 0;
  for (std::size_t k = 0; k < trials_.size(); ++k) {
    const LinkTrial& trial = trials_[k];
    const BoltLaw& law = links_[k].law;
    const Vec2 after = answer_of(law, trial.gap + trial.direction, trial.ruptures).force;
    const Vec2 expected = trial.active.cwiseProduct(law.stiffness).cwiseProduct(trial.direction);
    mismatch = std::max(mismatch, (after - trial.force - expected).cwiseAbs().maxCoeff());
  }
  return mismatch;
}

double BoltTrials::largest_force() const {
  double largest = 0;
  for (const LinkTrial& trial : trials_) largest = std::max(largest, trial.force.cwiseAbs().maxCoeff());
  return largest;
}

void BoltTrials::take_out(double factor, LineSlope& line) const {
  double curvature = 0;
  double slope = 0;
  for (std::size_t k = 0; k < trials_.size(); ++k) {
    const LinkTrial& trial = trials_[k];
    const LinkElement& link = links_[k];
    const Vec2 along = trial.active.cwiseProduct(link.law.stiffness).cwiseProduct(trial.direction);
    curvature += trial.direction.dot(along);
    slope += along.dot(trial.gap - link.state.gap) + trial.direction.dot(link.state.force);
  }
  line.curvature -= factor * curvature;
  line.at_start -= factor * slope;
}

void BoltTrials::add_slope(double factor, double t, double& slope) const {
  double along = 0;
  for (std::size_t k = 0; k < trials_.size(); ++k) {
    const LinkTrial& trial = trials_[k];
    along += trial.direction.dot(answer_of(links_[k].law, trial.gap + t * trial.direction, trial.ruptures).force);
  }
  slope += factor * along;
}

void BoltTrials::follow(double share) {
  for (std::size_t k = 0; k < trials_.size(); ++k) {
    trials_[k].gap += share * trials_[k].direction;
    respond(k);
  }
}

void BoltTrials::break_links(std::vector<int>& broken) {
  for (std::size_t k = 0; k < trials_.size(); ++k) {
    LinkTrial& trial = trials_[k];
    if (trial.ruptures || links_[k].elongation(trial.gap) <= links_[k].rupture_elongation) continue;
    trial.ruptures = true;
    respond(k);
    broken.push_back(static_cast<int>(k));
  }
}

}  // namespace dda
