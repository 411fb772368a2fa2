// For tests: step problems written by hand, with no model behind them.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "engine/solve/contact_solver.h"

namespace dda {

inline constexpr double unlimited = std::numeric_limits<double>::infinity();

// Blocks of 1 m2 whose base matrix is diagonal: `inertia` (mass over dt squared) for displacements and rotation, and a
// stiff elasticity for the strains. All of it owned here, so that a StepProblem can refer to it.
struct HandMadeProblem {
  explicit HandMadeProblem(int blocks, std::vector<std::pair<int, int>> couplings, double inertia = 100)
      : base(blocks, std::move(couplings)),
        rhs(Eigen::VectorXd::Zero(6 * blocks)),
        guess(Eigen::VectorXd::Zero(6 * blocks)),
        areas(static_cast<std::size_t>(blocks), 1.0) {
    for (int i = 0; i < blocks; ++i) {
      base.diagonal(i).setIdentity();
      base.diagonal(i) *= inertia;
      base.diagonal(i).bottomRightCorner<3, 3>() *= 1e3;
    }
  }

  // A corner of block b, at `arm_b` from its centroid, above an edge of block a whose normal is +y. Tangential gaps are
  // counter-clockwise from the normal, to the left.
  std::size_t add_contact(int a, int b, const Vec2& arm_a, const Vec2& arm_b, double friction) {
    InterfaceElement element;
    element.block_a = a;
    element.block_b = b;
    element.stiffness << normal_spring, shear_spring, 0, 0;
    element.rows_a.setZero();
    element.rows_b.setZero();
    const Mat2 axes = (Mat2() << 0, 1, -1, 0).finished();
    element.rows_a.topRows<2>() = -axes * displacement_rows(arm_a);
    element.rows_b.topRows<2>() = axes * displacement_rows(arm_b);
    elements.push_back(element);
    strengths.push_back({.friction = friction});
    states.emplace_back().broken = {true, true};
    places.push_back(static_cast<int>(places.size()));
    return elements.size() - 1;
  }

  void hold(int block, const Vec6& increment) {
    held.blocks.push_back(block);
    held.increments.push_back(increment);
    held.place.assign(areas.size(), -1);
    for (std::size_t i = 0; i < held.blocks.size(); ++i)
      held.place[static_cast<std::size_t>(held.blocks[i])] = static_cast<int>(i);
    held.move = held.move || !increment.isZero(0);
  }

  [[nodiscard]] StepProblem problem() const {
    return {.base = base,
            .base_version = version,
            .rhs = rhs,
            .guess = guess,
            .factor = factor,
            .areas = areas,
            .asked_balance = asked_balance,
            .contacts = {places, elements, strengths, states, rule},
            .bolts = links,
            .held = held,
            .dilates = false,
            .max_passes = max_passes,
            .to_the_end = to_the_end};
  }

  static constexpr double normal_spring = 400;
  static constexpr double shear_spring = 300;

  BlockMatrix base;
  Eigen::VectorXd rhs, guess;
  std::vector<double> areas;
  std::vector<double> asked_balance;
  std::vector<int> places;
  std::vector<InterfaceElement> elements;
  std::vector<EndStrength> strengths;
  std::vector<InterfaceState> states;
  std::vector<LinkElement> links;
  HeldUnknowns held;
  ContactRule rule;
  double factor = 1;
  int max_passes = 200;
  bool to_the_end = true;
  std::uint64_t version = 1;
};

// A block of unit size on a held floor, touching it under its centroid; `push` acts on it (right, up).
inline HandMadeProblem block_on_floor(const Vec2& push, double friction = 0.5) {
  HandMadeProblem made(2, {{0, 1}});
  made.hold(0, Vec6::Zero());
  made.add_contact(0, 1, Vec2::Zero(), Vec2::Zero(), friction);
  made.rhs.segment<2>(6) = push;
  return made;
}

inline void press(double gap, InterfaceState& state) {
  state.gap(0) = gap;
  state.force(0) = HandMadeProblem::normal_spring * gap;
}

inline double drawn_between(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution(low, high)(random);
}

// A heap of blocks, each with some contacts to those below; the first is held. What opens takes its load elsewhere, and
// friction is more than Coulomb's law has a sure answer for.
inline HandMadeProblem heap(unsigned seed) {
  std::mt19937_64 random(seed);
  const int blocks = 12;
  std::vector<std::pair<int, int>> pairs;
  for (int b = 1; b < blocks; ++b) {
    pairs.emplace_back(b - 1, b);
    if (b > 1) pairs.emplace_back(b - 2, b);
  }
  HandMadeProblem made(blocks, pairs, 0.1);
  made.hold(0, Vec6::Zero());
  for (const auto& [a, b] : pairs) {
    for (int end = 0; end < 2; ++end) {
      const auto arm = [&] { return Vec2(drawn_between(random, -0.5, 0.5), drawn_between(random, -0.5, 0.5)); };
      const std::size_t k = made.add_contact(a, b, arm(), arm(), drawn_between(random, 0.2, 2));
      press(drawn_between(random, -0.2, 0.1), made.states[k]);
      made.states[k].force(0) = std::min(0.0, made.states[k].force(0));
    }
  }
  for (int b = 1; b < blocks; ++b)
    made.rhs.segment<2>(6 * b) = Vec2(drawn_between(random, -50, 50), drawn_between(random, -100, 30));
  made.rule.capacity_is_given = true;
  return made;
}

}  // namespace dda
