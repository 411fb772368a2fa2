#include "engine/linear/krylov.h"

#include <cstddef>

namespace dda {

void Gmres::resize(Eigen::Index unknowns) {
  const auto vectors = static_cast<std::size_t>(basis_) + 1;
  u_.resize(vectors);
  v_.resize(vectors);
  for (std::size_t i = 0; i < vectors; ++i) {
    u_[i].resize(unknowns);
    v_[i].resize(unknowns);
  }
  work_.resize(unknowns);
  hessenberg_.resize(vectors * static_cast<std::size_t>(basis_));
  cosine_.resize(vectors);
  sine_.resize(vectors);
  rhs_.resize(vectors);
}

// Givens rotations make the Hessenberg matrix triangular, column by column; what they leave of the right-hand side
// below it is the residual.
double Gmres::rotate(int k) {
  for (int j = 0; j < k; ++j) {
    const auto at = static_cast<std::size_t>(j);
    const double upper = cosine_[at] * h(j, k) + sine_[at] * h(j + 1, k);
    h(j + 1, k) = -sine_[at] * h(j, k) + cosine_[at] * h(j + 1, k);
    h(j, k) = upper;
  }
  const auto at = static_cast<std::size_t>(k);
  const double length = std::hypot(h(k, k), h(k + 1, k));
  cosine_[at] = h(k, k) / length;
  sine_[at] = h(k + 1, k) / length;
  h(k, k) = length;
  rhs_[at + 1] = -sine_[at] * rhs_[at];
  rhs_[at] *= cosine_[at];
  return std::abs(rhs_[at + 1]);
}

// x = V y with H y = rhs.
void Gmres::combine(int k, Eigen::VectorXd& x) {
  for (int i = k - 1; i >= 0; --i) {
    const auto at = static_cast<std::size_t>(i);
    for (int j = i + 1; j < k; ++j) rhs_[at] -= h(i, j) * rhs_[static_cast<std::size_t>(j)];
    rhs_[at] /= h(i, i);
    x += rhs_[at] * v_[at];
  }
}

}  // namespace dda
