#include "verification/exact/pulsed_row.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace exact {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The displacement of a bar's face (side -1: left, 1: right) as a linear form of all unknowns.
VectorXd face(const PulsedRow& row, Index bar, double side) {
  VectorXd form = VectorXd::Zero(2 * static_cast<Index>(row.density.size()));
  form[2 * bar] = 1;
  form[2 * bar + 1] = side * row.length / 2;
  return form;
}

VectorXd masses(const PulsedRow& row) {
  VectorXd mass(2 * static_cast<Index>(row.density.size()));
  for (Index i = 0; i < mass.size() / 2; ++i) {
    mass[2 * i] = row.density[static_cast<std::size_t>(i)] * row.length;
    mass[2 * i + 1] = mass[2 * i] * row.length * row.length / 12;
  }
  return mass;
}

MatrixXd stiffness(const PulsedRow& row) {
  const auto bars = static_cast<Index>(row.density.size());
  MatrixXd k = MatrixXd::Zero(2 * bars, 2 * bars);
  for (Index i = 0; i < bars; ++i) {
    k(2 * i + 1, 2 * i + 1) += row.young * row.length;
    if (i + 1 == bars) continue;
    const VectorXd gap = face(row, i + 1, -1) - face(row, i, 1);
    k += row.joint_stiffness * gap * gap.transpose();
  }
  return k;
}

// From rest, of q'' + omega^2 q = max(t, 0).
double under_ramp(double omega2, double t) {
  if (t <= 0) return 0;
  const double phase = std::sqrt(std::max(omega2, 0.0)) * t;
  constexpr double small = 1e-2;  // the next term of the series is phase^4/840: 1e-11
  if (phase < small) return t * t * t / 6 * (1 - phase * phase / 20);
  return (t - t * std::sin(phase) / phase) / omega2;
}

}  // namespace

RowMotion::RowMotion(const PulsedRow& row) : row_(row) {
  const VectorXd scale = masses(row).cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> modes(scale.asDiagonal() * stiffness(row) * scale.asDiagonal());
  omega2_ = modes.eigenvalues();
  omega2_[0] = 0;  // the row moves as a whole
  const MatrixXd all = scale.asDiagonal() * modes.eigenvectors();
  shapes_ = all(Eigen::seq(0, Eigen::last, 2), Eigen::all);
  push_ = all.transpose() * face(row, 0, -1);
}

double RowMotion::mode_under_pulse(double omega2, double t) const {
  return row_.peak *
         (under_ramp(omega2, t) / row_.rise - (1 / row_.rise + 1 / row_.fall) * under_ramp(omega2, t - row_.rise) +
          under_ramp(omega2, t - row_.rise - row_.fall) / row_.fall);
}

VectorXd RowMotion::displacements(double t) const {
  VectorXd amplitude(omega2_.size());
  for (Index mode = 0; mode < omega2_.size(); ++mode) amplitude[mode] = mode_under_pulse(omega2_[mode], t);
  return shapes_ * amplitude.cwiseProduct(push_);
}

}  // namespace exact
