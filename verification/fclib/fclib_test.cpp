// Steps as frictional contact problems: no library of others is needed here.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "engine/scene/scene.h"
#include "engine/simulation/simulation.h"
#include "engine/solve/contact_solver.h"
#include "engine/solve/solve_problems.h"
#include "verification/fclib/every_status.h"
#include "verification/fclib/step_of_run.h"

namespace verify {
namespace {

// The engine balances forces to 1e-10 of the largest contact force; a residual divides by the softness of the contact,
// and gaps of blocks come out of a matrix whose numbers differ by 1e3.
constexpr double solved = 1e-8;

double number(std::mt19937& lot, double low, double high) {
  return low + (high - low) * static_cast<double>(lot()) / static_cast<double>(std::mt19937::max());
}

// Bonds in the base matrix, to a held block as well.
void tie(int a, int b, dda::HandMadeProblem& made) {
  const dda::Mat6 spring = 30 * dda::Mat6::Identity();
  made.base.diagonal(a) += spring;
  made.base.diagonal(b) += spring;
  made.base.add_coupling(b, a, -spring);
}

// A pile of three blocks on a held floor: contacts at places by lot, some open, some pressed at the start.
dda::HandMadeProblem random_pile(unsigned seed) {
  std::mt19937 lot(seed);
  dda::HandMadeProblem made(4, {{0, 1}, {1, 2}, {2, 3}, {0, 2}, {0, 3}, {1, 3}});
  const double slide = lot() % 2 == 0 ? 0 : 0.05;  // of the floor
  made.hold(0, (dda::Vec6() << slide, 0, 0, 0, 0, 0).finished());
  for (int k = 0; k < 4; ++k) {
    const int b = 1 + k % 3;
    const int a = static_cast<int>(lot() % static_cast<unsigned>(b));
    const dda::Vec2 arm_a(number(lot, -0.5, 0.5), 0.5), arm_b(number(lot, -0.5, 0.5), -0.5);
    const std::size_t i = made.add_contact(a, b, arm_a, arm_b, number(lot, 0, 0.9));
    const double pressed = std::min(0.0, number(lot, -0.02, 0.01));
    const double bound = made.strengths[i].friction * made.normal_spring * -pressed;
    made.states[i].gap(0) = pressed < 0 ? pressed : number(lot, 0, 0.02);
    made.states[i].force(0) = made.normal_spring * pressed;
    made.states[i].force(1) = number(lot, -bound, bound);
    made.states[i].gap(1) = made.states[i].force(1) / made.shear_spring;
  }
  for (int block = 1; block < 4; ++block)
    made.rhs.segment<3>(6 * block) << number(lot, -6, 6), number(lot, -12, 0), number(lot, -2, 2);
  made.factor = lot() % 2 == 0 ? 1 : 0.8;
  tie(0, 1, made);
  tie(1, 3, made);
  return made;
}

struct Solved {
  dda::Status status;
  Eigen::VectorXd forces;
};

Solved solve(const dda::StepProblem& step) {
  dda::Costs costs;
  dda::ContactSolver solver(costs);
  solver.begin(step.base, dda::SolverKind::dense, std::numeric_limits<double>::infinity());
  const dda::Status status = solver.solve(step).status;
  return {status, forces_of(step, solver.contacts())};
}

double nearest(const std::vector<Eigen::VectorXd>& answers, const Eigen::VectorXd& forces) {
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::VectorXd& answer : answers) least = std::min(least, (answer - forces).cwiseAbs().maxCoeff());
  return least;
}

TEST(Fclib, AnswersOfTheEngineAreAmongAllThereAre) {
  int with_force = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const dda::HandMadeProblem made = random_pile(seed);
    const LocalFrictionProblem local = local_problem(friction_problem(made.problem()));
    const Solved engine = solve(made.problem());
    ASSERT_EQ(engine.status, dda::Status::ok);
    EXPECT_LE(residual(local, engine.forces), solved);
    const std::vector<Eigen::VectorXd> answers = every_answer(local);
    ASSERT_FALSE(answers.empty());
    const double scale = engine.forces.cwiseAbs().maxCoeff();
    EXPECT_LE(nearest(answers, engine.forces), solved * std::max(scale, 1.0));
    with_force += scale > 0 ? 1 : 0;
  }
  EXPECT_GE(with_force, 250);
}

