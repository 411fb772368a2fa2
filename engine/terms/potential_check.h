// For tests: forces and stiffness of a quadratic energy by central differences, which are exact for it but for
// round-off whatever their step.
#pragma once

#include <Eigen/Core>

namespace dda {

template <int N>
using VecN = Eigen::Matrix<double, N, 1>;

// -dV/dq is the force; this is dV/dq at `q`.
template <int N, class Energy>
VecN<N> gradient(const Energy& energy, const VecN<N>& q, double step) {
  VecN<N> result;
  for (int i = 0; i < N; ++i) {
    const VecN<N> shift = step * VecN<N>::Unit(i);
    result(i) = (energy(VecN<N>(q + shift)) - energy(VecN<N>(q - shift))) / (2 * step);
  }
  return result;
}

template <int N, class Energy>
Eigen::Matrix<double, N, N> hessian(const Energy& energy, double step) {
  Eigen::Matrix<double, N, N> result;
  for (int i = 0; i < N; ++i) {
    const auto slope = [&](const VecN<N>& q) -> double {
      const VecN<N> shift = step * VecN<N>::Unit(i);
      return (energy(VecN<N>(q + shift)) - energy(VecN<N>(q - shift))) / (2 * step);
    };
    result.col(i) = gradient<N>(slope, VecN<N>::Zero(), step);
  }
  return result;
}

// Largest difference of two matrices, relative to the largest entry of the second.
template <class A, class B>
double relative_difference(const A& actual, const B& expected) {
  return (actual - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

}  // namespace dda
