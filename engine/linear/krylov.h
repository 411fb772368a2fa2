// Krylov iterations with the operator and the preconditioner as functions. Both measure residuals in the norm
// sqrt(r . P^-1 r), which has no units to mix and comes free.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "engine/core/status.h"
#include "engine/linear/block_vectors.h"

namespace dda {

struct KrylovResult {
  Status status = Status::ok;  // not_converged: too many iterations; singular: not positive definite; not_finite
  int iterations = 0;
};

// Hestenes & Stiefel (1952), for a symmetric positive definite operator and preconditioner.
class ConjugateGradients {
 public:
  void resize(Eigen::Index unknowns) {
    for (Eigen::VectorXd* vector : {&residual_, &preconditioned_, &direction_, &image_}) vector->resize(unknowns);
  }

  // b - A x of the last solution.
  [[nodiscard]] const Eigen::VectorXd& residual() const { return residual_; }

  // Solves A x = b from the x given to |r| <= relative |b|. multiply(v, w): w = A v; precondition(r, z): z = P^-1 r,
  // returns r . z. Allocates nothing.
  template <typename Multiply, typename Precondition>
  KrylovResult solve(const Multiply& multiply, const Precondition& precondition, const Eigen::VectorXd& b,
                     double relative, int most, Eigen::VectorXd& x) {
    const double rhs_norm = precondition(b, preconditioned_);
    if (!std::isfinite(rhs_norm)) return {Status::not_finite, 0};
    residual_ = b;
    if (rhs_norm == 0) x.setZero();
    if (x.isZero(0)) return iterate(multiply, precondition, rhs_norm, relative * relative * rhs_norm, most, x);
    multiply(x, image_);
    residual_ -= image_;
    const double norm = precondition(residual_, preconditioned_);
    return iterate(multiply, precondition, norm, relative * relative * rhs_norm, most, x);
  }

 private:
  template <typename Multiply, typename Precondition>
  KrylovResult iterate(const Multiply& multiply, const Precondition& precondition, double norm, double target, int most,
                       Eigen::VectorXd& x) {
    KrylovResult result;
    direction_ = preconditioned_;
    while (!(norm <= target)) {
      if (!std::isfinite(norm)) result.status = Status::not_finite;
      if (result.iterations == most) result.status = Status::not_converged;
      if (result.status != Status::ok) break;
      multiply(direction_, image_);
      const double curvature = dot(direction_, image_);
      if (curvature <= 0) {
        result.status = Status::singular;
        break;
      }
      const double step = norm / curvature;
      in_stretches(x.size(), [&](const VectorStretch& here) {
        here.of(x) += step * here.of(direction_);
        here.of(residual_) -= step * here.of(image_);
      });
      const double previous = norm;
      norm = precondition(residual_, preconditioned_);
      const double keep = norm / previous;
      in_stretches(x.size(), [&](const VectorStretch& here) {
        here.of(direction_) = here.of(preconditioned_) + keep * here.of(direction_);
      });
      ++result.iterations;
    }
    return result;
  }

  Eigen::VectorXd residual_, preconditioned_, direction_, image_;
};

// Generalized minimal residuals (Saad & Schultz 1986), for an operator that is not symmetric and a preconditioner that
// is symmetric positive definite: Arnoldi's method in the inner product of the preconditioner. Keeps u = P v beside
// each basis vector v, so that every product with P is at hand.
class Gmres {
 public:
  explicit Gmres(int basis) : basis_(basis) {}

  void resize(Eigen::Index unknowns);

  // As ConjugateGradients::solve, but from x = 0. Where the basis is full it begins again from what is left, unless
  // that is hardly less than before. not_converged leaves the best x found. Allocates nothing.
  template <typename Multiply, typename Precondition>
  KrylovResult solve(const Multiply& multiply, const Precondition& precondition, const Eigen::VectorXd& b,
                     double relative, int most, Eigen::VectorXd& x) {
    constexpr double hardly_less = 0.5;
    x.setZero();
    work_ = b;
    double left = begin(precondition);
    const double target = relative * left;
    KrylovResult result;
    while (std::isfinite(left) && left > target) {
      const double begun_with = left;
      left = use_basis(multiply, precondition, target, most, result.iterations, x);
      if (!(left > target)) break;
      if (result.iterations == most || left > hardly_less * begun_with)
        return {Status::not_converged, result.iterations};
      multiply(x, work_);
      work_ = b - work_;
      left = begin(precondition);
    }
    if (!std::isfinite(left)) result.status = Status::not_finite;
    return result;
  }

 private:
  double rotate(int k);
  void combine(int k, Eigen::VectorXd& x);
  double& h(int row, int column) {
    const auto height = static_cast<std::size_t>(basis_) + 1;
    return hessenberg_[static_cast<std::size_t>(column) * height + static_cast<std::size_t>(row)];
  }

  // With work_ as what is to be solved for; returns its norm.
  template <typename Precondition>
  double begin(const Precondition& precondition) {
    const double norm = std::sqrt(precondition(work_, v_[0]));
    if (norm == 0) return 0;
    u_[0] = work_ / norm;
    v_[0] /= norm;
    rhs_[0] = norm;
    return norm;
  }

  // Adds to x what a basis gives, and returns the norm of what is left.
  template <typename Multiply, typename Precondition>
  double use_basis(const Multiply& multiply, const Precondition& precondition, double target, int most, int& iterations,
                   Eigen::VectorXd& x) {
    double left = rhs_[0];
    int size = 0;
    for (; left > target && size < basis_ && iterations < most; ++iterations)
      left = add_direction(multiply, precondition, size++);
    if (std::isfinite(left)) combine(size, x);
    return left;
  }

  // One more basis vector; returns the norm of the residual.
  template <typename Multiply, typename Precondition>
  double add_direction(const Multiply& multiply, const Precondition& precondition, int k) {
    const auto at = static_cast<std::size_t>(k);
    multiply(v_[at], work_);
    for (int j = 0; j <= k; ++j) {
      const Eigen::VectorXd& u = u_[static_cast<std::size_t>(j)];
      const double along = dot(v_[static_cast<std::size_t>(j)], work_);
      h(j, k) = along;
      in_stretches(work_.size(), [&](const VectorStretch& here) { here.of(work_) -= along * here.of(u); });
    }
    const double norm = std::sqrt(std::max(0.0, precondition(work_, v_[at + 1])));
    h(k + 1, k) = norm;
    const double scale = norm > 0 ? 1 / norm : 0;
    u_[at + 1] = scale * work_;
    v_[at + 1] *= scale;
    return rotate(k);
  }

  int basis_;
  std::vector<Eigen::VectorXd> u_, v_;
  Eigen::VectorXd work_;
  std::vector<double> hessenberg_, cosine_, sine_, rhs_;
};

}  // namespace dda