TEST(Fclib, ResidualTellsWhatIsNoAnswer) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(seed);
    const dda::HandMadeProblem made = random_pile(seed);
    const LocalFrictionProblem local = local_problem(friction_problem(made.problem()));
    const std::vector<Eigen::VectorXd> answers = every_answer(local);
    for (const Eigen::VectorXd& answer : answers) {
      EXPECT_LE(residual(local, answer), 1e-9);
      Eigen::VectorXd other = answer;
      other(0) += 0.01 * std::max(1.0, answer.cwiseAbs().maxCoeff());
      EXPECT_GE(residual(local, other), 1e-4);
    }
  }
}

TEST(Fclib, ThereAndBackIsTheSameProblem) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    const dda::HandMadeProblem made = random_pile(seed);
    const FrictionProblem there = friction_problem(made.problem());
    const OwnedStep back = step_of(there);
    const FrictionProblem again = friction_problem(back.problem());
    EXPECT_TRUE(Eigen::MatrixXd(there.mass) == Eigen::MatrixXd(again.mass));
    EXPECT_TRUE(Eigen::MatrixXd(there.directions) == Eigen::MatrixXd(again.directions));
    EXPECT_TRUE(there.force == again.force);
    EXPECT_TRUE(there.gaps == again.gaps);
    EXPECT_TRUE(there.friction == again.friction);
    EXPECT_LE((there.compliance - again.compliance).cwiseAbs().maxCoeff(), 1e-15 * there.compliance.maxCoeff());
    const Solved engine = solve(back.problem());
    ASSERT_EQ(engine.status, dda::Status::ok);
    EXPECT_LE(residual(local_problem(there), engine.forces), solved);
  }
}

TEST(Fclib, StiffSpringsStandForContactsWithout) {
  FrictionProblem rigid = friction_problem(dda::block_on_floor({3, -10}).problem());
  rigid.compliance.setZero();
  const Solved engine = solve(step_of(rigid, 6, 1e8).problem());
  ASSERT_EQ(engine.status, dda::Status::ok);
  EXPECT_NEAR(engine.forces(0), 10, 1e-6);  // springs of 1e8: off by 1e-8 of it; tangents point left
  EXPECT_NEAR(engine.forces(1), 3, 1e-6);
}

TEST(Fclib, WhatTheFormHasNotIsRefused) {
  const auto refuses = [](auto change) {
    dda::HandMadeProblem made = dda::block_on_floor({1, -1});
    change(made);
    EXPECT_THROW(static_cast<void>(friction_problem(made.problem())), std::invalid_argument);
  };
  refuses([](auto& made) { made.rule.conserves_energy = true; });
  refuses([](auto& made) { made.rule.sticks = true; });
  refuses([](auto& made) { made.elements[0].dashpot(0) = 1; });
  refuses([](auto& made) { made.strengths[0].dilation = 0.1; });
  refuses([](auto& made) { made.states[0].broken = {false, false}; });
  refuses([](auto& made) { made.links.emplace_back(); });
}

TEST(Fclib, StepsOfARunAreSuchProblems) {
  dda::Simulation run(dda::parse_scene(R"({
    "dda": 1,
    "materials": {"brick": {"density": 1900, "young": 10e9, "poisson": 0.2}},
    "joints": {"default": {"friction_angle": "31 deg", "law": "classical"}},
    "blocks": [{"polygon": {"name": "floor", "vertices": [[-1, -1], [5, -1], [5, 0], [-1, 0]]}},
               {"grid": {"columns": 4, "rows": 5, "pattern": "running_bond", "block_width": 1, "block_height": 0.5}}],
    "gravity": 9.81, "fixed": ["floor"], "steps": {"dt": 1e-3, "duration": 1}})",
                                       "scene.json"));
  for (int i = 0; i < 8; ++i) {
    const OwnedStep step = next_step(run);
    const Solved engine = solve(step.problem());
    ASSERT_EQ(engine.status, dda::Status::ok);
    const double left = residual(local_problem(friction_problem(step.problem())), engine.forces);
    EXPECT_LE(left, solved) << "step " << i;
    ASSERT_EQ(run.step(), dda::Status::ok);
  }
}

}  // namespace
}  // namespace verify
