#include "engine/keyblocks/non_negative.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cstddef>
#include <vector>

namespace dda {
namespace {

class NonNegative {
 public:
  NonNegative(const Eigen::MatrixXd& columns, const Eigen::VectorXd& target)
      : columns_(columns), target_(target), x_(Eigen::VectorXd::Zero(columns.cols())) {}

  double left() {
    const Eigen::Index most = 10 * columns_.cols() + 10;
    for (Eigen::Index i = 0; i < most && add_best_column(); ++i) step_to_feasible();
    return (target_ - columns_ * x_).norm();
  }

 private:
  bool add_best_column() {
    const Eigen::VectorXd gain = columns_.transpose() * (target_ - columns_ * x_);
    Eigen::Index best = -1;
    for (Eigen::Index j = 0; j < gain.size(); ++j) {
      const bool used = std::find(used_.begin(), used_.end(), j) != used_.end();
      if (!used && gain[j] > 1e-12 && (best < 0 || gain[j] > gain[best])) best = j;
    }
    if (best >= 0) used_.push_back(best);
    return best >= 0;
  }

  void step_to_feasible() {
    while (!used_.empty()) {
      const Eigen::VectorXd wanted = columns_(Eigen::all, used_).completeOrthogonalDecomposition().solve(target_);
      double share = 1;
      for (std::size_t k = 0; k < used_.size(); ++k) {
        const double now = x_[used_[k]];
        const double then = wanted[static_cast<Eigen::Index>(k)];
        if (then <= 0) share = std::min(share, now > 0 ? now / (now - then) : 0.0);
      }
      for (std::size_t k = 0; k < used_.size(); ++k)
        x_[used_[k]] += share * (wanted[static_cast<Eigen::Index>(k)] - x_[used_[k]]);
      if (share == 1) return;
      std::erase_if(used_, [&](Eigen::Index j) {
        const bool gone = x_[j] <= 1e-15;
        if (gone) x_[j] = 0;
        return gone;
      });
    }
  }

  const Eigen::MatrixXd& columns_;
  const Eigen::VectorXd& target_;
  Eigen::VectorXd x_;
  std::vector<Eigen::Index> used_;
};

}  // namespace

double least_left(const Eigen::MatrixXd& columns, const Eigen::VectorXd& target) {
  return NonNegative(columns, target).left();
}

}  // namespace dda
