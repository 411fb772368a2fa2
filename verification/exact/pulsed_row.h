// A row of elastic bars, joined by springs and free at both ends, under a triangular push on its left end: exact in
// time, by the modes of its 2 n unknowns. Bars may differ in density. Poisson's ratio is 0, so the height is 1 m and
// does not count.
//
// Unknowns are the displacement u of each bar's middle (m) and its strain e:
//   kinetic energy  sum rho L (u'^2 + L^2 e'^2/12)/2
//   potential       sum E L e^2/2 + sum k g^2/2 - F (u_0 - L e_0/2),   g = u_(j+1) - L e_(j+1)/2 - u_j - L e_j/2
#pragma once

#include <Eigen/Core>
#include <vector>

namespace exact {

struct PulsedRow {
  std::vector<double> density;  // kg/m3, of each bar from the left
  double length = 1;            // m, of one bar
  double young = 0;             // Pa
  double joint_stiffness = 0;   // k, Pa/m
  double peak = 0;              // Pa, of the push, positive in +x
  double rise = 0, fall = 0;    // s
};

class RowMotion {
 public:
  explicit RowMotion(const PulsedRow& row);

  // m, of the middle of every bar at time t (s).
  [[nodiscard]] Eigen::VectorXd displacements(double t) const;

 private:
  [[nodiscard]] double mode_under_pulse(double omega2, double t) const;

  PulsedRow row_;
  Eigen::VectorXd omega2_;  // 1/s2
  Eigen::MatrixXd shapes_;  // displacements of the bars by mode
  Eigen::VectorXd push_;    // on each mode, for a push of 1 Pa
};

}  // namespace exact
