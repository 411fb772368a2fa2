#include "verification/exact/block_row.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace exact {
namespace {

using Vector = Eigen::ArrayXd;

// Unknowns: centroids, then strains; state: unknowns, then their rates.
class Equations {
 public:
  explicit Equations(const BlockRow& row) : row_(row), blocks_(static_cast<Eigen::Index>(row.velocity.size())) {}

  [[nodiscard]] double gap(const Vector& state, Eigen::Index i) const {
    const double stretch = state(blocks_ + i) + state(blocks_ + i + 1);
    return row_.gaps[static_cast<std::size_t>(i)] + state(i + 1) - state(i) - row_.length / 2 * stretch;
  }

  // Which contacts are closed, 1 or 0.
  [[nodiscard]] Vector closed(const Vector& state) const {
    Vector closed(blocks_ - 1);
    for (Eigen::Index i = 0; i + 1 < blocks_; ++i) closed(i) = gap(state, i) < 0 ? 1 : 0;
    return closed;
  }

  // With given contacts closed, whatever their gaps: linear.
  [[nodiscard]] Vector rate(const Vector& state, const Vector& closed) const {
    const Eigen::Index n = blocks_;
    const double half = row_.length / 2;
    Vector rate(4 * n);
    rate.head(2 * n) = state.tail(2 * n);
    auto forces = rate.tail(2 * n);
    forces.head(n).setZero();
    forces.tail(n) = -row_.axial_stiffness * row_.length * state.segment(n, n);
    for (Eigen::Index i = 0; i + 1 < n; ++i) {
      const double push = -closed(i) * row_.spring * gap(state, i);
      forces(i) -= push;
      forces(i + 1) += push;
      forces(n + i) -= half * push;
      forces(n + i + 1) -= half * push;
    }
    forces.head(n) /= row_.mass;
    forces.tail(n) /= strain_mass();
    return rate;
  }

  [[nodiscard]] double strain_mass() const { return row_.mass * row_.length * row_.length / 12; }

  // rad/s, above every frequency of the row.
  [[nodiscard]] double highest_frequency() const {
    return std::sqrt((row_.axial_stiffness * row_.length + row_.spring * row_.length * row_.length) / strain_mass() +
                     4 * row_.spring / row_.mass);
  }

  [[nodiscard]] Vector start() const {
    Vector state = Vector::Zero(4 * blocks_);
    for (Eigen::Index i = 0; i < blocks_; ++i) state(2 * blocks_ + i) = row_.velocity[static_cast<std::size_t>(i)];
    return state;
  }

  [[nodiscard]] BlockRowState result(const Vector& state) const {
    BlockRowState result;
    const Eigen::Index n = blocks_;
    for (Eigen::Index i = 0; i < n; ++i) {
      result.position.push_back(state(i));
      result.velocity.push_back(state(2 * n + i));
    }
    result.vibration = (row_.axial_stiffness * row_.length * state.segment(n, n).square().sum() +
                        strain_mass() * state.tail(n).square().sum()) /
                       2;
    return result;
  }

 private:
  const BlockRow& row_;
  Eigen::Index blocks_;
};

Vector runge_kutta(const Equations& equations, const Vector& state, const Vector& closed, double dt) {
  const Vector first = equations.rate(state, closed);
  const Vector second = equations.rate(state + dt / 2 * first, closed);
  const Vector third = equations.rate(state + dt / 2 * second, closed);
  const Vector fourth = equations.rate(state + dt * third, closed);
  return state + dt / 6 * (first + 2 * second + 2 * third + fourth);
}

// Longest step, up to dt, in which no contact opens or closes but at its very end.
double step_to_change(const Equations& equations, const Vector& state, const Vector& closed, double dt) {
  const auto unchanged = [&](double step) {
    return (equations.closed(runge_kutta(equations, state, closed, step)) == closed).all();
  };
  if (unchanged(dt)) return dt;
  double low = 0;
  double high = dt;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (unchanged(middle) ? low : high) = middle;
  }
  return high;
}

}  // namespace

BlockRowState move_block_row(const BlockRow& row, double end) {
  constexpr double phase_per_step = 0.01;  // rad
  const Equations equations(row);
  const double longest = phase_per_step / equations.highest_frequency();
  Vector state = equations.start();
  for (double t = 0; t < end;) {
    const Vector closed = equations.closed(state);
    const double dt = step_to_change(equations, state, closed, std::min(longest, end - t));
    state = runge_kutta(equations, state, closed, dt);
    t += dt;
  }
  return equations.result(state);
}

}  // namespace exact
